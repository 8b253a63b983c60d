// SPDX-License-Identifier: Apache-2.0
// Which labels are open, the tool at work on them, and what is selected.
#include <algorithm>
#include <cmath>
#include <system_error>

#include "core/session/session_core.h"

namespace nadir {
namespace fs = std::filesystem;

namespace {

constexpr double kBetweenLabelPollsS = 1.0;
constexpr int kTilesCountedAFrame = 4;
constexpr double kHitReachM = 0.0;  // of a place that says nothing about it

/// A package, where its document is named.
std::string labelled_path(const std::string& named) {
  const fs::path path = absolute_path(named);
  std::error_code error;
  const bool is_of_package = (path.filename() == "labels.gpkg" || path.filename() == "map.toml") &&
                             fs::exists(path.parent_path() / "map.toml", error);
  return (is_of_package ? path.parent_path() : path).string();
}

std::vector<StreetProfile> profiles_in(const fs::path& folder) {
  std::vector<StreetProfile> profiles;
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    if (at->path().extension() != ".toml") continue;
    if (auto read = StreetProfile::read(at->path())) profiles.push_back(std::move(*read));
  }
  std::sort(profiles.begin(), profiles.end(),
            [](const StreetProfile& a, const StreetProfile& b) { return a.name < b.name; });
  return profiles;
}

}  // namespace

Result<LabelDesk*> Session::Implementation::need_desk() {
  if (labels && labels->desk) return &*labels->desk;
  return fail(ErrorCode::kInvalidOptions, "{}",
              labels ? "the labels are still being opened"
                     : "no labels are open: open a map or an image to label first");
}

LabelDesk* Session::Implementation::desk_in_front() {
  const bool is_in_front = label.workspace == Workspace::kLabel && labels && labels->desk;
  return is_in_front ? &*labels->desk : nullptr;
}

bool Session::Implementation::labels_elsewhere() const {
  return label.workspace == Workspace::kLabel && label.path != kept.view.map_path;
}

void Session::Implementation::set_sight(const GroundSight& sight) {
  kept.view.map.centre_in_enu_m = sight.centre_in_enu_m;
  kept.view.map.width_m = sight.width_m;
}

Result<void> Session::Implementation::perform(const actions::OpenLabels& action) {
  if (action.path.empty()) return fail(ErrorCode::kInvalidOptions, "no file is named");
  const std::string path = labelled_path(action.path);
  std::error_code error;
  if (!fs::exists(path, error)) return fail(ErrorCode::kNotFound, "{}: does not exist", path);
  // A package whose labels are only beginning is no map to replay on yet.
  const bool is_map = fs::exists(fs::path(path) / "map.toml", error) &&
                      fs::exists(fs::path(path) / "labels.tif", error);
  if (is_map && kept.view.map_path.empty()) {
    if (auto opened = open_map(path); !opened) return opened;
  }
  if (path != label.path) label.elsewhere = {};
  label.path = path;
  label.workspace = Workspace::kLabel;
  return {};
}

Result<void> Session::Implementation::perform(const actions::CloseLabels& /*action*/) {
  if (label.path.empty()) return fail(ErrorCode::kInvalidOptions, "no labels are open");
  label.path.clear();
  label.workspace = Workspace::kReplay;
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetWorkspace& action) {
  if (action.to == Workspace::kLabel && label.path.empty()) {
    if (kept.view.map_path.empty()) {
      return fail(ErrorCode::kInvalidOptions,
                  "there is nothing to label: open a map or an image first");
    }
    return perform(actions::OpenLabels{kept.view.map_path});
  }
  label.workspace = action.to;
  return {};
}

Result<void> Session::Implementation::perform(const actions::ShowLabelTab& action) {
  label.tab = action.tab;
  return {};
}

Result<void> Session::Implementation::perform(const actions::ShowBorders& action) {
  label.shows_borders = switched(label.shows_borders, action.to);
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetLabelOpacity& action) {
  if (!(action.share >= 0.0 && action.share <= 1.0)) {
    return fail(ErrorCode::kInvalidOptions, "an opacity of {:g} is not in [0, 1]", action.share);
  }
  (action.layer == LabelLayer::kLabels ? label.labels_opacity : label.picture_opacity) =
      action.share;
  return {};
}

Result<void> Session::Implementation::use_tool(const LabelTool& tool) {
  if (labels && labels->desk) {
    if (auto set = labels->desk->set_tool(tool); !set) return set;
  } else if (auto valid = validate(tool); !valid) {
    return valid;
  }
  label.tool = tool;
  return {};
}

