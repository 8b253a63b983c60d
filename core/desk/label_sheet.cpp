// SPDX-License-Identifier: Apache-2.0
#include "core/desk/label_sheet.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/desk/file_stamp.h"
#include "core/desk/label_coverage.h"
#include "core/desk/label_place.h"
#include "core/desk/object_index.h"
#include "core/edit/snapping.h"

namespace nadir {
namespace {

namespace fs = std::filesystem;

std::string why_not_makeable(const fs::path& document) {
  const fs::path folder = document.has_parent_path() ? document.parent_path() : fs::path(".");
  if (::access(folder.c_str(), W_OK) == 0) return {};
  return fmt::format("{}: cannot be made, for its folder cannot be written, so it is only shown",
                     document.string());
}

}  // namespace

struct LabelSheet::Implementation {
  Implementation(LabelPlace where, std::string who, LabelAccess how)
      : place(std::move(where)), author(std::move(who)), access(how) {}

  LabelPlace place;
  std::string author;
  LabelAccess access;
  std::optional<LabelStore> store;
  std::optional<LabelDocument> unmade;  ///< What there is without a store.
  std::string why_read_only;
  std::vector<std::string> notices;
  std::size_t told_notices = 0;  ///< Of the store.
  FileStamp stamp;               ///< Just before a document that is only read was read.
  std::string told_fault;        ///< By the last poll().
  ChangeLog log;
  std::unique_ptr<ObjectIndex> objects;
  std::unique_ptr<SnapIndex> places;
  std::unique_ptr<LabelCoverage> coverage;
  std::shared_ptr<const LabelDocument> snapshot;

  [[nodiscard]] const LabelDocument& now() const { return store ? store->document() : *unmade; }

