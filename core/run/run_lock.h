// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "core/base/result.h"

namespace nadir::detail {

/// Keeps a second writer off a run file, for as long as this object lives; a killed program's lock
/// goes with it. Readers are not kept off: what is locked is one byte far behind the end of any
/// database, where neither they nor SQLite look.
class RunLock {
 public:
  /// Makes an empty file and locks it. @errors kIo: there is a file of this name, so another run has
  /// just begun; or it cannot be made.
  [[nodiscard]] static Result<RunLock> make(const std::filesystem::path& path);
  /// Locks a file that may be there; one that is missing or may not be written needs no lock.
  /// @errors kIo: "R.nadir: is being written by another run", also where the name has gone to another
  /// file meanwhile.
  [[nodiscard]] static Result<RunLock> hold(const std::filesystem::path& path);

  RunLock(RunLock&& other) noexcept;
  RunLock& operator=(RunLock&&) = delete;
  ~RunLock();

 private:
  explicit RunLock(int descriptor) : descriptor_(descriptor) {}
  [[nodiscard]] static Result<RunLock> lock(int descriptor, const std::filesystem::path& path);
  int descriptor_;
};

}  // namespace nadir::detail
