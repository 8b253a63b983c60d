// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <stop_token>
#include <string>
#include <thread>

#include "core/base/result.h"
#include "core/label/named_file.h"

namespace nadir {

/// Brings what was committed to the disk, in a thread of its own, so that nobody who commits waits for one. Private to this
/// module. What a program that is killed has committed is safe without it; this is for power cuts. Soon after a commit it
/// waits for the disk to have the file of changes (NAME-wal), and where that has grown large it carries them over into the
/// document.
class LabelSync {
 public:
  /// @param document  In WAL mode, and kept so while this lives. Once its name stands for another file, that is left alone.
  explicit LabelSync(NamedFile document);
  ~LabelSync();  ///< Leaves what has not been brought yet to whoever closes the document.
  LabelSync(const LabelSync&) = delete;
  LabelSync& operator=(const LabelSync&) = delete;

  /// There is something new. Any thread.
  void note_commit();
  /// Waits until all that was noted is on the disk. @errors kIo: the disk fails, the file has lost its name.
  [[nodiscard]] Result<void> flush();

 private:
  void run(const std::stop_token& stop);
  [[nodiscard]] Result<void> bring() const;

  NamedFile document_;
  std::filesystem::path changes_;
  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::int64_t noted_ = 0, brought_ = 0;
  bool is_awaited_ = false;
  Result<void> outcome_;
  std::jthread thread_;  ///< Ends before the rest goes.
};

}  // namespace nadir
