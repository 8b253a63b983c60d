// SPDX-License-Identifier: Apache-2.0
#include "core/base/bystanders.h"

#include <gmock/gmock.h>
#include <unistd.h>

#include "tests/support/dead_process.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace bystanders_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

TEST(Bystanders, AreNamedAfterTheOutputAndTheProcess) {
  EXPECT_EQ(bystander_of("out/run.nadir", ".partial-"),
            fs::path("out/run.nadir.partial-" + std::to_string(::getpid())));
  EXPECT_EQ(bystander_of("run.nadir", ".earlier-", 3),
            fs::path("run.nadir.earlier-" + std::to_string(::getpid()) + "-3"));
  EXPECT_THROW((void)bystander_of("run.nadir", ".earlier-", 0), std::logic_error);
}

TEST(Bystanders, OfADeadProcessAreAbandonedAndThoseOfTheLivingAreNot) {
  const ScratchFolder folder;
  const fs::path target = folder.path() / "run.nadir";
  const std::string dead = "run.nadir.partial-" + std::to_string(dead_process());
  const fs::path left = folder.file(dead, "half");
  (void)folder.file("run.nadir.partial-" + std::to_string(::getpid()), "half");
  (void)folder.file("run.nadir.partial-1", "half");  // the first process always lives
  EXPECT_THAT(abandoned_bystanders(target, ".partial-"), ElementsAre(left));
  EXPECT_THAT(abandoned_bystanders(target, ".earlier-"), IsEmpty());
  EXPECT_THAT(abandoned_bystanders(folder.path() / "run", ".partial-"), IsEmpty());
}

TEST(Bystanders, OfOneProcessAreFoundWhateverTheirNumber) {
  const ScratchFolder folder;
  const std::string dead = "run.nadir.earlier-" + std::to_string(dead_process());
  const fs::path first = folder.file(dead, "the first");
  const fs::path second = folder.file(dead + "-2", "the second");
  const fs::path twelfth = folder.file(dead + "-12", "the twelfth");
  (void)folder.file(bystander_of("run.nadir", ".earlier-", 2).string(), "of a living process");
  EXPECT_THAT(abandoned_bystanders(folder.path() / "run.nadir", ".earlier-"),
              testing::UnorderedElementsAre(first, second, twelfth));
}

TEST(Bystanders, AreOnlyNamesThatEndWithAProcess) {
  const ScratchFolder folder;
  const std::string dead = std::to_string(dead_process());
  for (const char* name : {"run.nadir.partial-", "run.nadir.partial-notes", "run.nadir.partial--5",
                           "run.nadir.partial-0", "run.nadir.partial-99999999999999999999"}) {
    (void)folder.file(name, "somebody's own");
  }
  for (const char* end : {"b", "-", "-1", "-0", "--2", "-2b", "-journal", "2-"}) {
    (void)folder.file("run.nadir.partial-" + dead + end, "somebody's own");
  }
  (void)folder.file("my-run.nadir.partial-" + dead, "of another output");
  EXPECT_THAT(abandoned_bystanders(folder.path() / "run.nadir", ".partial-"), IsEmpty());
}

TEST(Bystanders, OfAFolderThatIsNotThereAreNone) {
  const ScratchFolder folder;
  EXPECT_THAT(abandoned_bystanders(folder.path() / "none" / "run.nadir", ".partial-"), IsEmpty());
}

}  // namespace bystanders_test
}  // namespace nadir
