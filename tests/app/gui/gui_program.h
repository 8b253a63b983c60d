// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "app/gui/child_process.h"
#include "tests/app/drawn_run.h"

namespace nadir {

/// How a program ended, and what it said.
struct Ending {
  int status = -1;
  std::string words;
};

/// The program in a process of its own, with a flight over the bundled town and a run of it in a folder "demo".
class GuiProgram : public DrawnRun {
 protected:
  /// A flight over the bundled town and its run, made once for all tests; with small images, which take a quarter of the
  /// time.
  static void SetUpTestSuite() {
    if (made_) return;
    made_ = std::make_unique<ScratchFolder>();
    const std::string folder = (made_->path() / "demo").string();
    std::filesystem::create_directory(folder);
    ASSERT_EQ(run({"simulate", NADIR_PROVING_GROUND, "--image-width", "320", "--image-height",
                   "240", "--out", folder + "/flight", "--quiet"})
                  .status,
              0);
    ASSERT_EQ(run({"localise", folder + "/flight", "--map", NADIR_PROVING_GROUND, "--out",
                   folder + "/run.nadir", "--quiet"})
                  .status,
              0);
  }
  /// Copied, for a rerun is written beside it.
  GuiProgram() {
    std::filesystem::copy(made_->path() / "demo", path("demo"),
                          std::filesystem::copy_options::recursive);
  }

  static Ending run(const std::vector<std::string>& arguments) {
    auto process = ChildProcess::start(NADIR_PROGRAM, arguments);
    if (!process) return {-1, process.error().message};
    Ending ending;
    for (auto status = process->poll();; status = process->poll()) {
      if (status) {
        ending.status = *status;
        break;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    for (const std::string& line : process->lines()) ending.words += line + "\n";
    return ending;
  }
  Ending gui(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"gui", "--config", path("config")});
    return run(arguments);
  }
  Ending script(const std::string& text, std::vector<std::string> arguments = {}) {
    arguments.insert(arguments.end(), {"--script", scratch_.file("script.txt", text).string()});
    return gui(std::move(arguments));
  }

 private:
  static inline std::unique_ptr<ScratchFolder> made_;
};

}  // namespace nadir