Result<void> Session::Implementation::perform(const actions::SetLabelOption& action) {
  LabelTool tool = label.tool;
  if (action.name == "class") {  // so that there is a last one to go back to
    const auto named = NamedClass::from_text(action.value);
    if (!named) return forward_error(named);
    use_class(tool, named->id);
  } else if (auto set = set_option(tool, action.name, action.value); !set) {
    return tl::unexpected(without_dashes(set.error()));
  }
  auto used = use_tool(tool);
  return used ? used : tl::unexpected(without_dashes(used.error()));
}

Result<void> Session::Implementation::perform(const actions::LastClass& /*action*/) {
  LabelTool tool = label.tool;
  toggle_class(tool);
  return use_tool(tool);
}

Result<void> Session::Implementation::perform(const actions::AddPlace& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->add_point({action.east_m, action.north_m}, action.reach_m.value_or(kHitReachM),
                            action.how.value_or(SelectHow::kInstead));
}

Result<void> Session::Implementation::perform(const actions::TraceTo& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->add_traced({action.east_m, action.north_m}, action.reach_m,
                             action.way == TraceWay::kFar);
}

Result<void> Session::Implementation::perform(const actions::TypeLeg& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  TypedLeg leg = (*desk)->points().typed();
  if (action.part == LegPart::kLength) {
    if (action.number && !(*action.number > 0.0)) {
      return fail(ErrorCode::kInvalidOptions, "a leg of {:g} m leads nowhere", *action.number);
    }
    leg.length_m = action.number;
  } else {
    leg.bearing_deg = action.number;
    leg.is_turn = action.part == LegPart::kTurn && action.number;
  }
  (*desk)->type_leg(leg);
  return {};
}

Result<void> Session::Implementation::perform(const actions::FinishTool& /*action*/) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->finish();
}

Result<void> Session::Implementation::perform(const actions::CancelTool& /*action*/) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  (*desk)->cancel();
  label.tool = (*desk)->tool();
  return {};
}

Result<void> Session::Implementation::perform(const actions::SelectLabels& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  return (*desk)->select(action.objects.numbers, SelectHow::kInstead);
}

Result<void> Session::Implementation::perform(const actions::SelectBox& action) {
  const auto desk = need_desk();
  if (!desk) return forward_error(desk);
  PlaneBounds box;
  box.include({action.west_m, action.south_m});
  box.include({action.east_m, action.north_m});
  const SelectHow how = action.how.value_or(SelectHow::kInstead);
  if (label.tool.kind == ToolKind::kVertices) {
    (*desk)->pick_within(box, how);
  } else {
    (*desk)->select_within(box, how);
  }
  return {};
}

void Session::Implementation::reconcile_labels() {
  const std::string& open = labels ? labels->path : std::string();
  if (label.path == open) return;
  if (labels) let_go(labels->opening);
  labels.reset();
  if (label.path.empty()) return;
  labels.emplace();
  labels->path = label.path;
  labels->number = ++last_number;
  labels->opening.emplace(
      [path = label.path, author = places.author, folder = places.resources / "profiles"](
          const WorkContext& context, const auto& /*publish*/) -> Result<LabelDesk> {
        context.report(0.0, "reading labels");
        auto desk = LabelDesk::open(path, author);
        if (desk) desk->set_profiles(profiles_in(folder));
        return desk;
      });
}

void Session::Implementation::take_labels() {
  if (!labels || !labels->opening || !labels->opening->is_done()) return;
  auto opened = std::move(*labels->opening->outcome());
  labels->opening.reset();
  if (!opened) {
    add_notice(Notice::Kind::kError, opened.error().message);
    std::erase(recents, label.path);
    label.path.clear();
    label.workspace = Workspace::kReplay;
    reconcile();
    return;
  }
  LabelDesk& desk = labels->desk.emplace(std::move(*opened));
  remember(label.path);
  if (!desk.set_tool(label.tool)) label.tool = desk.tool();
  for (const std::string& notice : desk.sheet().notices()) {
    add_notice(Notice::Kind::kInfo, notice);
  }
  if (const std::string& why = desk.sheet().why_read_only(); !why.empty()) {
    add_notice(Notice::Kind::kWarning, why);
  }
}

void Session::Implementation::poll_labels(double elapsed_s) {
  take_labels();
  if (!labels || !labels->desk) return;
  LabelDesk& desk = *labels->desk;
  labels->is_counted = desk.count_more(kTilesCountedAFrame);
  labels->since_poll_s += std::max(elapsed_s, 0.0);
  if (labels->since_poll_s < kBetweenLabelPollsS) return;
  labels->since_poll_s = 0.0;
  const auto words = desk.poll();
  if (words) {
    for (const std::string& word : *words) add_notice(Notice::Kind::kInfo, word);
    labels->last_fault.clear();
  } else if (labels->last_fault != words.error().message) {  // it is asked every second
    labels->last_fault = words.error().message;
    add_notice(Notice::Kind::kWarning, words.error().message);
  }
}

}  // namespace nadir
