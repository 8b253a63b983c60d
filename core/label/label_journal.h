// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/label/label_database.h"
#include "core/label/label_store.h"

namespace nadir {

/// The tables of labels.gpkg that hold what a document was. Private to this module; called within a transaction.

/// The step that the tables stand at; 0: the empty document.
[[nodiscard]] Result<std::int64_t> read_head(const SqliteDatabase& database);
[[nodiscard]] Result<void> write_head(const SqliteDatabase& database, std::int64_t step);

/// Adds a step with what it changes. @param step  Its number is made here. @returns the number.
[[nodiscard]] Result<std::int64_t> add_step(const SqliteDatabase& database,
                                            LabelStep step,
                                            const LabelEdit& edit);

/// Nothing where there is no such step.
[[nodiscard]] Result<std::optional<LabelStep>> read_step(const SqliteDatabase& database,
                                                         std::int64_t number);
/// The youngest of those that follow a step; nothing where none does.
[[nodiscard]] Result<std::optional<LabelStep>> youngest_after(const SqliteDatabase& database,
                                                              std::int64_t number);
[[nodiscard]] Result<std::vector<LabelStep>> read_steps(const SqliteDatabase& database,
                                                        std::int64_t first,
                                                        int count);

enum class StepDirection { kUndo, kRedo };
/// What undoing a step does to a document that stands at it, or doing it again to one that stands before it.
/// @errors kMalformed: what the step has kept does not fit the document.
[[nodiscard]] Result<LabelEdit> edit_of_step(const SqliteDatabase& database,
                                             const LabelStep& step,
                                             StepDirection direction,
                                             const LabelDocument& document);

}  // namespace nadir
