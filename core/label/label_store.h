// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/label/label_document.h"

namespace nadir {

/// One edit in the history of a document. Steps are a tree: one that is made after others were undone begins a branch, and
/// nothing is ever lost.
struct LabelStep {
  std::int64_t number = 0;  ///< From 1, rising with time.
  std::int64_t parent = 0;  ///< The step before it; 0: the empty document.
  std::string time;         ///< UTC, ISO 8601.
  std::string author, title;
};

enum class LabelAccess { kWriteWhereFree, kRead };

/// A labelling document in its file, labels.gpkg: a GeoPackage whose objects any GIS opens, with paint and history beside
/// them. core/label/README.md describes the tables.
///
/// Every edit is one transaction: commit(), undo() and redo() return when it would survive the end of the program, killed or
/// not; a file that was closed is a single one. One program writes at a time, others read. One thread.
class LabelStore {
 public:
  /// Makes an empty document. @param author  Who works, for the history. @errors kIo: there is such a file already, somebody
  /// else is making it, or it cannot be made; then nothing is left of it.
  [[nodiscard]] static Result<LabelStore> create(const std::filesystem::path& path,
                                                 const ProjectPlane& plane,
                                                 const LabelGrid& grid,
                                                 const std::string& author);
  /// The same with what another document holds, as one step: a copy of what was left of a damaged one.
  [[nodiscard]] static Result<LabelStore> create(const std::filesystem::path& path,
                                                 const LabelDocument& document,
                                                 const std::string& author);
  /// The same with what it begins with, in one: whenever the program is killed, there is no file or one with all of that.
  /// @param empty  Plane and grid. @param first  Edits that become its first steps; those without a change do not. @errors as
  /// commit() too.
  [[nodiscard]] static Result<LabelStore> create(const std::filesystem::path& path,
                                                 const LabelDocument& empty,
                                                 std::span<const LabelEdit> first,
                                                 const std::string& author);
  /// Who writes into a document now, whether it is there or not; nothing where nobody does, as after a program was killed.
  [[nodiscard]] static std::optional<std::string> writer(const std::filesystem::path& path);
  /// Opens a document, with all that a killed program had committed; for reading where it cannot be written, somebody else
  /// writes, or it is damaged (why_read_only()). What other programs have changed becomes a step of its own.
  /// @errors kNotFound; kMalformed: no labelling document, or nothing is left of it; kUnsupported: of a newer version; kIo.
  [[nodiscard]] static Result<LabelStore> open(const std::filesystem::path& path,
                                               const std::string& author,
                                               LabelAccess access = LabelAccess::kWriteWhereFree);
  LabelStore(LabelStore&& other) noexcept;
  LabelStore& operator=(LabelStore&& other) noexcept;
  ~LabelStore();  ///< As close(), in silence.

  [[nodiscard]] const LabelDocument& document() const;
  /// Why it can only be read, and who has it; empty where it can be written.
  [[nodiscard]] const std::string& why_read_only() const;
  /// Whether the file is damaged, so that the document is only what could be read of it.
  [[nodiscard]] bool is_damaged() const;
  /// Another program has replaced, moved or deleted the file, so that document() is all that is left, and can be written
  /// elsewhere by create(). It is noticed by commit(), undo(), redo() and take_foreign_changes().
  [[nodiscard]] bool has_lost_its_file() const;
  /// What the user should know about what was read, each one sentence without full stop.
  [[nodiscard]] const std::vector<std::string>& notices() const;

  /// Does an edit, in the file first. On errors nothing has changed, neither file nor document.
  /// @errors kInvalidOptions: read-only; as LabelDocument::check(); kIo: the disk is full, the file is locked or lost.
  [[nodiscard]] Result<void> commit(const LabelEdit& edit);

  /// What undo() would take back and redo() do again; nothing where there is nothing.
  [[nodiscard]] const std::optional<LabelStep>& undo_step() const;
  [[nodiscard]] const std::optional<LabelStep>& redo_step() const;
  /// Goes one step back, or to the youngest of those that follow. @returns the edit that was done, for what has to be drawn
  /// again. @errors kInvalidOptions: there is none, read-only; kMalformed: the history is damaged there; kIo.
  [[nodiscard]] Result<LabelEdit> undo();
  [[nodiscard]] Result<LabelEdit> redo();
  /// Goes to any step, also of another branch. @param step  Its number; 0: the empty document. @returns the difference.
  /// @errors as undo(); then it stands at a step on the way.
  [[nodiscard]] Result<LabelEdit> go_to(std::int64_t step);
  /// Steps by number. @errors kMalformed, kIo.
  [[nodiscard]] Result<std::vector<LabelStep>> history(std::int64_t first, int count) const;

  /// The edits that lead a copy of the document from one step to another, for looking at what was. Nothing is changed, neither
  /// document() nor the file. @param document  As it stood at `from`; 0: the empty document.
  /// @errors kInvalidOptions: there is no such step, or the document is not of that one; kMalformed: the history is damaged
  /// there; kIo.
  [[nodiscard]] Result<std::vector<LabelEdit>> way(const LabelDocument& document,
                                                   std::int64_t from,
                                                   std::int64_t to) const;

  /// Takes over what another program has written into the tables of objects, as a step; what another Nadir has written, with
  /// its steps. @returns the edit; empty where nothing has changed. @errors as commit().
  [[nodiscard]] Result<LabelEdit> take_foreign_changes();

  /// Waits until all that was committed would survive a power cut too, as it does by itself a moment later.
  /// @errors kIo: the disk fails.
  [[nodiscard]] Result<void> flush();

  /// Makes it a single file; afterwards only document() may be asked. @errors kIo: somebody else has it open, so that what
  /// belongs to it stays in NAME-wal.
  [[nodiscard]] Result<void> close();

 private:
  struct Implementation;
  struct Opening;
  [[nodiscard]] static Result<Opening> find(const std::filesystem::path& path,
                                            const std::string& author,
                                            LabelAccess access);
  /// @param known  What the file holds, where that was just written; nothing: it is read.
  [[nodiscard]] static Result<LabelStore> open(Opening opening, std::optional<LabelDocument> known);
  explicit LabelStore(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
