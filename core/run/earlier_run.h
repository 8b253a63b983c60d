// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <utility>

#include "core/base/result.h"

namespace nadir::detail {

/// SQLite's journal of a run file, there only while a step is being written or where that was cut
/// short.
[[nodiscard]] inline std::filesystem::path journal_of(const std::filesystem::path& run) {
  return run.string() + "-journal";
}

/// Takes away a run and its journal; the journal first, for one that outlives its run would be rolled
/// back into the next file of the name.
void remove_run(const std::filesystem::path& run);

/// Whether a new run may begin under this name: its folder is there and writable, and what has the
/// name, if anything has, is a run that nobody is writing and no newer version of Nadir has written.
/// A damaged run counts as one, and so does an empty file, which a writer killed at birth leaves.
/// @errors kIo, kUnsupported (newer), kInvalidOptions (an empty name): "R.nadir: will not be
/// overwritten: ...", "R.nadir: is being written by another run".
[[nodiscard]] Result<void> check_run_output(const std::filesystem::path& path);

/// The run that a new one of its name replaces. It waits as `NAME.earlier-PID`, or
/// `NAME.earlier-PID-2` and so on where that name is taken, until somebody says what becomes of it;
/// a program that is killed says nothing, so it stays there.
class EarlierRun {
 public:
  /// Puts aside what has this name, whole: a half step that a killed writer left in it is taken back
  /// first, or its journal moves with it. A name that nothing has is no error.
  /// @errors as check_run_output; then nothing was moved.
  [[nodiscard]] static Result<EarlierRun> put_aside(const std::filesystem::path& path);

  [[nodiscard]] bool is_there() const { return !kept_.empty(); }
  /// Where it waits; empty where there was none.
  [[nodiscard]] const std::filesystem::path& path() const { return kept_; }
  /// Whether it reached its end, or holds more than so many steps. Not so where it is damaged.
  [[nodiscard]] bool is_worth_more_than(int steps) const;

  /// Takes it away. Nothing is left of it then.
  void remove();
  /// The same, and all that killed programs have put aside from this name: they were outlived by this
  /// one. Where there was none, one of them may be all that is left of somebody's work, so they stay.
  void remove_with_abandoned();
  /// Gives it its name back, unless something has that name; then it stays aside.
  void bring_back();

 private:
  EarlierRun(std::filesystem::path name, std::filesystem::path kept)
      : name_(std::move(name)), kept_(std::move(kept)) {}

  std::filesystem::path name_;
  std::filesystem::path kept_;
};

}  // namespace nadir::detail
