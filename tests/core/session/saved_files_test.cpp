// SPDX-License-Identifier: Apache-2.0
#include "core/session/saved_files.h"

#include <gmock/gmock.h>

#include "core/base/staged_output.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace saved_files_test {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;
using testing::Key;
using testing::UnorderedElementsAre;

TEST(MergedPreferences, TakeOfASessionWhatItHasChanged) {
  Preferences before;
  before.memory_megabytes = 100;
  before.layouts = {{"old", default_layout()}, {"both", default_layout()}};
  Preferences now = before, there = before;
  now.appearance.theme = LightOrDark::kLight;
  now.layouts.erase("old");
  now.layouts["mine"] = default_layout();
  there.appearance.scale = 2.0;
  there.memory_megabytes = 200;
  there.layouts["both"].left_pt = 500.0;
  there.layouts["theirs"] = default_layout();
  const Preferences merged = merged_preferences(there, before, now);
  EXPECT_EQ(merged.appearance, (Appearance{LightOrDark::kLight, 2.0, false}));
  EXPECT_EQ(merged.memory_megabytes, 200);
  EXPECT_THAT(merged.layouts, UnorderedElementsAre(Key("both"), Key("mine"), Key("theirs")));
  EXPECT_EQ(merged.layouts.at("both").left_pt, 500.0);
  EXPECT_EQ(merged_preferences(there, before, before), there);
  EXPECT_EQ(merged_preferences(before, before, now), now);
}

TEST(MergedPreferences, PutWhatWasOpenedLatelyInFront) {
  const auto merged = [](const std::vector<std::string>& there,
                         const std::vector<std::string>& before,
                         const std::vector<std::string>& now) {
    Preferences a, b, c;
    a.recents = there;
    b.recents = before;
    c.recents = now;
    return merged_preferences(a, b, c).recents;
  };
  EXPECT_THAT(merged({"x", "a", "b"}, {"a", "b"}, {"c", "a", "b"}),
              ElementsAre("c", "x", "a", "b"));
  EXPECT_THAT(merged({"x", "a", "b"}, {"a", "b"}, {"b", "a"}), ElementsAre("b", "x", "a"))
      << "opened again";
  EXPECT_THAT(merged({"x", "a", "b"}, {"a", "b"}, {"b"}), ElementsAre("x", "b")) << "taken out";
  EXPECT_THAT(merged({"x"}, {}, {"c"}), ElementsAre("c", "x"));
  EXPECT_THAT(merged({}, {"a"}, {"a"}), IsEmpty()) << "another session has taken it out";
  std::vector<std::string> many;
  for (std::size_t i = 0; i < kMostRecents; ++i) many.push_back(std::to_string(i));
  EXPECT_EQ(merged(many, many, {"new"}).size(), 1U);
  auto more = many;
  more.insert(more.begin(), "new");
  EXPECT_EQ(merged(many, many, more).size(), kMostRecents);
}

class SavedFiles : public testing::Test {
 protected:
  [[nodiscard]] fs::path file(const char* name) const { return scratch_.path() / "config" / name; }
  void save(const Savings& savings) {
    const auto saved = save_files(scratch_.path() / "config", savings);
    ASSERT_TRUE(saved) << error_text(saved);
  }
  ScratchFolder scratch_;
};

TEST_F(SavedFiles, AreOnlyThoseThatThereIsSomethingFor) {
  save({"version = 1\n", std::nullopt, {}});
  EXPECT_EQ(read_text_file(file(kSessionFile)).value(), "version = 1\n");
  EXPECT_FALSE(fs::exists(file(kPreferencesFile)));
  Preferences now;
  now.memory_megabytes = 99;
  save({std::nullopt, now, {}});
  EXPECT_EQ(
      parse_preferences(read_text_file(file(kPreferencesFile)).value(), "p")->memory_megabytes, 99);
}

TEST_F(SavedFiles, ReplaceWhatIsDamagedAndLeaveWhatIsNewer) {
  fs::create_directory(scratch_.path() / "config");
  for (const auto& [text, stays] :
       {std::pair("damaged = ", false), std::pair("version = 9\n", true)}) {
    ASSERT_TRUE(write_text_file(file(kSessionFile), text));
    ASSERT_TRUE(write_text_file(file(kPreferencesFile), text));
    save({"version = 1\n", Preferences(), {}});
    EXPECT_EQ(read_text_file(file(kSessionFile)).value() == text, stays);
    EXPECT_EQ(read_text_file(file(kPreferencesFile)).value() == text, stays);
  }
}

}  // namespace saved_files_test
}  // namespace nadir