  void take_store(LabelStore opened) {
    store.emplace(std::move(opened));
    unmade.reset();
    why_read_only = store->why_read_only();
    told_notices = store->notices().size();
  }
  void index_anew() {
    objects = std::make_unique<ObjectIndex>(now());
    places = std::make_unique<SnapIndex>(now());
    coverage = std::make_unique<LabelCoverage>(now().grid());
    snapshot.reset();
  }
  /// Everything that looks at the document learns of what was done.
  void follow(const LabelEdit& edit) {
    objects->apply(edit);
    places->apply(edit);
    coverage->follow(edit);
    log.add(edit, now().grid());
    snapshot.reset();
  }
  /// Makes the file with what it begins with and a first edit, in one, or nothing. @param edit  That fits.
  [[nodiscard]] Result<void> make_with(const LabelEdit& edit) {
    const std::array<LabelEdit, 2> first{place.takes_over, edit};
    auto made = LabelStore::create(place.document, LabelDocument(unmade->plane(), unmade->grid()),
                                   first, author);
    if (!made) return forward_error(made);
    take_store(std::move(*made));
    told_notices = 0;  // By the next poll().
    place.takes_over = {};
    return {};
  }
  [[nodiscard]] Result<void> go(Result<LabelEdit> gone) {
    why_read_only = store->why_read_only();
    if (!gone) return forward_error(gone);
    follow(*gone);
    return {};
  }
  [[nodiscard]] Result<std::vector<std::string>> open_again();
  [[nodiscard]] Result<std::vector<std::string>> poll();
};

LabelSheet::LabelSheet(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
LabelSheet::LabelSheet(LabelSheet&&) noexcept = default;
LabelSheet& LabelSheet::operator=(LabelSheet&&) noexcept = default;
LabelSheet::~LabelSheet() = default;

Result<LabelSheet> LabelSheet::open(const fs::path& named,
                                    const std::string& author,
                                    const LabelOpening& how) {
  auto place = find_label_place(named, how.image);
  if (!place) return forward_error(place);
  auto all = std::make_unique<Implementation>(std::move(*place), author, how.access);
  all->notices = all->place.notices;
  if (all->place.begins_as) {
    all->unmade = std::move(all->place.begins_as);
    all->unmade->apply(all->place.takes_over);
    all->why_read_only =
        all->access == LabelAccess::kRead
            ? fmt::format("{}: was opened for reading", all->place.document.string())
            : why_not_makeable(all->place.document);
  } else {
    all->stamp = stamp_of(all->place.document);
    auto store = LabelStore::open(all->place.document, author, all->access);
    if (!store) return forward_error(store);
    all->take_store(std::move(*store));
    const auto& told = all->store->notices();
    all->notices.insert(all->notices.end(), told.begin(), told.end());
  }
  all->index_anew();
  return LabelSheet(std::move(all));
}

const fs::path& LabelSheet::path() const { return implementation_->place.document; }
const fs::path& LabelSheet::image() const { return implementation_->place.image; }
bool LabelSheet::is_on_disk() const { return implementation_->store.has_value(); }
const std::string& LabelSheet::why_read_only() const { return implementation_->why_read_only; }
const std::vector<std::string>& LabelSheet::notices() const { return implementation_->notices; }
const LabelDocument& LabelSheet::now() const { return implementation_->now(); }
std::int64_t LabelSheet::revision() const { return implementation_->log.revision(); }
const ObjectIndex& LabelSheet::objects() const { return *implementation_->objects; }
const SnapIndex& LabelSheet::places() const { return *implementation_->places; }
const LabelCoverage& LabelSheet::coverage() const { return *implementation_->coverage; }

const std::shared_ptr<const LabelDocument>& LabelSheet::document() const {
  auto& snapshot = implementation_->snapshot;
  if (snapshot == nullptr) snapshot = std::make_shared<const LabelDocument>(now());
  return snapshot;
}

LabelChanges LabelSheet::changed_since(std::int64_t revision) const {
  return implementation_->log.since(revision);
}

bool LabelSheet::count_more(int most_tiles) {
  return implementation_->coverage->count(now(), most_tiles);
}

Result<void> LabelSheet::commit(const LabelEdit& edit) {
  Implementation& all = *implementation_;
  if (!all.why_read_only.empty()) {
    return fail(ErrorCode::kInvalidOptions, "{}", all.why_read_only);
  }
  if (edit.empty()) return {};
  if (all.store) {
    auto done = all.store->commit(edit);
    all.why_read_only = all.store->why_read_only();
    if (!done) return done;
  } else {
    if (auto fits = all.unmade->check(edit); !fits) return fits;
    if (auto made = all.make_with(edit); !made) return made;
  }
  all.follow(edit);
  return {};
}

std::optional<std::string> LabelSheet::undo_title() const {
  const auto& store = implementation_->store;
  if (!store || !why_read_only().empty() || !store->undo_step()) return std::nullopt;
  return store->undo_step()->title;
}

std::optional<std::string> LabelSheet::redo_title() const {
  const auto& store = implementation_->store;
  if (!store || !why_read_only().empty() || !store->redo_step()) return std::nullopt;
  return store->redo_step()->title;
}

Result<void> LabelSheet::undo() {
  auto& store = implementation_->store;
  if (!store) return fail(ErrorCode::kInvalidOptions, "there is nothing to undo");
  return implementation_->go(store->undo());
}

Result<void> LabelSheet::redo() {
  auto& store = implementation_->store;
  if (!store) return fail(ErrorCode::kInvalidOptions, "there is nothing to do again");
  return implementation_->go(store->redo());
}

Result<void> LabelSheet::go_to(std::int64_t step) {
  auto& store = implementation_->store;
  if (!store) return fail(ErrorCode::kInvalidOptions, "there is no step {}", step);
  const LabelDocument before = store->document();
  const auto gone = store->go_to(step);
  implementation_->why_read_only = store->why_read_only();
  // Where it fails, it may stand at a step on the way.
  const LabelEdit edit = gone ? *gone : difference(before, store->document(), {});
  if (!edit.empty()) implementation_->follow(edit);
  if (!gone) return forward_error(gone);
  return {};
}

std::int64_t LabelSheet::step() const {
  const auto& store = implementation_->store;
  return store && store->undo_step() ? store->undo_step()->number : 0;
}

Result<std::vector<LabelStep>> LabelSheet::history(std::int64_t first, int count) const {
  const auto& store = implementation_->store;
  if (!store) return std::vector<LabelStep>{};
  return store->history(first, count);
}

Result<std::vector<LabelEdit>> LabelSheet::way(const LabelDocument& document,
                                               std::int64_t from,
                                               std::int64_t to) const {
  const auto& store = implementation_->store;
  if (store) return store->way(document, from, to);
  if (from == 0 && to == 0) return std::vector<LabelEdit>{};
  return fail(ErrorCode::kInvalidOptions, "there is no step {}", std::max(from, to));
}

Result<std::vector<std::string>> LabelSheet::Implementation::open_again() {
  std::vector<std::string> words;
  const std::string name = place.document.string();
  const bool was_there = store.has_value();
  const std::string why_before = why_read_only;
  const FileStamp now_there = stamp_of(place.document);
  auto opened = LabelStore::open(place.document, author, access);
  // What somebody else holds up is tried again, and what is no document when it has changed.
  if (opened || opened.error().code != ErrorCode::kIo) stamp = now_there;
  if (!opened) return forward_error(opened);
  const bool is_same_place =
      opened->document().plane() == now().plane() && opened->document().grid() == now().grid();
  const bool is_changed = !(opened->document() == now());
  const LabelDocument before = now();
  take_store(std::move(*opened));
  if (is_same_place) {
    if (is_changed) follow(difference(before, now(), {}));
  } else {
    index_anew();
    log.add_everything();
  }
  words.insert(words.end(), store->notices().begin(), store->notices().end());
  if (!was_there) {
    words.push_back(fmt::format("{}: was made by another program, and was opened", name));
  } else if (is_changed) {
    words.push_back(fmt::format("{}: another program has changed it, and was followed", name));
  }
  if (was_there && !why_before.empty() && why_read_only.empty()) {
    words.push_back(fmt::format("{}: can be edited now", name));
  }
  return words;
}

Result<std::vector<std::string>> LabelSheet::Implementation::poll() {
  std::error_code ignored;
  if (!store) {
    if (!fs::exists(place.document, ignored)) return std::vector<std::string>{};
    return open_again();
  }
  if (store->has_lost_its_file()) return fail(ErrorCode::kIo, "{}", why_read_only);
  if (!why_read_only.empty()) {
    if (stamp_of(place.document) == stamp) return std::vector<std::string>{};
    return open_again();
  }
  const auto edit = store->take_foreign_changes();
  why_read_only = store->why_read_only();
  if (!edit) return forward_error(edit);
  std::vector<std::string> words;
  for (; told_notices < store->notices().size(); ++told_notices)
    words.push_back(store->notices()[told_notices]);
  if (edit->empty()) return words;
  follow(*edit);
  const std::size_t count = edit->objects.size();  // None where it is paint, values or history.
  const std::string what =
      count == 0 ? "what" : fmt::format("{} object{} that", count, count == 1 ? "" : "s");
  words.push_back(
      fmt::format("{}: took over {} another program has changed", place.document.string(), what));
  return words;
}

Result<std::vector<std::string>> LabelSheet::poll() {
  auto words = implementation_->poll();
  std::string fault = words ? std::string() : words.error().message;
  if (!fault.empty() && fault == implementation_->told_fault) return std::vector<std::string>{};
  implementation_->told_fault = std::move(fault);
  return words;
}

bool LabelSheet::has_lost_its_file() const {
  const auto& store = implementation_->store;
  return store && store->has_lost_its_file();
}

Result<void> LabelSheet::save_copy(const fs::path& path) const {
  auto made = LabelStore::create(path, now(), implementation_->author);
  if (!made) return forward_error(made);
  return made->close();
}

Result<void> LabelSheet::flush() {
  if (!implementation_->store) return {};
  return implementation_->store->flush();
}

}  // namespace nadir
