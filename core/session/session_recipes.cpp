// SPDX-License-Identifier: Apache-2.0
// Figures and their recipes: what is opened of them is the moment that they show.
#include <algorithm>
#include <cstdio>
#include <system_error>

#include "core/base/settings.h"
#include "core/session/map_stack.h"
#include "core/session/map_upward.h"
#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

Result<void> take_stack(const Settings& recipe, MapLook& into) {
  const auto text = recipe.scalar_as_text("options.stack");
  if (!text) return forward_error(text);
  const auto stack = MapStack::from_text(*text);
  if (!stack) return forward_error(stack);
  into = stack->laid_on(std::move(into));
  // What a recipe does not say is as a figure has it by itself.
  into.up = MapUp::kNorth;
  into.topview_at = PoseSource::kEstimate;
  return {};
}

Result<void> take_up(const Settings& recipe, MapLook& into) {
  const auto text = recipe.scalar_as_text("options.up");
  if (!text) return forward_error(text);
  const auto up = MapUpward::from_text(*text);
  if (!up) return forward_error(up);
  into.up = up->up;
  into.up_rad = up->up_rad(into.up_rad);
  return {};
}

Result<void> take_laid_at(const Settings& recipe, MapLook& into) {
  const auto text = recipe.text("options.laid-at");
  if (!text) return forward_error(text);
  const auto& names = EnumNames<PoseSource>::kNames;
  const auto found = std::find(names.begin(), names.end(), *text);
  if (found == names.end()) {
    return fail(ErrorCode::kInvalidOptions, "laid-at is '{}': write estimate, truth or odometry",
                *text);
  }
  into.topview_at = static_cast<PoseSource>(found - names.begin());
  return {};
}

/// The map as figure 'moment' shows it; other figures, and what a recipe does not say, leave it as it is.
Result<void> take_map_of_moment(const Settings& recipe, MapLook& into) {
  if (recipe.has("options.stack")) {
    if (auto taken = take_stack(recipe, into); !taken) return taken;
  }
  if (recipe.has("options.up")) {
    if (auto taken = take_up(recipe, into); !taken) return taken;
  }
  return recipe.has("options.laid-at") ? take_laid_at(recipe, into) : Result<void>();
}

}  // namespace

void Session::Implementation::open_recipe_later(const fs::path& figure) {
  const auto read = places.recipe_in_figure;
  small_works.push_back(
      {++last_number, "reading " + figure.filename().string(),
       Job<int, std::string>([read, figure](const WorkContext& /*context*/,
                                            const auto& /*publish*/) { return read(figure); }),
       [this, figure](const std::string& text) {
         Standing before = standing();
         if (const auto opened = open_recipe(text, figure); !opened) {
           put_back(std::move(before));
           add_notice(Notice::Kind::kError, opened.error().message);
           return;
         }
         remember(figure.string());
         settle(before.kept, "Open " + figure.filename().string(), {});
       }});
}

Result<void> Session::Implementation::open_recipe(std::string_view text, const fs::path& file) {
  const auto recipe = Settings::parse(text, file.string());
  if (!recipe) return forward_error(recipe);
  const auto figure = recipe->text("figure");
  if (!figure) return forward_error(figure);
  // A figure names its runs from where it was drawn, a recipe from where it lies.
  const auto placed = [&file](const std::string& named) {
    std::error_code error;
    const fs::path beside = file.parent_path() / named;
    return absolute_path(fs::exists(beside, error) ? beside : fs::path(named));
  };
  const auto runs_named = recipe->has("runs") ? recipe->texts("runs") : std::vector<std::string>();
  if (!runs_named) return forward_error(runs_named);
  const auto map_named = recipe->text_or("map", "");
  if (!map_named) return forward_error(map_named);
  std::error_code error;
  for (const std::string& run : *runs_named) {
    if (!fs::exists(placed(run), error)) {
      return fail(ErrorCode::kNotFound, "{}: its run {} is not there", file.string(), run);
    }
    open_run(placed(run));
  }
  if (!runs_named->empty()) open_run(placed(runs_named->front()));  // the one that it is about
  if (map_named->empty() && !runs_named->empty()) {                 // then it shows the run's own
    const fs::path run = placed(runs_named->front());
    const auto open = std::find_if(runs.begin(), runs.end(),
                                   [&run](const OpenRun& one) { return one.path == run; });
    if (open != runs.end()) {
      use_map_of_active_run();
    } else {
      map_wishes[run.string()] = {history.last_change() + 1, true};
    }
  }
  stop_following();
  if (!map_named->empty()) {
    if (auto opened = open_map(placed(*map_named)); !opened) {
      return forward_error(opened, file.string());
    }
  }
  if (recipe->has("options.time")) {
    const auto time_s = recipe->number("options.time");
    if (!time_s) return forward_error(time_s);
    wanted_time_s = std::max(0.0, *time_s);
  }
  if (*figure == "moment") {
    if (auto shown = take_map_of_moment(*recipe, kept.view.map); !shown) {
      return forward_error(shown, file.string());
    }
  }
  if (!recipe->has("options.crop")) return {};
  const auto crop = recipe->scalar_as_text("options.crop");
  if (!crop) return forward_error(crop);
  // "40", or "40@12.5,-30".
  double width_m = 0.0, east_m = 0.0, north_m = 0.0;
  const int read = std::sscanf(crop->c_str(), "%lf@%lf,%lf", &width_m, &east_m, &north_m);
  if (read >= 1 && width_m >= kLeastMapWidthM && width_m <= kMostMapWidthM) {
    kept.view.map.width_m = width_m;
  }
  kept.view.map.is_following = read == 1;  // around the vehicle
  if (read == 3) kept.view.map.centre_in_enu_m = {east_m, north_m};
  return {};
}

}  // namespace nadir
