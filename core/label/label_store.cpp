// SPDX-License-Identifier: Apache-2.0
#include "core/label/label_store.h"

#include <utility>

#include "core/base/require.h"
#include "core/label/label_store_core.h"

namespace nadir {
LabelStore::LabelStore(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
LabelStore::LabelStore(LabelStore&& other) noexcept = default;

LabelStore& LabelStore::operator=(LabelStore&& other) noexcept {
  std::swap(implementation_, other.implementation_);
  return *this;
}

LabelStore::~LabelStore() {
  if (implementation_ != nullptr) static_cast<void>(implementation_->close());
}

const LabelDocument& LabelStore::document() const { return implementation_->document; }
const std::string& LabelStore::why_read_only() const { return implementation_->why_read_only; }
bool LabelStore::is_damaged() const { return implementation_->is_damaged; }
bool LabelStore::has_lost_its_file() const { return !implementation_->connection; }
const std::vector<std::string>& LabelStore::notices() const { return implementation_->notices; }
const std::optional<LabelStep>& LabelStore::undo_step() const { return implementation_->undo_step; }
const std::optional<LabelStep>& LabelStore::redo_step() const { return implementation_->redo_step; }

Result<void> LabelStore::commit(const LabelEdit& edit) {
  if (auto writable = implementation_->check_writable(); !writable) return writable;
  if (edit.empty()) return {};
  return implementation_->commit(edit);
}

Result<LabelEdit> LabelStore::undo() {
  if (auto writable = implementation_->check_writable(); !writable) return forward_error(writable);
  const auto step = implementation_->undo_step;
  if (!step) return fail(ErrorCode::kInvalidOptions, "there is nothing to undo");
  return implementation_->go(*step, StepDirection::kUndo);
}

Result<LabelEdit> LabelStore::redo() {
  if (auto writable = implementation_->check_writable(); !writable) return forward_error(writable);
  const auto step = implementation_->redo_step;
  if (!step) return fail(ErrorCode::kInvalidOptions, "there is nothing to do again");
  return implementation_->go(*step, StepDirection::kRedo);
}

Result<LabelEdit> LabelStore::go_to(std::int64_t step) {
  if (auto writable = implementation_->check_writable(); !writable) return forward_error(writable);
  const LabelDocument before = implementation_->document;
  if (auto gone = implementation_->go_to(step); !gone) return forward_error(gone);
  return difference(before, implementation_->document, "Go to another step");
}

Result<std::vector<LabelStep>> LabelStore::history(std::int64_t first, int count) const {
  if (has_lost_its_file()) return fail(ErrorCode::kIo, "{}", why_read_only());
  return read_steps(implementation_->database(), first, count);
}

Result<std::vector<LabelEdit>> LabelStore::way(const LabelDocument& document,
                                               std::int64_t from,
                                               std::int64_t to) const {
  NADIR_REQUIRE(!implementation_->is_closed);
  return implementation_->way(document, from, to);
}

Result<LabelEdit> LabelStore::take_foreign_changes() {
  Implementation& all = *implementation_;
  NADIR_REQUIRE(!all.is_closed);
  if (has_lost_its_file()) return LabelEdit{};
  if (all.why_read_only.empty()) {
    if (auto in_place = all.check_in_place(); !in_place) return forward_error(in_place);
  }
  const auto version = all.database().whole("PRAGMA data_version");
  if (!version) return forward_error(version);
  if (*version == all.data_version) return LabelEdit{};
  return all.take_foreign();
}

Result<void> LabelStore::flush() {
  NADIR_REQUIRE(!implementation_->is_closed);
  if (has_lost_its_file()) return fail(ErrorCode::kIo, "{}", why_read_only());
  if (implementation_->sync == nullptr) return {};
  return implementation_->sync->flush();
}

Result<void> LabelStore::close() { return implementation_->close(); }

}  // namespace nadir
