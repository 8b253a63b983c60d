// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace nadir {

/// The runs that a session is writing, listed in a file of its own as long as it writes them, so that a later start can
/// offer what a killed program has left of them. Sessions do not touch each other's lists.
class WritingList {
 public:
  /// @param folder  The user's; empty: nothing is kept.
  explicit WritingList(std::filesystem::path folder) : folder_(std::move(folder)) {}
  /// Lists these and no others. Without any the file goes. @errors kIo.
  [[nodiscard]] Result<void> keep(const std::vector<std::string>& runs);

 private:
  std::filesystem::path folder_, file_;  ///< No file yet where that is empty.
  std::vector<std::string> kept_;
};

struct ListedRuns {
  std::vector<std::string>
      incomplete;  ///< Of all lists in the folder; those too that are not there.
  std::vector<std::string>
      unfinished;  ///< Those that are there, not whole, and that nobody is writing any more.
};
/// Reads all lists. Those of programs that are no more go, once nothing on them is unfinished.
[[nodiscard]] ListedRuns listed_runs(const std::filesystem::path& folder);
/// Takes a run off all lists, so that it is not offered again.
void take_off_lists(const std::filesystem::path& folder, const std::string& run);

}  // namespace nadir
