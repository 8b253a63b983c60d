// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <chrono>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/session/step_cache.h"
#include "tests/core/run/recorded_run.h"
#include "tests/support/scratch_folder.h"

namespace nadir {

/// A recorded run whose steps a cache decodes.
class StepCacheOfARun : public ::testing::Test {
 protected:
  [[nodiscard]] std::filesystem::path path() const { return scratch_.path() / "R.nadir"; }
  [[nodiscard]] std::shared_ptr<const RunDocument> record(int steps, int particles) const {
    record_run(path(), steps, particles);
    return load();
  }
  [[nodiscard]] std::shared_ptr<const RunDocument> load() const {
    auto run = RunDocument::load(path());
    if (!run) throw std::runtime_error(run.error().message);
    return *run;
  }
  static std::vector<std::size_t> decoded(const StepCache& cache, std::size_t count) {
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < count; ++i) {
      if (cache.step(i)) indices.push_back(i);
    }
    return indices;
  }
  static void settle(const StepCache& cache) {
    ASSERT_TRUE(cache.wait_until_idle(std::chrono::seconds(60)));
  }

  ScratchFolder scratch_;
};

}  // namespace nadir
