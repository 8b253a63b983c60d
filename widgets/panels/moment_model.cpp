// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/moment_model.h"

#include <fmt/format.h>

#include <cmath>

#include "core/base/angle.h"
#include "core/session/moment_explanation.h"
#include "widgets/panels/map_geometry.h"
#include "widgets/panels/run_labels.h"

namespace nadir {
namespace {

double degrees_of(double angle_rad) { return Angle::radians(angle_rad).degrees(); }

void add_errors(const RunDocument& document, std::size_t index, std::vector<MomentFact>& facts) {
  const auto at = document.error_index_of(index);
  if (!at) {
    facts.push_back({"position error",
                     "not known",
                     "",
                     kit::TextLook::kMuted,
                     {"The flight does not know the truth here", ""}});
    return;
  }
  const ErrorSeries& errors = document.errors;
  const double position_m = errors.position_error_m[*at];
  const double yaw_deg = std::abs(degrees_of(errors.yaw_error_rad[*at]));
  facts.push_back({"position error",
                   metres_text(position_m),
                   "m",
                   kit::TextLook::kNumber,
                   {"Distance of the estimate from the truth", "", "", "evaluation"}});
  facts.push_back({"orientation error",
                   metres_text(yaw_deg, 1),
                   "°",
                   kit::TextLook::kNumber,
                   {"Angle between estimate and truth", "", "", "evaluation"}});
}

}  // namespace

MomentModel moment_model(const Session& session) {
  MomentModel model;
  if (const OpenMap* const map = session.map(); map != nullptr) model.map = map->index;
  const OpenRun* const run = session.active_run();
  if (run == nullptr) return model;
  model.run_name = run->name;
  model.colour = active_colour(session.view());
  model.document = run->document;
  model.is_reading = !run->document;
  model.has_flight = session.flight() != nullptr;
  model.index = session.step_index();
  model.step = session.step();
  if (run->cache && model.index) {
    model.has_camera_frame = run->cache->frame_of(*model.index).has_value();
    model.camera = run->cache->camera(*model.index);
  }
  return model;
}

std::string nees_words(double nees) {
  const StepNeesBounds bounds = step_nees_bounds();
  if (nees > bounds.upper) return fmt::format("above {:.2f}", bounds.upper);
  if (nees < bounds.lower) return fmt::format("below {:.2f}", bounds.lower);
  return fmt::format("within {:.2f}", bounds.upper);
}

kit::TextLook nees_look(double nees) {
  return nees > step_nees_bounds().upper ? kit::TextLook::kWarning : kit::TextLook::kNumber;
}

std::vector<MomentFact> moment_facts(const RunDocument& document, std::size_t index) {
  using kit::TextLook;
  const RunStep& step = document.steps[index];
  const RunSeries& series = document.series;
  std::vector<MomentFact> facts;
  add_errors(document, index, facts);
  facts.push_back({"sigma east, north",
                   fmt::format("{}, {}", metres_text(series.x_sigma_m[index]),
                               metres_text(series.y_sigma_m[index])),
                   "m",
                   TextLook::kNumber,
                   {"Standard deviations of the particles", "", "", "recorded by the filter"}});
  facts.push_back(
      {"sigma heading",
       metres_text(degrees_of(series.yaw_sigma_rad[index]), 1),
       "°",
       TextLook::kNumber,
       {"Standard deviation of the particles' headings", "", "", "recorded by the filter"}});
  if (const auto at = document.error_index_of(index);
      at && std::isfinite(document.errors.nees[*at])) {
    const double nees = document.errors.nees[*at];
    const StepNeesBounds bounds = step_nees_bounds();
    facts.push_back(
        {"NEES of this step",
         fmt::format("{:.1f}, {}", nees, nees_words(nees)),
         "",
         nees_look(nees),
         {fmt::format(
              "Squared error in the filter's own sigmas: x, y and heading. Of the steps of a "
              "consistent filter 95 % lie between the chi-square bounds {:.2f} and {:.2f} "
              "({} degrees of freedom). One step is no test of consistency: the mean over "
              "many is (Runs, NEES mean)",
              bounds.lower, bounds.upper, bounds.degrees_of_freedom),
          "", "", "evaluation"}});
  }
  if (std::isfinite(step.effective_sample_size)) {
    facts.push_back({"effective sample size",
                     fmt::format("{:.0f} of {}", step.effective_sample_size, step.particle_count),
                     "",
                     TextLook::kNumber,
                     {"How many equal particles would say as much, before resampling", "", "",
                      "recorded by the filter"}});
  }
  facts.push_back(
      {"agreement",
       step.agreement ? fmt::format("{:.0f}", 100.0 * *step.agreement) : std::string("not known"),
       step.agreement ? "%" : "",
       step.agreement ? TextLook::kNumber : TextLook::kMuted,
       {"Share of the topview's cells on known ground that fit the map at the estimate", "", "",
        "recorded by the filter"}});
  const std::size_t modes = step.estimate.modes.size();
  if (modes > 1) {
    facts.push_back(
        {"modes",
         fmt::format("{}, heaviest {:.0f} %", modes, 100.0 * step.estimate.modes.front().mass),
         "",
         TextLook::kWarning,
         {"Clusters of particles that lie apart: one covariance does not describe them", "", "",
          "recorded by the filter"}});
  }
  return facts;
}

}  // namespace nadir
