// SPDX-License-Identifier: Apache-2.0
// What the window is for, one script a use: each is driven without a display, in a folder with a run.nadir, its flight, the
// map "town" and what it writes. Their pictures stay in the folder of NADIR_PICTURES, where that is set.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdlib>
#include <set>

#include "tests/app/gui/gui_program.h"

namespace nadir {
namespace gui_use_cases_test {

namespace fs = std::filesystem;

std::vector<std::string> scripts() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(NADIR_GUI_SCRIPTS)) {
    names.push_back(entry.path().stem().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

class UseCases : public GuiProgram, public testing::WithParamInterface<std::string> {
 protected:
  UseCases() : before_(fs::current_path()) {
    fs::current_path(path("demo"));
    fs::copy(NADIR_PROVING_GROUND, "town", fs::copy_options::recursive);
  }
  ~UseCases() override { fs::current_path(before_); }

  /// Pictures are told apart by the script's name in front.
  void keep_pictures() const {
    const char* const folder = std::getenv("NADIR_PICTURES");
    if (folder == nullptr) return;
    for (const auto& entry : fs::directory_iterator(path("demo"))) {
      if (entry.path().extension() != ".png") continue;
      fs::copy_file(entry.path(),
                    fs::path(folder) / (GetParam() + "-" + entry.path().filename().string()),
                    fs::copy_options::overwrite_existing);
    }
  }

 private:
  fs::path before_;
};

TEST_P(UseCases, GoAsTheirScriptsSay) {
  const Ending ended =
      gui({"--fresh", "--script", std::string(NADIR_GUI_SCRIPTS) + "/" + GetParam() + ".txt"});
  keep_pictures();
  EXPECT_EQ(ended.status, 0) << ended.words;
}

std::string test_name_of(const testing::TestParamInfo<std::string>& script) {
  std::string name = script.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Scripts, UseCases, testing::ValuesIn(scripts()), test_name_of);

TEST(UseCaseScripts, AreThereForEverythingThatTheWindowIsFor) {
  EXPECT_THAT(scripts(),
              testing::IsSupersetOf({"camera-topview-space", "export", "habits", "keyboard",
                                     "label", "localise-now", "map", "opening", "rerun",
                                     "side-by-side", "timeline", "why"}));
}

}  // namespace gui_use_cases_test
}  // namespace nadir
