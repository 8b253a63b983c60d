// SPDX-License-Identifier: Apache-2.0
#include "core/insight/flight_beneath.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/base/require.h"
#include "core/eval/evaluated_step.h"
#include "core/insight/label_ground.h"

namespace nadir {
namespace {

/// Farther from a map than any topview reaches.
constexpr double kFarthestM = 1e7;

/// What the votes of a cell say; share 0 where they say nothing.
struct Verdict {
  ClassId seen = kUnclassified;
  float share = 0.0F;
  float votes = 0.0F;
};

Verdict verdict_of(const SemanticReconstruction::CellVotes& votes, int least_votes) {
  Verdict verdict;
  int most = 0;
  int all = 0;
  for (ClassId id = 0; id < kClassCount; ++id) {
    if (is_movable(id)) continue;
    all += votes[id];
    if (votes[id] <= most) continue;
    most = votes[id];
    verdict.seen = id;
  }
  if (all < least_votes) return {};
  verdict.votes = static_cast<float>(all);
  verdict.share = static_cast<float>(most) / static_cast<float>(all);
  return verdict;
}

/// The cells that touch one another, have the same label and were seen as the same class, beginning with one of them. Takes them out
/// of `verdicts`.
std::vector<std::pair<int, int>> take_place(Raster<Verdict>& verdicts,
                                            const Raster<ClassId>& labels,
                                            int column,
                                            int row,
                                            ContradictedPlace& place) {
  place.seen = verdicts.at(column, row).seen;
  place.labelled = labels.at(column, row);
  std::vector<std::pair<int, int>> cells = {{column, row}};
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  const auto take = [&](int x, int y) {
    Verdict& verdict = verdicts.at(x, y);
    place.mean_share += static_cast<double>(verdict.share);
    place.mean_votes += static_cast<double>(verdict.votes);
    place.cells = place.cells.joined({x, y, x + 1, y + 1});
    sum += Eigen::Vector2d(x + 0.5, y + 0.5);
    verdict = {};
  };
  take(column, row);
  for (std::size_t next = 0; next < cells.size(); ++next) {
    const auto [x, y] = cells[next];
    for (int beside_y = y - 1; beside_y <= y + 1; ++beside_y) {
      for (int beside_x = x - 1; beside_x <= x + 1; ++beside_x) {
        if (!verdicts.contains(beside_x, beside_y) ||
            verdicts.at(beside_x, beside_y).seen != place.seen ||
            labels.at(beside_x, beside_y) != place.labelled) {
          continue;
        }
        take(beside_x, beside_y);
        cells.emplace_back(beside_x, beside_y);
      }
    }
  }
  const auto count = static_cast<double>(cells.size());
  place.mean_share /= count;
  place.mean_votes /= count;
  place.middle_in_enu_m = sum / count;  // in cells as yet
  return cells;
}

}  // namespace

FlightVotes::FlightVotes(const OverheadMap& map)
    : grid_(grid_of(map)), votes_(map.metres_per_cell) {}

void FlightVotes::add(const SemanticTopview& seen, const Rigid2& enu_from_body) {
  const Rigid2 corner_from_body{enu_from_body.x_m - grid_.top_left_in_enu_m.x(),
                                enu_from_body.y_m - grid_.top_left_in_enu_m.y(),
                                enu_from_body.yaw_rad};
  if (!is_finite(corner_from_body) ||
      corner_from_body.translation_m().cwiseAbs().maxCoeff() > kFarthestM) {
    return;
  }
  votes_.add(seen, corner_from_body);
}

void FlightVotes::visit(
    const std::function<void(int column, int row, const SemanticReconstruction::CellVotes& votes)>&
        visit) const {
  votes_.visit_cells([&](int i, int j, const SemanticReconstruction::CellVotes& votes) {
    const int row = -1 - j;
    if (i >= 0 && row >= 0 && i < grid_.width && row < grid_.height) visit(i, row, votes);
  });
}

Result<FlightBeneath> flight_beneath(const RunReader& run,
                                     const OverheadMap& labels,
                                     FlightPose pose,
                                     const WorkContext& context) {
  const auto steps = run.steps();
  if (!steps) return forward_error(steps);
  FlightBeneath result{{}, {}, FlightVotes(labels)};
  for (std::size_t i = 0; i < steps->size(); ++i) {
    if (context.is_stopped()) return fail(ErrorCode::kCancelled, "laying the flight was stopped");
    const auto step = run.step((*steps)[i].step);
    if (!step) return forward_error(step);
    const std::optional<Rigid2> at =
        pose == FlightPose::kTruth ? step->truth_in_enu : step->estimate.moments.mean;
    if (!step->topview || !at || !is_finite(*at)) continue;
    if (std::abs(step->topview->metres_per_cell - labels.metres_per_cell) >
        1e-9 * labels.metres_per_cell) {
      return fail(ErrorCode::kInvalidOptions,
                  "step {}: its topview has cells of {} m, but map '{}' of {} m", step->step,
                  step->topview->metres_per_cell, labels.name, labels.metres_per_cell);
    }
    const CellAgreement agreement = cell_agreement(*step->topview, labels, *at);
    for (std::size_t id = 0; id < agreement.of_class.size(); ++id) {
      result.of_class[id].agreeing += agreement.of_class[id].agreeing;
      result.of_class[id].disagreeing += agreement.of_class[id].disagreeing;
      result.of_class[id].unknown += agreement.of_class[id].unknown;
    }
    result.steps.push_back({step->step, step->time_s, *at, agreement.of_class, agreement.total()});
    result.votes.add(*step->topview, *at);
    context.report(static_cast<double>(i + 1) / static_cast<double>(steps->size()),
                   "laying the flight on the labels");
  }
  if (result.steps.empty()) {
    return fail(ErrorCode::kInvalidOptions, "{}: no step has a topview and {} to lay it at",
                run.header().flight, pose == FlightPose::kTruth ? "a true pose" : "an estimate");
  }
  return result;
}

Result<Contradictions> find_contradictions(const FlightVotes& votes,
                                           const MapIndex& labels,
                                           const ContradictionRule& rule) {
  if (const auto valid = validate(rule); !valid) return forward_error(valid);
  const OverheadMap& map = labels.map();
  const double tolerance_m =
      rule.tolerance_m + labels.truncation_m() / 510.0;  // as exact as fields are
  Raster<Verdict> verdicts(map.labels.width(), map.labels.height());
  votes.visit([&](int column, int row, const SemanticReconstruction::CellVotes& of_cell) {
    const Verdict verdict = verdict_of(of_cell, rule.least_votes);
    const bool is_clear =
        verdict.seen != kUnclassified && static_cast<double>(verdict.share) >= rule.least_share;
    if (!is_clear || map.labels.at(column, row) == verdict.seen ||
        labels.distance_field(verdict.seen).distance_m(column, row) <= tolerance_m) {
      return;
    }
    verdicts.at(column, row) = verdict;
  });
  Contradictions result{
      .seen = Raster<ClassId>(map.labels.width(), map.labels.height(), kUnclassified),
      .places = {}};
  for (int row = 0; row < verdicts.height(); ++row) {
    for (int column = 0; column < verdicts.width(); ++column) {
      if (verdicts.at(column, row).seen == kUnclassified) continue;
      ContradictedPlace place;
      const auto cells = take_place(verdicts, map.labels, column, row, place);
      place.area_m2 = static_cast<double>(cells.size()) * map.metres_per_cell * map.metres_per_cell;
      place.middle_in_enu_m = map.enu_from_overhead(place.middle_in_enu_m);
      if (place.area_m2 < rule.least_area_m2) continue;
      for (const auto& [x, y] : cells) result.seen.at(x, y) = place.seen;
      result.places.push_back(place);
    }
  }
  std::stable_sort(result.places.begin(), result.places.end(),
                   [](const ContradictedPlace& a, const ContradictedPlace& b) {
                     return a.area_m2 * a.mean_share > b.area_m2 * b.mean_share;
                   });
  return result;
}

}  // namespace nadir
