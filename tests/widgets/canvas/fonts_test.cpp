// SPDX-License-Identifier: Apache-2.0
#include "widgets/canvas/fonts.h"

#include <fontconfig/fontconfig.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cstdlib>

#include "tests/support/scratch_folder.h"

namespace nadir {
namespace fonts_test {

namespace fs = std::filesystem;

using ::testing::HasSubstr;

std::string outcome_text() {
  const auto fonts = check_fonts();
  if (!fonts) return "error: " + fonts.error().message;
  std::string text;
  for (const std::string& sentence : *fonts) text += sentence + "\n";
  return text;
}

/// What check_fonts() says in a process of its own whose fonts are those of one folder.
std::string fonts_of(const fs::path& folder) {
  const ScratchFolder scratch;
  const fs::path configuration =
      scratch.file("fonts.conf",
                   "<?xml version=\"1.0\"?>\n<!DOCTYPE fontconfig SYSTEM \"fonts.dtd\">\n"
                   "<fontconfig><dir>" +
                       folder.string() + "</dir><cachedir>" + (scratch.path() / "cache").string() +
                       "</cachedir></fontconfig>\n");
  std::array<int, 2> pipe{};
  if (::pipe(pipe.data()) != 0) throw std::runtime_error("no pipe for a test");
  const pid_t child = ::fork();
  if (child == 0) {
    ::setenv("FONTCONFIG_FILE", configuration.c_str(), 1);  // NOLINT(concurrency-mt-unsafe): alone
    FcInitReinitialize();
    const std::string text = outcome_text();
    const bool is_written = ::write(pipe[1], text.data(), text.size()) >= 0;
    ::_exit(is_written ? 0 : 1);
  }
  ::close(pipe[1]);
  std::string text;
  std::array<char, 256> part{};
  for (ssize_t got = 0; (got = ::read(pipe[0], part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(got));
  }
  ::close(pipe[0]);
  int status = -1;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
  return text;
}

/// A file of a family that is installed here; empty where it is not.
fs::path file_of(const char* family) {
  FcPattern* const wanted = FcNameParse(reinterpret_cast<const FcChar8*>(family));
  FcConfigSubstitute(nullptr, wanted, FcMatchPattern);
  FcDefaultSubstitute(wanted);
  FcResult outcome = FcResultNoMatch;
  FcPattern* const match = FcFontMatch(nullptr, wanted, &outcome);
  FcChar8* file = nullptr;
  fs::path path;
  if (match != nullptr && FcPatternGetString(match, FC_FILE, 0, &file) == FcResultMatch) {
    path = reinterpret_cast<const char*>(file);
  }
  if (match != nullptr) FcPatternDestroy(match);
  FcPatternDestroy(wanted);
  return path;
}

TEST(Fonts, AreAllThereOnAMachineWithThePackages) { EXPECT_EQ(outcome_text(), ""); }

TEST(Fonts, ThatAreNotThereAtAllAreAnErrorThatNamesThePackages) {
  const ScratchFolder empty;
  EXPECT_EQ(fonts_of(empty.path()),
            "error: fonts: none is installed, so no text can be drawn; install fonts-inter and "
            "fonts-jetbrains-mono");
}

TEST(Fonts, ThatAreReplacedAreNamedWithTheirPackageAndWhatIsDrawn) {
  const fs::path inter = file_of("Inter");
  ASSERT_FALSE(inter.empty());
  const ScratchFolder folder;
  fs::copy_file(inter, folder.path() / inter.filename());
  EXPECT_EQ(fonts_of(folder.path()),
            "font JetBrains Mono is not installed (package fonts-jetbrains-mono), so Inter is "
            "drawn\n");
  const fs::path mono = file_of("JetBrains Mono");
  fs::copy_file(mono, folder.path() / mono.filename());
  EXPECT_EQ(fonts_of(folder.path()), "");
  fs::remove(folder.path() / inter.filename());
  EXPECT_THAT(fonts_of(folder.path()),
              HasSubstr("font Inter is not installed (package fonts-inter), so JetBrains Mono"));
}

}  // namespace fonts_test
}  // namespace nadir
