// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "core/base/measures.h"
#include "core/edit/edit_objects.h"
#include "core/edit/edit_vertices.h"
#include "core/edit/street_profile.h"
#include "core/label/edit_paint.h"
#include "core/label/label_raster.h"
#include "tests/fuzz/fuzz_check.h"

namespace {

using nadir::fuzz_check;
using nadir::LabelDocument;
using nadir::LabelEdit;
using nadir::ObjectId;
using nadir::Result;
using nadir::Ring;

constexpr std::size_t kMostGestures = 40;
constexpr std::size_t kMostPlaces = 2'000;

/// Numbers from bytes; zeros after their end.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : data_(data), size_(size) {}
  [[nodiscard]] bool is_at_end() const { return at_ >= size_; }
  std::uint8_t next() { return at_ < size_ ? data_[at_++] : std::uint8_t{0}; }
  /// On a coarse grid, so that places and edges often lie on each other.
  Eigen::Vector2d place() {
    const double x = next();
    const double y = next();
    return {x / 5.0 - 5.0, 5.0 - y / 6.0};
  }
  Ring places(int most) {
    Ring ring;
    for (int i = next() % (most + 1); i >= 0; --i) ring.push_back(place());
    return ring;
  }

 private:
  const std::uint8_t* data_;
  std::size_t size_, at_ = 0;
};

nadir::ClassId some_class(Bytes& bytes) {
  constexpr nadir::ClassId kClasses[] = {nadir::kRoad, nadir::kTerrain, nadir::kCurb,
                                         nadir::kBuilding, nadir::kUnclassified};
  return kClasses[bytes.next() % 5];
}

std::vector<ObjectId> some_objects(Bytes& bytes, const LabelDocument& document) {
  std::vector<ObjectId> ids;
  const int mask = bytes.next();
  int i = 0;
  for (const auto& [id, placed] : document.objects()) {
    if ((mask >> (i++ % 8)) % 2 != 0) ids.push_back(id);
  }
  return ids;
}

ObjectId some_object(Bytes& bytes, const LabelDocument& document) {
  if (document.objects().empty()) return 1;
  auto found = document.objects().begin();
  std::advance(found, bytes.next() % document.objects().size());
  return found->first;
}

nadir::VertexRef some_vertex(Bytes& bytes, const LabelDocument& document) {
  const ObjectId id = some_object(bytes, document);
  return {id, static_cast<std::size_t>(bytes.next() % 2),
          static_cast<std::size_t>(bytes.next() % 8)};
}

Result<LabelEdit> cut_gesture(Bytes& bytes, const LabelDocument& document) {
  switch (bytes.next() % 6) {
    case 0:
      return nadir::cut_hole(document, some_object(bytes, document), bytes.places(5));
    case 1:
      return nadir::split(document, some_objects(bytes, document), bytes.places(3));
    case 2:
      return nadir::merge(document, some_objects(bytes, document));
    case 3:
      return nadir::subtract(document, some_object(bytes, document), some_objects(bytes, document));
    case 4:
      return nadir::clip(document, some_objects(bytes, document),
                         bytes.next() % 2 != 0 ? nadir::ClipSide::kThis : nadir::ClipSide::kOthers);
    default: {
      const nadir::ClassId from = some_class(bytes);
      return nadir::recode(document, from, some_class(bytes), bytes.places(6));
    }
  }
}

Result<LabelEdit> vertex_gesture(Bytes& bytes, const LabelDocument& document) {
  const auto shared =
      bytes.next() % 2 != 0 ? nadir::SharedBorders::kTogether : nadir::SharedBorders::kAlone;
  switch (bytes.next() % 8) {
    case 0:
      return nadir::move_vertex(document, some_vertex(bytes, document), bytes.place(), shared);
    case 1:
      return nadir::add_vertex(document, some_vertex(bytes, document), bytes.place(), shared);
    case 2: {
      const nadir::VertexRef vertex = some_vertex(bytes, document);
      return nadir::remove_vertices(document, std::span(&vertex, 1), shared);
    }
    case 3:
      return nadir::move_objects(document, some_objects(bytes, document), bytes.place());
    case 4: {
      std::size_t places = 0;
      for (const auto& [id, placed] : document.objects()) {
        for (const Ring& ring : placed.object->rings) places += ring.size();
      }
      if (places > kMostPlaces) return LabelEdit{};  // Each time doubles them.
      return nadir::smooth(document, some_objects(bytes, document));
    }
    case 5:
      return nadir::simplify(document, some_objects(bytes, document), bytes.next() / 32.0);
    case 6:
      return nadir::orthogonalise(document, some_objects(bytes, document),
                                  nadir::Angle::degrees(bytes.next() % 46));
    default:
      return nadir::join_borders(document, some_objects(bytes, document), bytes.next() / 64.0);
  }
}

