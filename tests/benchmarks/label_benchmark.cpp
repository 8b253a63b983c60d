// SPDX-License-Identifier: Apache-2.0
#include <benchmark/benchmark.h>

#include <memory>

#include "core/base/random.h"
#include "core/edit/edit_objects.h"
#include "core/edit/edit_vertices.h"

namespace {

using nadir::LabelDocument;
using nadir::ObjectId;
using nadir::Ring;

constexpr int kColumns = 200;
constexpr int kRows = 100;
constexpr double kSideM = 10.0;
constexpr int kPlacesASide = 5;

/// 20,000 lots side by side: each shares its borders with its neighbours, twenty places a lot.
LabelDocument lots() {
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
      const double step = kSideM / kPlacesASide;
      Ring ring;
      for (int i = 0; i < kPlacesASide; ++i) ring.push_back(corner + Eigen::Vector2d(i * step, 0));
      for (int i = 0; i < kPlacesASide; ++i)
        ring.push_back(corner + Eigen::Vector2d(kSideM, -i * step));
      for (int i = 0; i < kPlacesASide; ++i)
        ring.push_back(corner + Eigen::Vector2d(kSideM - i * step, -kSideM));
      for (int i = 0; i < kPlacesASide; ++i)
        ring.push_back(corner + Eigen::Vector2d(0, i * step - kSideM));
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

BENCHMARK(BM_SnapIndexOf20000Objects)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SnapNearestOf20000Objects)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_MoveSharedVertexOf20000Objects)->Unit(benchmark::kMicrosecond);
BENCHMARK(BM_SplitOneOf20000Objects)->Unit(benchmark::kMicrosecond);

}  // namespace
