// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <cstdlib>
#include <memory>
#include <numeric>

#include "core/base/random.h"
#include "core/desk/label_desk.h"
#include "core/edit/edit_objects.h"
#include "core/edit/edit_vertices.h"
#include "core/exchange/ring_assembly.h"
#include "core/label/label_store.h"
#include "tests/support/scratch_folder.h"

namespace {

using nadir::LabelDocument;
using nadir::ObjectId;
using nadir::Ring;

constexpr int kColumns = 200;
constexpr int kRows = 100;
constexpr double kSideM = 10.0;
constexpr int kPlacesASide = 5;

/// 20,000 lots side by side: each shares its borders with its neighbours, twenty places a lot.
/// @param wider_m  So much larger than that each is, over its neighbours to the east and south.
LabelDocument lots(double wider_m = 0.0) {
  LabelDocument document(*nadir::ProjectPlane::create({48.9877, 8.3877}),
                         {0.1, {0.0, 0.0}, 20'000, 10'000});
  nadir::LabelEdit edit;
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      auto lot = std::make_shared<nadir::LabelObject>();
      lot->id = static_cast<ObjectId>(edit.objects.size()) + 1;
      lot->class_id = nadir::kTerrain;
      lot->order = 1;
      const Eigen::Vector2d corner(column * kSideM, -row * kSideM);
      const double side_m = kSideM + wider_m;
      const double step = side_m / kPlacesASide;
      Ring ring;
      for (int i = 0; i < kPlacesASide; ++i) ring.push_back(corner + Eigen::Vector2d(i * step, 0));
      for (int i = 0; i < kPlacesASide; ++i)
        ring.push_back(corner + Eigen::Vector2d(side_m, -i * step));
      for (int i = 0; i < kPlacesASide; ++i)
        ring.push_back(corner + Eigen::Vector2d(side_m - i * step, -side_m));
      for (int i = 0; i < kPlacesASide; ++i)
        ring.push_back(corner + Eigen::Vector2d(0, i * step - side_m));
      lot->rings = {ring};
      edit.objects.push_back({nullptr, lot});
    }
  }
  document.apply(edit);
  return document;
}

const LabelDocument& shared_lots() {
  static const LabelDocument document = lots();
  return document;
}

Eigen::Vector2d somewhere(std::uint32_t number) {
  const auto [x, y] = nadir::uniforms({1, 0, 0, number, 0});
  return {x * kColumns * kSideM, -y * kRows * kSideM};
}

void BM_SnapIndexOf20000Objects(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(nadir::SnapIndex(shared_lots()));
}

void BM_SnapNearestOf20000Objects(benchmark::State& state) {
  const nadir::SnapIndex index(shared_lots());
  std::uint32_t number = 0;
  for (auto _ : state) benchmark::DoNotOptimize(index.nearest(somewhere(number++), 0.8));
}

/// From the release of the button to the document and the index that the next frame shows.
void BM_MoveSharedVertexOf20000Objects(benchmark::State& state) {
  LabelDocument document = shared_lots();
  nadir::SnapIndex index(document);
  std::uint32_t number = 0;
  for (auto _ : state) {
    const auto id = static_cast<ObjectId>(number * 7919 % (kColumns * kRows)) + 1;
    const double by_m = number++ % 2 == 0 ? 0.25 : -0.25;
    const Eigen::Vector2d to = document.object(id)->rings[0][5] + Eigen::Vector2d(by_m, by_m);
    const auto edit = nadir::move_vertex(document, {id, 0, 5}, to, nadir::SharedBorders::kTogether);
    if (!edit) {
      state.SkipWithError(edit.error().message.c_str());
      break;
    }
    document.apply(*edit);
    index.apply(*edit);
  }
}

void BM_SplitOneOf20000Objects(benchmark::State& state) {
  const std::array<ObjectId, 1> one{10'150};
  const auto lot = shared_lots().object(one[0])->rings[0];
  const Ring line{lot[0] + Eigen::Vector2d(3.3, 1.0), lot[10] + Eigen::Vector2d(-1.7, -1.0)};
  for (auto _ : state) benchmark::DoNotOptimize(nadir::split(shared_lots(), one, line));
}

/// The first so many of the lots.
std::vector<ObjectId> some_ids(const benchmark::State& state) {
  std::vector<ObjectId> ids(static_cast<std::size_t>(state.range(0)));
  std::iota(ids.begin(), ids.end(), ObjectId{1});
  return ids;
}

void BM_RaiseSomeOf20000Objects(benchmark::State& state) {
  const std::vector<ObjectId> ids = some_ids(state);
  for (auto _ : state)
    benchmark::DoNotOptimize(nadir::reorder(shared_lots(), ids, nadir::OrderMove::kUp));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void BM_ClipSomeOf20000Objects(benchmark::State& state) {
  static const LabelDocument overlapping = lots(1.0);
  const std::vector<ObjectId> ids = some_ids(state);
  for (auto _ : state) {
    const auto edit = nadir::clip(overlapping, ids, nadir::ClipSide::kThis);
    if (!edit || edit->objects.size() < ids.size()) state.SkipWithError("nothing was clipped");
  }
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

/// All corners of so many objects, by a box around them.
void BM_PickWithinABox(benchmark::State& state) {
  const nadir::ScratchFolder folder;
  const auto path = folder.path() / "labels.gpkg";
  if (!nadir::LabelStore::create(path, shared_lots(), "ada")) std::abort();
  auto desk = nadir::LabelDesk::open(path, "ada");
  if (!desk || !desk->select(some_ids(state), nadir::SelectHow::kInstead)) std::abort();
  nadir::PlaneBounds box;
  box.include({-1.0, 1.0});
  box.include({kColumns * kSideM + 1.0, -kRows * kSideM - 1.0});
  for (auto _ : state) desk->pick_within(box, nadir::SelectHow::kInstead);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(desk->picked().size()));
}

/// Clearings in one wood, as a multipolygon of OpenStreetMap has them.
void BM_AreasOfRings(benchmark::State& state) {
  std::vector<Ring> rings{nadir::circle({0.0, 0.0}, 3000.0, 10'000)};
  for (int i = 0; i < state.range(0); ++i) {
    rings.push_back(nadir::circle({10.0 * (i % 200) - 1000.0, 10.0 * (i / 200) - 500.0}, 4.0, 12));
  }
  for (auto _ : state) benchmark::DoNotOptimize(nadir::areas_of(rings));
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

BENCHMARK(BM_SnapIndexOf20000Objects)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SnapNearestOf20000Objects)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_MoveSharedVertexOf20000Objects)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_SplitOneOf20000Objects)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_RaiseSomeOf20000Objects)
    ->Arg(100)
    ->Arg(2000)
    ->Arg(20'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(BM_ClipSomeOf20000Objects)->Arg(100)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_PickWithinABox)->Arg(100)->Arg(2000)->Arg(20'000)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_AreasOfRings)->Arg(1000)->Arg(20'000)->Unit(benchmark::kMillisecond);

}  // namespace
