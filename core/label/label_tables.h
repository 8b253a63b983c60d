// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "core/base/result.h"
#include "core/label/label_database.h"
#include "core/label/label_document.h"

namespace nadir {

/// The tables of labels.gpkg that hold what a document is now. Private to this module. All but read_header() are called
/// within a transaction.

[[nodiscard]] Result<void> create_tables(const SqliteDatabase& database,
                                         const ProjectPlane& plane,
                                         const LabelGrid& grid);

/// An empty document with plane and grid. @param name  Stands for the file in messages. @errors kMalformed: no labelling
/// document, damaged; kUnsupported: of a newer version.
[[nodiscard]] Result<LabelDocument> read_header(const SqliteDatabase& database,
                                                const std::string& name);

/// What was read of a document.
struct ReadContents {
  std::vector<std::string> notices;  ///< What could not be read, each one sentence.
  bool is_whole = true;              ///< False: tables are damaged, and there may have been more.
};
/// Fills a document with what Nadir has written last: objects by their images, paint and values. @errors kMalformed, kIo.
[[nodiscard]] Result<ReadContents> read_contents(const SqliteDatabase& database,
                                                 LabelDocument& document);

/// What other programs have made of the tables of objects.
struct ForeignChanges {
  LabelEdit edit;  ///< From the document to what stands there.
  /// Rows whose number is an object of another table; their objects have got other numbers.
  std::vector<std::pair<ObjectKind, ObjectId>> strays;
  std::vector<std::string> notices;  ///< About rows that are no objects; those keep what they were.
  bool is_whole = true;  ///< False: tables are damaged; objects without a row then stay.
};
/// @param is_document_whole  False: it may lack objects that have rows, which then keep their numbers.
[[nodiscard]] Result<ForeignChanges> find_foreign_changes(const SqliteDatabase& database,
                                                          const LabelDocument& document,
                                                          bool is_document_whole);
[[nodiscard]] Result<void> remove_row(const SqliteDatabase& database, ObjectKind kind, ObjectId id);

/// Makes all tables say what comes after an edit.
[[nodiscard]] Result<void> write_edit(const SqliteDatabase& database, const LabelEdit& edit);

/// What a GIS wants to know of its layers: where they lie and when they have changed last.
[[nodiscard]] Result<void> write_layer_facts(const SqliteDatabase& database,
                                             const LabelDocument& document);

}  // namespace nadir
