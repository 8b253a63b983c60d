// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <string>

#include "core/map/class_remap.h"
#include "core/run/run_options.h"
#include "core/sim/route.h"
#include "tests/fuzz/fuzz_check.h"

// The bytes are a text that a person writes: a remap of classes, a route and a recipe, in turn.
namespace {

using nadir::fuzz_check;
using nadir::fuzz_check_error;

constexpr const char* kName = "fuzzed.toml";

void check_remap(std::string_view text) {
  const auto remap = nadir::ClassRemap::parse(text, kName);
  fuzz_check_error(remap, kName);
  if (!remap) return;
  nadir::Raster<std::uint8_t> all(256, 1);
  for (int id = 0; id < 256; ++id) all.at(id, 0) = static_cast<std::uint8_t>(id);
  const nadir::Raster<nadir::ClassId> classes = remap->apply(all);
  for (const nadir::ClassId id : classes.values()) {
    fuzz_check(id < nadir::kClassCount || id == nadir::kUnclassified, "every id becomes a class");
  }
}

void check_route(std::string_view text) {
  constexpr double kEnoughM = 2000.0;  // Longer flights take longer, and show nothing else.
  const auto route = nadir::parse_route(text, kName);
  fuzz_check_error(route, kName);
  if (!route) return;
  double lap_m = 0.0;
  const auto& places = route->waypoints_in_enu_m;
  for (std::size_t i = 0; i < places.size(); ++i) {
    lap_m += (places[(i + 1) % places.size()] - places[i]).norm();
  }
  if (lap_m * route->laps > kEnoughM) return;
  const auto flight = nadir::plan_flight(*route, 1);
  fuzz_check_error(flight, route->name);
  if (!flight) return;
  for (const nadir::TimedPose& timed : flight->poses()) {
    fuzz_check(timed.pose.translation_m.allFinite(), "every place is somewhere");
    fuzz_check(timed.pose.rotation.coeffs().allFinite(), "and every attitude an attitude");
  }
  const Eigen::Vector2d end = flight->poses().back().pose.translation_m.head<2>() -
                              (route->is_closed ? places.front() : places.back());
  fuzz_check(end.norm() < 1e-3, "a flight ends where its route does");
}

void check_recipe(std::string_view text) {
  const auto recipe = nadir::parse_run_recipe(text, kName);
  fuzz_check_error(recipe, kName);
  if (recipe) fuzz_check(nadir::run_preset(recipe->preset).has_value(), "a preset that exists");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text = nadir::text_of(data, size);
  check_remap(text);
  check_route(text);
  check_recipe(text);
  return 0;
}
