// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/label/label_store.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/core/label/other_program.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {

/// A folder for one labels.gpkg, which ada makes and bob opens again.
class LabelFile : public testing::Test {
 protected:
  [[nodiscard]] LabelStore made(const LabelGrid& grid = test_grid(40, 30)) const {
    return taken(LabelStore::create(path_, test_plane(), grid, "ada"));
  }
  [[nodiscard]] LabelStore opened(LabelAccess access = LabelAccess::kWriteWhereFree) const {
    return taken(LabelStore::open(path_, "bob", access));
  }
  /// Commits what somebody might do, and says what the document was before each step.
  static std::vector<LabelDocument> work(LabelStore& store,
                                         std::uint64_t seed,
                                         std::uint32_t first,
                                         std::uint32_t steps) {
    std::vector<LabelDocument> before;
    for (std::uint32_t step = first; step < first + steps; ++step) {
      before.push_back(store.document());
      const auto done = store.commit(random_edit(store.document(), seed, step));
      EXPECT_TRUE(done) << error_text(done);
    }
    return before;
  }
  /// What another program does to it, and what it finds in it.
  void run_elsewhere(const std::string& sql) const { OtherProgram(path_).run(sql); }
  [[nodiscard]] std::string value_elsewhere(const std::string& sql) const {
    return OtherProgram(path_).value(sql);
  }

  ScratchFolder scratch_;
  std::filesystem::path path_ = scratch_.path() / "labels.gpkg";

 private:
  static LabelStore taken(Result<LabelStore> store) {
    if (!store) throw std::runtime_error(error_text(store));
    return std::move(*store);
  }
};

}  // namespace nadir
