// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <memory>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/quality/label_agreement.h"
#include "core/quality/label_checks.h"

namespace {

using nadir::ClassId;
using nadir::LabelDocument;
using nadir::LabelObject;
using nadir::ObjectId;
using nadir::ObjectKind;
using nadir::PlaneBounds;
using nadir::Ring;

constexpr int kSideCells = 4000;
constexpr double kCellM = 0.1;
constexpr int kBlocks = 50;
constexpr double kBlockM = kSideCells * kCellM / kBlocks;

/// Draws a town of blocks of eight metres: a lot, a building, a street with curb and markings, and what people get wrong.
class Town {
 public:
  explicit Town(std::uint32_t version) : version_(version) {
    for (int row = 0; row < kBlocks; ++row) {
      for (int column = 0; column < kBlocks; ++column) draw_block(column, row);
    }
  }
  [[nodiscard]] LabelDocument document() const {
    LabelDocument made(*nadir::ProjectPlane::create({48.9877, 8.3877}),
                       {kCellM, {0.0, 0.0}, kSideCells, kSideCells});
    made.apply(edit_);
    return made;
  }

 private:
  void add(ObjectKind kind, ClassId id, Ring ring, double width_m = 0.0) {
    auto object = std::make_shared<LabelObject>();
    object->id = static_cast<ObjectId>(edit_.objects.size()) + 1;
    object->kind = kind;
    object->class_id = id;
    object->order = nadir::drawing_level(id) * nadir::kOrdersPerLevel + object->id;
    object->width_m = width_m;
    object->rings = {std::move(ring)};
    edit_.objects.push_back({nullptr, std::move(object)});
  }
  void draw_block(int column, int row) {
    const auto number = static_cast<std::uint32_t>(row * kBlocks + column);
    const auto random = nadir::uniforms({version_, 0, 0, number, 0});
    const Eigen::Vector2d corner(column * kBlockM, -row * kBlockM);
    const auto at = [&](double x, double y) -> Eigen::Vector2d {
      return corner + Eigen::Vector2d(x, -y);
    };
    const auto box = [&](double left, double top, double right, double bottom) {
      Ring ring;
      for (double x = left; x < right; x += 0.5) ring.push_back(at(x, top));
      for (double y = top; y < bottom; y += 0.5) ring.push_back(at(right, y));
      for (double x = right; x > left; x -= 0.5) ring.push_back(at(x, bottom));
      for (double y = bottom; y > top; y -= 0.5) ring.push_back(at(left, y));
      return ring;
    };
    // One in fifty lots leaves a gap, overlaps its neighbour or is missing.
    const double wrong = random[0] < 0.02 ? -0.3 : random[0] < 0.04 ? 0.6 : 0.0;
    if (random[0] < 0.98) add(ObjectKind::kArea, nadir::kTerrain, box(0, 0, 6 + wrong, 6));
    add(ObjectKind::kArea, nadir::kSidewalk, box(6, 0, 6.5, 6));
    add(ObjectKind::kArea, nadir::kRoad, box(6.5, 0, 8, 8));
    add(ObjectKind::kArea, nadir::kRoad, box(0, 6.5, 6.5, 8));
    add(ObjectKind::kArea, nadir::kSidewalk, box(0, 6, 6.5, 6.5));
    add(ObjectKind::kOutline, nadir::kBuilding, box(1, 1, 4 + random[1], 4), 0.3);
    add(ObjectKind::kLine, nadir::kCurb, {at(6.5, 0), at(6.5, 3), at(6.5, 6.5)}, 0.15);
    add(ObjectKind::kLine, nadir::kLaneMarking, {at(7.2, 0), at(7.2, 3)}, 0.12);
  }

  std::uint32_t version_;
  nadir::LabelEdit edit_;
};

/// 20,000 objects.
const LabelDocument& town() {
  static const LabelDocument document = Town(1).document();
  return document;
}

void BM_CheckAllOf20000ObjectsOnOneCore(benchmark::State& state) {
  const nadir::ThreadLimit one(1);
  std::size_t count = 0;
  for (auto _ : state) {
    const auto findings = nadir::check_labels(town(), town().grid());
    count = findings ? findings->size() : 0;
  }
  state.counters["findings"] = static_cast<double>(count);
  state.counters["objects"] = static_cast<double>(town().objects().size());
}

void BM_CheckTenMetresOf20000Objects(benchmark::State& state) {
  std::uint32_t number = 0;
  for (auto _ : state) {
    const auto [x, y] = nadir::uniforms({2, 0, 0, number++, 0});
    PlaneBounds within;
    within.include({x * 390.0, -y * 390.0});
    within.include(within.low + Eigen::Vector2d(10.0, -10.0));
    benchmark::DoNotOptimize(nadir::check_labels(town(), town().grid(), {}, within));
  }
}

void BM_ConfusionOfTwoTowns(benchmark::State& state) {
  static const LabelDocument other = Town(2).document();
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        nadir::confusion_of(town(), other, town().grid(), town().grid().whole()));
  }
}

BENCHMARK(BM_CheckAllOf20000ObjectsOnOneCore)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CheckTenMetresOf20000Objects)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ConfusionOfTwoTowns)->Unit(benchmark::kMillisecond);

}  // namespace
