// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/label_side_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/desk/label_desk.h"
#include "core/session/place_text.h"
#include "widgets/panels/empty_state.h"
#include "widgets/panels/panel_text.h"
#include "widgets/views/theme.h"

namespace nadir {
namespace {

constexpr double kLabelRowHeight = 28.0;  // of the design
constexpr int kMostSteps = 500;           // before the one it stands at, and as many after it

constexpr std::array kTabs = {std::pair(LabelTab::kObjects, "Objects"),
                              std::pair(LabelTab::kHistory, "History"),
                              std::pair(LabelTab::kImage, "Image")};

/// Lists are made again only where the document is another one.
void follow(const LabelDesk& desk, LabelSideState& state) {
  const std::string path = desk.sheet().path().string();
  if (state.path == path && state.revision == desk.sheet().revision()) return;
  state.path = path;
  state.revision = desk.sheet().revision();
  const LabelDocument& document = desk.sheet().now();
  std::vector<std::pair<std::int64_t, ObjectId>> order;
  order.reserve(document.objects().size());
  for (const auto& [id, placed] : document.objects()) order.emplace_back(placed.object->order, id);
  std::sort(order.rbegin(), order.rend());
  state.objects.clear();
  state.objects.reserve(order.size());
  for (const auto& [place, id] : order) state.objects.push_back(id);
  state.steps.clear();
  state.fault.clear();
  const std::int64_t here = desk.sheet().step();
  auto steps =
      desk.sheet().history(std::max<std::int64_t>(1, here - kMostSteps + 1), 2 * kMostSteps);
  if (steps) {
    state.steps = std::move(*steps);
    std::reverse(state.steps.begin(), state.steps.end());
  } else {
    state.fault = steps.error().message;
  }
}

std::string name_of_object(const LabelObject& object) {
  std::string name = fmt::format("{} {}", enum_name(object.kind), object.id);
  if (!object.note.empty()) name += ": " + object.note.substr(0, object.note.find('\n'));
  return name;
}

void draw_object_row(kit::Ui& ui, const LabelDesk& desk, ObjectId id, Actions& asked) {
  const auto object = desk.sheet().now().object(id);
  if (object == nullptr) return;
  kit::ListRow row;
  row.colour = class_colour(object->class_id);
  row.detail = std::string(class_info(object->class_id).name);
  row.is_selected = desk.selection().contains(id);
  row.hint = {fmt::format("{}: {}", class_info(object->class_id).name, name_of_object(*object)), "",
              "", "A click selects it, with Ctrl beside others; a double click shows it"};
  const auto input = ui.list_row(label_of(name_of_object(*object), fmt::format("{}", id)), row);
  if (input.was_clicked) {
    NumberList list;
    if (input.modifiers.ctrl) list.numbers = desk.selection().ids();
    const auto found = std::find(list.numbers.begin(), list.numbers.end(), id);
    if (found != list.numbers.end()) {
      list.numbers.erase(found);
    } else {
      list.numbers.push_back(id);
    }
    asked.emplace_back(actions::SelectLabels{std::move(list)});
  }
  if (!input.was_double_clicked) return;
  const PlaneBounds& bounds = desk.sheet().now().objects().at(id).bounds;
  const Eigen::Vector2d middle = 0.5 * (bounds.low + bounds.high);
  constexpr double kRoomAroundObject = 3.0, kLeastWidthM = 10.0;
  const double width_m =
      std::max(kLeastWidthM, kRoomAroundObject * (bounds.high - bounds.low).maxCoeff());
  asked.emplace_back(actions::LookAt{middle.x(), middle.y(), width_m});
}

void draw_objects(kit::Ui& ui, const LabelDesk& desk, LabelSideState& state, Actions& asked) {
  for (Action& action : draw_label_selection(ui, desk)) asked.push_back(std::move(action));
  ui.space();
  const auto typed =
      ui.search_input("Search", state.search, {.placeholder = "class, kind, number or note"});
  state.search = typed.value;
  std::vector<ObjectId> found;
  if (!state.search.empty()) {
    for (const ObjectId id : state.objects) {
      const auto object = desk.sheet().now().object(id);
      if (object == nullptr) continue;
      const std::string words =
          fmt::format("{} {}", class_info(object->class_id).name, name_of_object(*object));
      if (has_words(words, state.search)) found.push_back(id);
    }
  }
  const std::vector<ObjectId>& shown = state.search.empty() ? state.objects : found;
  ui.text(fmt::format("{} objects, the top-most first", shown.size()), kit::TextLook::kMuted);
  const auto list = ui.scroll_area("List");
  if (state.objects.empty()) {
    ui.wrapped(
        desk.sheet().now().paint().empty()
            ? "No objects yet: take a tool and draw."
            : "No objects yet. What labels.tif held is paint: it is drawn on like any other.",
        kit::TextLook::kMuted);
  }
  ui.clipped_rows(shown.size(), ui.px(kLabelRowHeight),
                  [&](std::size_t i) { draw_object_row(ui, desk, shown[i], asked); });
}

/// "2026-11-23T20:15:02Z" as "23 Nov 20:15" would hide the year: its date and minute.
std::string time_text(const std::string& iso) {
  return iso.size() >= 16 ? iso.substr(0, 10) + " " + iso.substr(11, 5) : iso;
}

void draw_history(kit::Ui& ui, const LabelDesk& desk, const LabelSideState& state, Actions& asked) {
  if (!state.fault.empty()) return ui.wrapped(state.fault, kit::TextLook::kBad);
  if (state.steps.empty()) {
    return ui.wrapped(
        "Nothing has been drawn yet. Every stroke will be a line here; a click goes "
        "back to it, also after closing.",
        kit::TextLook::kMuted);
  }
  ui.wrapped(
      "A click goes to that step. Drawing from there begins a branch; what was undone stays "
      "in the list.",
      kit::TextLook::kMuted);
  const auto list = ui.scroll_area("List");
  const std::int64_t here = desk.sheet().step();
  ui.clipped_rows(state.steps.size() + 1, ui.px(kLabelRowHeight), [&](std::size_t i) {
    const bool is_beginning = i == state.steps.size();
    const std::int64_t number = is_beginning ? 0 : state.steps[i].number;
    kit::ListRow row;
    row.is_selected = number == here;
    std::string title = "Before the first";
    if (!is_beginning) {
      const LabelStep& step = state.steps[i];
      title = step.title.empty() ? "Edit" : step.title;
      row.detail = time_text(step.time);
      row.look = number > here ? kit::TextLook::kMuted : kit::TextLook::kNormal;
      row.hint = {fmt::format("{}: {}, {} UTC", step.number, step.author, step.time), ""};
    }
    if (ui.list_row(label_of(title, fmt::format("{}", number)), row).was_clicked &&
        number != here) {
      asked.emplace_back(actions::GoToLabelStep{number});
    }
  });
}

void draw_image(kit::Ui& ui, const LabelSideModel& model) {
  const LabelSheet& sheet = model.desk->sheet();
  const LabelDocument& document = sheet.now();
  const LabelGrid& grid = document.grid();
  const auto origin = document.plane().origin();
  ui.read_out("picture", sheet.image().empty() ? "none" : sheet.image().filename().string(), "",
              {sheet.image().string(), ""}, kit::TextLook::kNormal);
  ui.read_out("document", sheet.path().filename().string(), "", {sheet.path().string(), ""},
              kit::TextLook::kNormal);
  ui.read_out("cells", fmt::format("{} x {}", grid.width, grid.height));
  ui.read_out("cell", fmt::format("{:.4g}", grid.metres_per_cell), "m",
              {"Side of a cell on the ground: what the localiser reads", ""});
  ui.read_out("width", fmt::format("{:.1f}", grid.width * grid.metres_per_cell), "m");
  ui.read_out("height", fmt::format("{:.1f}", grid.height * grid.metres_per_cell), "m");
  ui.read_out("latitude", fmt::format("{:.7f}", origin.latitude_deg), "°",
              {"Of the project plane's origin, WGS 84", ""});
  ui.read_out("longitude", fmt::format("{:.7f}", origin.longitude_deg), "°",
              {"Of the project plane's origin, WGS 84", ""});
  for (const std::string& notice : sheet.notices()) ui.wrapped(notice, kit::TextLook::kMuted);
}

}  // namespace

LabelSideModel label_side_model(const Session& session) {
  return {session.label_view(), session.label_desk()};
}

Actions draw_label_side(kit::Ui& ui, const LabelSideModel& model, LabelSideState& state) {
  const auto scope = ui.scope("Beside labels");
  Actions asked;
  std::vector<std::string> titles;
  std::size_t chosen = 0;
  for (std::size_t i = 0; i < kTabs.size(); ++i) {
    titles.emplace_back(kTabs.at(i).second);
    if (kTabs.at(i).first == model.view.tab) chosen = i;
  }
  if (const auto other = ui.tabs("Tabs", titles, chosen)) {
    asked.emplace_back(actions::ShowLabelTab{kTabs.at(*other).first});
  }
  if (model.desk == nullptr) {
    for (Action& action : draw_empty_state(ui, reading_state(name_of(model.view.path)))) {
      asked.push_back(std::move(action));
    }
    return asked;
  }
  follow(*model.desk, state);
  switch (kTabs.at(chosen).first) {
    case LabelTab::kHistory:
      draw_history(ui, *model.desk, state, asked);
      break;
    case LabelTab::kImage:
      draw_image(ui, model);
      break;
    default:
      draw_objects(ui, *model.desk, state, asked);
      break;
  }
  return asked;
}

}  // namespace nadir
