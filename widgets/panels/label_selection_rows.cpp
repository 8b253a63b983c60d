// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/desk/label_desk.h"
#include "widgets/panels/label_side_panel.h"
#include "widgets/panels/map_geometry.h"
#include "widgets/panels/shortcut_hint.h"

namespace nadir {
namespace {

double ring_length_m(const Ring& ring, bool is_closed) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < ring.size(); ++i) length_m += (ring[i] - ring[i - 1]).norm();
  if (is_closed && ring.size() > 2) length_m += (ring.front() - ring.back()).norm();
  return length_m;
}

double ring_area_m2(const Ring& ring) {
  if (ring.empty()) return 0.0;
  double twice_m2 = 0.0;  // about the first place, so that large coordinates cost no digits
  for (std::size_t i = 1; i + 1 < ring.size(); ++i) {
    const Eigen::Vector2d a = ring[i] - ring.front(), b = ring[i + 1] - ring.front();
    twice_m2 += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * std::abs(twice_m2);
}

/// All objects that are selected.
std::vector<std::shared_ptr<const LabelObject>> selected(const LabelDesk& desk) {
  std::vector<std::shared_ptr<const LabelObject>> objects;
  for (const ObjectId id : desk.selection().ids()) {
    if (auto object = desk.sheet().now().object(id)) objects.push_back(std::move(object));
  }
  return objects;
}

void draw_class_choice(kit::Ui& ui,
                       const std::vector<std::shared_ptr<const LabelObject>>& objects,
                       Actions& asked) {
  std::vector<std::string> names;
  std::size_t chosen = 0;
  const bool are_alike = std::all_of(objects.begin(), objects.end(), [&](const auto& object) {
    return object->class_id == objects.front()->class_id;
  });
  if (!are_alike) names.emplace_back("several classes");
  for (int id = 0; id <= kClassCount; ++id) {
    const auto of = id == kClassCount ? ClassId{kUnclassified} : static_cast<ClassId>(id);
    if (id < kClassCount && (!can_lie_in_overhead(of) || is_movable(of))) continue;
    if (are_alike && of == objects.front()->class_id) chosen = names.size();
    names.emplace_back(class_info(of).name);
  }
  const auto other = ui.combo("class", names, chosen, {"Class of all that is selected", ""});
  if (other && (are_alike || *other > 0)) {
    asked.emplace_back(actions::SetLabel{LabelPart::kClass, names[*other]});
  }
}

void draw_width(kit::Ui& ui,
                const std::vector<std::shared_ptr<const LabelObject>>& objects,
                Actions& asked) {
  const auto first = std::find_if(objects.begin(), objects.end(), [](const auto& object) {
    return object->kind != ObjectKind::kArea;
  });
  if (first == objects.end()) return;
  kit::NumberOptions options;
  options.least = 0.01;
  options.most = kMostObjectWidthM;
  options.unit = "m";
  options.hint = {"Width of lines, thickness of outlines", ""};
  const auto edit = ui.number_input("width", (*first)->width_m, options);
  if (edit.was_committed) {
    asked.emplace_back(actions::SetLabel{LabelPart::kWidth, fmt::format("{}", edit.value)});
  }
}

struct Deed {
  const char* title;
  LabelCommand command;
  const char* help;
  std::size_t least;  ///< That must be selected.
};
constexpr std::array kDeeds = {
    Deed{"Merge", LabelCommand::kMerge, "Make one of all that touch each other", 2},
    Deed{"Subtract", LabelCommand::kSubtract, "Take all others from the one selected first", 2},
    Deed{"Clip", LabelCommand::kClip, "Take away what neighbours of its level and above cover", 1},
    Deed{"Clip others", LabelCommand::kClipOthers, "Take what it covers from its neighbours", 1},
    Deed{"Square", LabelCommand::kSquare, "Make angles right that nearly are", 1},
    Deed{"Smooth", LabelCommand::kSmooth, "Round corners", 1},
    Deed{"Simplify", LabelCommand::kSimplify, "Leave out corners that hardly matter", 1},
    Deed{"Raise", LabelCommand::kUp, "Above the next that it meets", 1},
    Deed{"Lower", LabelCommand::kDown, "Below the next that it meets", 1},
    Deed{"To paint", LabelCommand::kToPaint, "Turn it into painted cells", 1},
    Deed{"Delete", LabelCommand::kDelete, "Delete what is selected", 1}};

void draw_deeds(kit::Ui& ui, std::size_t count, Actions& asked) {
  const auto scope = ui.scope("Do");
  bool is_first = true;
  for (const Deed& deed : kDeeds) {
    if (!is_first) ui.same_line(ui.px(4.0));
    is_first = false;
    const Action wish = actions::EditLabels{deed.command};
    const auto pale = ui.disabled(count < deed.least, "Select two or more first");
    if (ui.button(deed.title, kit::ButtonLook::kQuiet, hint_for(deed.help, wish))) {
      asked.push_back(wish);
    }
  }
}

}  // namespace

double border_length_m(const LabelObject& object) {
  double length_m = 0.0;
  for (const Ring& ring : object.rings) {
    length_m += ring_length_m(ring, object.kind != ObjectKind::kLine);
  }
  return length_m;
}

double ground_area_m2(const LabelObject& object) {
  if (object.kind == ObjectKind::kLine) return border_length_m(object) * object.width_m;
  double area_m2 = 0.0;
  for (std::size_t i = 0; i < object.rings.size(); ++i) {
    area_m2 += (i == 0 ? 1.0 : -1.0) * ring_area_m2(object.rings[i]);
  }
  return std::max(0.0, area_m2);
}

Actions draw_label_selection(kit::Ui& ui, const LabelDesk& desk) {
  const auto scope = ui.scope("Selection");
  const auto objects = selected(desk);
  if (objects.empty()) {
    ui.wrapped("Nothing is selected: with the tool Select click an object, or draw a box.",
               kit::TextLook::kMuted);
    return {};
  }
  Actions asked;
  double length_m = 0.0, area_m2 = 0.0;
  for (const auto& object : objects) {
    length_m += border_length_m(*object);
    area_m2 += ground_area_m2(*object);
  }
  ui.heading(objects.size() == 1
                 ? fmt::format("{} {}", enum_name(objects.front()->kind), objects.front()->id)
                 : fmt::format("{} objects", objects.size()));
  draw_class_choice(ui, objects, asked);
  draw_width(ui, objects, asked);
  ui.read_out("border", fmt::format("{:.2f}", length_m), "m",
              {"Length of lines, and around areas with their holes", ""});
  ui.read_out("area", area_text(area_m2), "", {"Of lines their length times their width", ""});
  {
    kit::TextOptions options;
    options.placeholder = "note";
    options.hint = {"Whatever the next one should know of it", ""};
    const auto edit = ui.text_input("note", objects.front()->note, options);
    if (edit.was_committed) asked.emplace_back(actions::SetLabel{LabelPart::kNote, edit.value});
  }
  draw_deeds(ui, objects.size(), asked);
  return asked;
}

}  // namespace nadir
