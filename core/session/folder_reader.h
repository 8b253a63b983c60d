// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/job.h"
#include "core/session/folder_listing.h"

namespace nadir {

/// Lists one folder after another in threads of their own, so that nobody waits for a disk. All calls from one thread.
class FolderReader {
 public:
  /// Of a disk that hangs, waits until it lets go.
  ~FolderReader();

  /// Takes over what has been read and begins with this folder, unless it is the one asked for last. Call it in every frame.
  /// @param folder  Absolute; empty: none, and what is being read is let go.
  void look(const std::filesystem::path& folder);

  /// Of the folder asked for last; null while it is read for the first time, or where that failed.
  [[nodiscard]] std::shared_ptr<const FolderListing> listing() const { return listing_; }
  /// Why that folder cannot be listed, in one sentence; empty: nothing failed.
  [[nodiscard]] const std::string& fault() const { return fault_; }
  [[nodiscard]] bool is_reading() const { return reading_.has_value(); }

 private:
  using Reading = Job<FolderListing, std::shared_ptr<const FolderListing>>;
  void begin();
  void take_over();

  std::filesystem::path folder_;
  std::shared_ptr<const FolderListing> listing_;
  std::string fault_;
  std::optional<Reading> reading_;
  std::vector<Reading> leaving_;  ///< Asked to stop; nobody waits for them before the end.
};

}  // namespace nadir
