// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <string>

#include "core/base/staged_output.h"
#include "tests/app/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"

namespace nadir {

/// A made-up drive along a street, to be drawn.
class DrawnRun : public testing::Test {
 protected:
  DrawnRun() {
    write_street(path("map"));
    write_drive(path("run.nadir"), path("map"), 12);
  }
  [[nodiscard]] std::string path(const std::string& name) const {
    return (scratch_.path() / name).string();
  }
  [[nodiscard]] bool exists(const std::string& name) const {
    return std::filesystem::exists(path(name));
  }
  [[nodiscard]] std::string bytes(const std::string& name) const {
    return read_text_file(path(name)).value();
  }
  /// `nadir figure` with a small page.
  [[nodiscard]] static ProgramOutput figure(std::vector<std::string> words) {
    words.insert(words.begin(), "figure");
    words.insert(words.end(), {"--size", "300"});
    return run_program(words);
  }

  ScratchFolder scratch_;
};

}  // namespace nadir