Result<LabelEdit> gesture(Bytes& bytes, const LabelDocument& document) {
  switch (bytes.next() % 10) {
    case 0:
    case 1: {
      const auto kind = static_cast<nadir::ObjectKind>(bytes.next() % 3);
      const double width = kind == nadir::ObjectKind::kArea ? 0.0 : bytes.next() / 50.0;
      return nadir::draw(document, {kind, some_class(bytes), width}, bytes.places(7));
    }
    case 2:
      return nadir::paint_stroke(document, bytes.places(3), 0.1 + bytes.next() / 50.0,
                                 some_class(bytes), "Paint");
    case 3:
      return nadir::copy_beside(document, some_object(bytes, document), bytes.next() / 20.0 - 6.0);
    case 4:
      return nadir::reorder(document, some_objects(bytes, document),
                            static_cast<nadir::OrderMove>(bytes.next() % 4));
    case 5: {
      const nadir::StreetProfile profile{"street",
                                         {{nadir::kRoad, 0.0, 2.0},
                                          {nadir::kCurb, 1.1, 0.2},
                                          {nadir::kCurb, -1.1, 0.2, 1.0, 2.0}}};
      return nadir::draw_street(document, profile, bytes.places(5));
    }
    case 6:
    case 7:
      return cut_gesture(bytes, document);
    default:
      return vertex_gesture(bytes, document);
  }
}

/// Draws again what an edit has changed, as a window does.
void redraw(nadir::Raster<nadir::ClassId>& labels,
            const LabelEdit& edit,
            const LabelDocument& document) {
  const nadir::CellRect changed =
      nadir::changed_cells(edit, document.grid(), document.grid()).cut_to(document.grid().whole());
  const auto part = nadir::rasterise(document, document.grid(), changed);
  for (int row = 0; row < part.height(); ++row) {
    const auto from = part.row(row);
    std::copy(from.begin(), from.end(),
              labels.row(row + static_cast<int>(changed.top)).begin() + changed.left);
  }
}

}  // namespace

/// Bytes are gestures on a small map, and what somebody types.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = nadir::text_of(data, size);
  const auto length = nadir::parse_length_m(text);
  fuzz_check(length ? std::isfinite(*length) : !length.error().message.empty(),
             "a length is finite, or refused in words");
  const auto angle = nadir::parse_angle(text);
  fuzz_check(angle ? std::isfinite(angle->radians()) : !angle.error().message.empty(),
             "an angle is finite, or refused in words");
  nadir::fuzz_check_error(nadir::StreetProfile::parse(text, "street.toml"), "street.toml");

  LabelDocument document(*nadir::ProjectPlane::create({48.9877, 8.3877}),
                         {1.0, {0.0, 0.0}, 40, 30});
  nadir::Raster<nadir::ClassId> labels = nadir::rasterise(document);
  Bytes bytes(data, size);
  for (std::size_t i = 0; i < kMostGestures && !bytes.is_at_end(); ++i) {
    const auto edit = gesture(bytes, document);
    if (!edit) {
      fuzz_check(!edit.error().message.empty(), "a refusal says why");
      continue;
    }
    fuzz_check(document.check(*edit).has_value(), "what a gesture gives fits the document");
    const LabelDocument before = document;
    document.apply(*edit);
    redraw(labels, *edit, document);
    fuzz_check(labels == nadir::rasterise(document), "what changed is all that has to be drawn");
    LabelDocument back = document;
    const LabelEdit undo = nadir::reversed(*edit);
    fuzz_check(back.check(undo).has_value(), "a gesture can be taken back");
    back.apply(undo);
    fuzz_check(back == before, "and all is as before");
  }
  return 0;
}
