// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/desk/change_log.h"
#include "core/label/label_store.h"
#include "core/map/overhead_image.h"

namespace nadir {

class LabelCoverage;
class ObjectIndex;
class SnapIndex;

/// How a document is opened.
struct LabelOpening {
  LabelAccess access = LabelAccess::kWriteWhereFree;
  ImageOptions image = {};  ///< As find_label_place() takes them.
};

/// A labelling document at work, wherever it comes from (label_place.h), with what finds things in it and what counts its
/// cells. Looking writes nothing: a document that is not there yet lives in memory until the first edit, which makes the file.
/// All errors leave document and file as they were. One thread.
class LabelSheet {
 public:
  /// @param author  Who works, for the history. @errors as find_label_place() and LabelStore::open().
  [[nodiscard]] static Result<LabelSheet> open(const std::filesystem::path& named,
                                               const std::string& author,
                                               const LabelOpening& how = {});
  LabelSheet(LabelSheet&&) noexcept;
  LabelSheet& operator=(LabelSheet&&) noexcept;
  ~LabelSheet();

  [[nodiscard]] const std::filesystem::path& path() const;   ///< Of the document, there or not.
  [[nodiscard]] const std::filesystem::path& image() const;  ///< Picture below, or empty.
  [[nodiscard]] bool is_on_disk() const;
  /// Why it can only be read; empty where it can be edited.
  [[nodiscard]] const std::string& why_read_only() const;
  /// What the user should know about what was opened, each one sentence without full stop.
  [[nodiscard]] const std::vector<std::string>& notices() const;

  /// As it is now; until the next edit.
  [[nodiscard]] const LabelDocument& now() const;
  /// The same for whoever keeps it: never changes. Made anew only after an edit.
  [[nodiscard]] const std::shared_ptr<const LabelDocument>& document() const;
  /// Rises with every change of the document.
  [[nodiscard]] std::int64_t revision() const;
  [[nodiscard]] LabelChanges changed_since(std::int64_t revision) const;
  [[nodiscard]] const ObjectIndex& objects() const;
  [[nodiscard]] const SnapIndex& places() const;
  [[nodiscard]] const LabelCoverage& coverage() const;
  /// Counts up to so many tiles of what coverage() has not counted yet. @returns whether all are.
  bool count_more(int most_tiles);

  /// One edit, one step of the history, one transaction; an empty one is none. @errors as LabelStore::commit(), and those
  /// of making the file.
  [[nodiscard]] Result<void> commit(const LabelEdit& edit);
  /// Titles of the steps; nothing where there is nothing to undo or to do again.
  [[nodiscard]] std::optional<std::string> undo_title() const;
  [[nodiscard]] std::optional<std::string> redo_title() const;
  [[nodiscard]] Result<void> undo();
  [[nodiscard]] Result<void> redo();
  /// To any step of the history; 0: the empty document.
  [[nodiscard]] Result<void> go_to(std::int64_t step);
  /// Number of the step that it stands at; 0 before the first.
  [[nodiscard]] std::int64_t step() const;
  [[nodiscard]] Result<std::vector<LabelStep>> history(std::int64_t first, int count) const;
  /// As LabelStore::way(); a document that is not on disk has one step only, 0.
  [[nodiscard]] Result<std::vector<LabelEdit>> way(const LabelDocument& document,
                                                   std::int64_t from,
                                                   std::int64_t to) const;

  /// Takes over what other programs have written meanwhile; about once a second. A document that was opened for reading, or
  /// that was not there, is opened again, and can be edited from then on if nobody else has it. One whose file has lost its
  /// name stays as it is, and is told as an error.
  /// @returns what the user should know, or nothing. @errors as commit(); what lasts is said once.
  [[nodiscard]] Result<std::vector<std::string>> poll();

  /// Another program has replaced, moved or deleted the file: what is shown is all that is left until save_copy().
  [[nodiscard]] bool has_lost_its_file() const;
  /// Writes all that is drawn into a new document; the history stays behind. It may have any state: lost, damaged, not made.
  /// @errors kIo: there is something of that name, or it cannot be written; then nothing is left of it.
  [[nodiscard]] Result<void> save_copy(const std::filesystem::path& path) const;

  /// Waits for the disk, as LabelStore::flush().
  [[nodiscard]] Result<void> flush();

 private:
  struct Implementation;
  explicit LabelSheet(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
