// SPDX-License-Identifier: Apache-2.0
#include "core/desk/label_sheet.h"

#include <unistd.h>

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

/// Removes a document that was just made, with what belongs to it.
void remove_document(const fs::path& path) {
  std::error_code ignored;
  for (const char* const ending : {"", "-wal", "-shm", ".lock"})
    fs::remove(path.string() + ending, ignored);
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
  /// Makes the file with what it begins with and a first edit, or nothing. @param edit  That fits.
  [[nodiscard]] Result<void> make_with(const LabelEdit& edit) {
    auto made = LabelStore::create(place.document, unmade->plane(), unmade->grid(), author);
    if (!made) return forward_error(made);
    auto done = made->commit(place.takes_over);
    if (done) done = made->commit(edit);
    if (!done) {
      static_cast<void>(made->close());
      remove_document(place.document);
      return done;
    }
    take_store(std::move(*made));
    place.takes_over = {};
    return {};
  }
  [[nodiscard]] Result<void> go(Result<LabelEdit> gone) {
    if (!gone) return forward_error(gone);
    follow(*gone);
    return {};
  }
  [[nodiscard]] Result<std::vector<std::string>> open_again();
};

LabelSheet::LabelSheet(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}
LabelSheet::LabelSheet(LabelSheet&&) noexcept = default;
LabelSheet& LabelSheet::operator=(LabelSheet&&) noexcept = default;
LabelSheet::~LabelSheet() = default;

Result<LabelSheet> LabelSheet::open(const fs::path& named,
                                    const std::string& author,
                                    const LabelOpening& how) {
  const LabelAccess access = how.access;
  auto place = find_label_place(named, how.image);
  if (!place) return forward_error(place);
  auto all = std::make_unique<Implementation>(std::move(*place), author, access);
  all->notices = all->place.notices;
  if (all->place.begins_as) {
    all->unmade = std::move(all->place.begins_as);
    all->unmade->apply(all->place.takes_over);
    all->why_read_only = access == LabelAccess::kRead ? fmt::format("{}: was opened for reading",
                                                                    all->place.document.string())
                                                      : why_not_makeable(all->place.document);
  } else {
    all->stamp = stamp_of(all->place.document);
    auto store = LabelStore::open(all->place.document, author, access);
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
    if (auto done = all.store->commit(edit); !done) return done;
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

Result<std::vector<std::string>> LabelSheet::Implementation::open_again() {
  std::vector<std::string> words;
  const std::string name = place.document.string();
  const bool was_there = store.has_value();
  const std::string why_before = why_read_only;
  stamp = stamp_of(place.document);
  auto opened = LabelStore::open(place.document, author, access);
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

Result<std::vector<std::string>> LabelSheet::poll() {
  Implementation& all = *implementation_;
  std::error_code ignored;
  if (!all.store) {
    if (!fs::exists(all.place.document, ignored)) return std::vector<std::string>{};
    return all.open_again();
  }
  if (!all.why_read_only.empty()) {
    if (stamp_of(all.place.document) == all.stamp) return std::vector<std::string>{};
    return all.open_again();
  }
  const auto edit = all.store->take_foreign_changes();
  if (!edit) return forward_error(edit);
  std::vector<std::string> words;
  for (; all.told_notices < all.store->notices().size(); ++all.told_notices)
    words.push_back(all.store->notices()[all.told_notices]);
  all.why_read_only = all.store->why_read_only();
  if (edit->empty()) return words;
  all.follow(*edit);
  words.push_back(fmt::format("{}: took over {} object{} that another program has changed",
                              all.place.document.string(), edit->objects.size(),
                              edit->objects.size() == 1 ? "" : "s"));
  return words;
}

Result<void> LabelSheet::flush() {
  if (!implementation_->store) return {};
  return implementation_->store->flush();
}

}  // namespace nadir
