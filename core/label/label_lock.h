// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/label/named_file.h"

namespace nadir {

/// Keeps a second writer off a labelling document for as long as this object lives, by a small file beside it that says who
/// has it: NAME.lock. Private to this module. What counts is the lock of the open file, which a killed program loses, not that
/// the file is there; a file system without such locks is used without.
class LabelLock {
 public:
  /// What came of asking: a lock, or who has it.
  struct Outcome;

  /// @param holder  What others are told: "ada on roof since 2026-05-01T12:00:00Z". @errors kIo: the file cannot be made, as in
  /// a folder that cannot be written.
  [[nodiscard]] static Result<Outcome> take(const std::filesystem::path& document,
                                            const std::string& holder);
  /// Who has it now, as the lock itself says and not the file, which a killed program leaves; nothing where nobody has.
  [[nodiscard]] static std::optional<std::string> holder(const std::filesystem::path& document);
  LabelLock(LabelLock&& other) noexcept;
  LabelLock& operator=(LabelLock&& other) noexcept;
  ~LabelLock();  ///< Removes the file.

  /// False once somebody has removed the file: the next who asks makes another one, and gets it.
  [[nodiscard]] bool is_held() const { return file_.has_its_name(); }

 private:
  LabelLock(int descriptor, NamedFile file) : descriptor_(descriptor), file_(std::move(file)) {}
  int descriptor_;
  NamedFile file_;
};

struct LabelLock::Outcome {
  std::optional<LabelLock> lock;
  std::string holder;  ///< Where there is no lock; may be empty.
};

}  // namespace nadir
