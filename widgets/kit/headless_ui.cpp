// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/headless_ui.h"

#include <algorithm>
#include <stdexcept>

#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr int kDragFrames = 4;
/// Longer than two clicks of one double click may lie apart.
constexpr double kBetweenGesturesS = 0.5;

}  // namespace

HeadlessUi::HeadlessUi(ThemeName theme, double scale, const Eigen::Vector2d& size_px)
    : context_(theme, scale) {
  input_.size_px = size_px;
  context_.set_motion_reduced(true);
}

Ui& HeadlessUi::begin() {
  Ui& ui = context_.begin_frame(input_);
  if (has_region_) {
    RegionStyle style;
    style.has_scroll = true;
    region_.emplace(ui.region("", ui.screen(), style));
  }
  return ui;
}

void HeadlessUi::end() {
  region_.reset();
  context_.end_frame();
  input_.wheel.setZero();
  input_.characters.clear();
  input_.delta_s = 1.0 / 60.0;
}

void HeadlessUi::give_up() {
  region_.reset();
  context_.abandon_frame();
}

void HeadlessUi::settle(const std::function<void()>& draw_frame) {
  draw_frame();
  draw_frame();
}

void HeadlessUi::prepare(const Step& step) {
  if (step) step(*this);
}

const Control* HeadlessUi::find(const std::string& path) const {
  const auto& all = context_.controls();
  const auto found = std::find_if(all.begin(), all.end(),
                                  [&path](const Control& control) { return control.path == path; });
  return found == all.end() ? nullptr : &*found;
}

const Control& HeadlessUi::at(const std::string& path) const {
  if (const Control* const found = find(path)) return *found;
  std::string known;
  for (const Control& control : context_.controls()) {
    if (control.kind != ControlKind::kText) known += "\n  " + control.path;
  }
  throw std::logic_error("there is no control '" + path + "'; there are:" + known);
}

const Control& HeadlessUi::target(const std::string& path) const {
  const Control& control = at(path);
  if (!control.is_enabled) throw std::logic_error("'" + path + "' is disabled: " + control.tooltip);
  return control;
}

bool HeadlessUi::shows(const std::string& words) const {
  const auto& all = context_.controls();
  return std::any_of(all.begin(), all.end(), [&words](const Control& control) {
    return control.label.find(words) != std::string::npos ||
           control.value.find(words) != std::string::npos;
  });
}

std::string HeadlessUi::words() const {
  std::string all;
  for (const Control& control : context_.controls())
    all += control.path + (control.value.empty() ? "" : ": " + control.value) + "\n";
  return all;
}

std::string HeadlessUi::tooltip() const { return context_.state().tooltip; }

/// Frames that open the menus and lists on the way, scroll, and put the mouse over the control.
std::vector<HeadlessUi::Step> HeadlessUi::way_to(const std::string& path) {
  std::vector<Step> steps;
  for (std::size_t slash = path.find('/'); slash != std::string::npos;
       slash = path.find('/', slash + 1)) {
    const std::string before = path.substr(0, slash);
    const auto opens = [before, path](const HeadlessUi& screen) {
      const Control* const control = screen.find(before);
      return control != nullptr && screen.find(path) == nullptr && control->value != "open" &&
             (control->kind == ControlKind::kMenu || control->kind == ControlKind::kCombo ||
              control->kind == ControlKind::kSection || control->kind == ControlKind::kColour);
    };
    steps.push_back([before, opens](HeadlessUi& screen) {
      screen.is_opening_ = opens(screen);
      if (screen.is_opening_) screen.input_.mouse_px = screen.target(before).rect.centre();
    });
    steps.push_back([](HeadlessUi& screen) { screen.input_.buttons[0] = screen.is_opening_; });
    steps.push_back([](HeadlessUi& screen) { screen.input_.buttons[0] = false; });
    steps.emplace_back();
    steps.emplace_back();
  }
  steps.push_back([path](HeadlessUi& screen) {
    if (!screen.target(path).is_visible) screen.context_.scroll_to(path);
    screen.input_.delta_s = kBetweenGesturesS;
  });
  steps.emplace_back();
  steps.emplace_back();
  steps.push_back(
      [path](HeadlessUi& screen) { screen.input_.mouse_px = screen.target(path).rect.centre(); });
  return steps;
}

std::vector<HeadlessUi::Step> HeadlessUi::clicks_here(MouseButton button, int clicks) {
  std::vector<Step> steps;
  const auto index = static_cast<std::size_t>(button);
  for (int i = 0; i < clicks; ++i) {
    steps.push_back([index](HeadlessUi& screen) { screen.input_.buttons.at(index) = true; });
    steps.push_back([index](HeadlessUi& screen) { screen.input_.buttons.at(index) = false; });
  }
  steps.push_back([](HeadlessUi& screen) { screen.input_.modifiers = {}; });
  return steps;
}

std::vector<HeadlessUi::Step> HeadlessUi::click_steps(const std::string& path,
                                                      MouseButton button,
                                                      int clicks,
                                                      Modifiers modifiers) {
  std::vector<Step> steps = way_to(path);
  steps.push_back([modifiers](HeadlessUi& screen) { screen.input_.modifiers = modifiers; });
  for (Step& step : clicks_here(button, clicks)) steps.push_back(std::move(step));
  return steps;
}

std::vector<HeadlessUi::Step> HeadlessUi::click_at_steps(const std::string& path,
                                                         const Eigen::Vector2d& at,
                                                         MouseButton button,
                                                         Modifiers modifiers) {
  std::vector<Step> steps = way_to(path);
  steps.push_back([path, at, modifiers](HeadlessUi& screen) {
    const Rect& rect = screen.target(path).rect;
    screen.input_.mouse_px = Eigen::Vector2d(rect.left, rect.top) + at;
    screen.input_.modifiers = modifiers;
  });
  for (Step& step : clicks_here(button, 1)) steps.push_back(std::move(step));
  return steps;
}

std::vector<HeadlessUi::Step> HeadlessUi::reset_steps(const std::string& path) {
  std::vector<Step> steps = way_to(path);
  steps.push_back([path](HeadlessUi& screen) {
    screen.input_.mouse_px = screen.target(path).label_rect.centre();
  });
  for (Step& step : clicks_here(MouseButton::kLeft, 2)) steps.push_back(std::move(step));
  return steps;
}

std::vector<HeadlessUi::Step> HeadlessUi::drag_steps(const std::string& path,
                                                     const Eigen::Vector2d& by,
                                                     MouseButton button,
                                                     Modifiers modifiers) {
  const auto index = static_cast<std::size_t>(button);
  std::vector<Step> steps = way_to(path);
  steps.push_back([index, modifiers](HeadlessUi& screen) {
    screen.input_.modifiers = modifiers;
    screen.input_.buttons.at(index) = true;
  });
  for (int i = 0; i < kDragFrames; ++i) {
    steps.push_back([by](HeadlessUi& screen) {
      screen.input_.mouse_px = *screen.input_.mouse_px + by / kDragFrames;
    });
  }
  steps.push_back([index](HeadlessUi& screen) { screen.input_.buttons.at(index) = false; });
  steps.push_back([](HeadlessUi& screen) { screen.input_.modifiers = {}; });
  return steps;
}

std::vector<HeadlessUi::Step> HeadlessUi::scroll_steps(const std::string& path,
                                                       double notches,
                                                       Modifiers modifiers) {
  std::vector<Step> steps = way_to(path);
  steps.push_back([notches, modifiers](HeadlessUi& screen) {
    screen.input_.modifiers = modifiers;
    screen.input_.wheel.y() = notches;
  });
  steps.push_back([](HeadlessUi& screen) { screen.input_.modifiers = {}; });
  return steps;
}

std::vector<HeadlessUi::Step> HeadlessUi::type_here_steps(const std::string& text) {
  return {[text](HeadlessUi& screen) { screen.input_.characters = text; }, Step()};
}

std::vector<HeadlessUi::Step> HeadlessUi::type_steps(const std::string& path,
                                                     const std::string& text,
                                                     bool with_enter) {
  std::vector<Step> steps = way_to(path);
  // Numbers take text after Ctrl and click; in an input that selects all of it.
  steps.push_back([path](HeadlessUi& screen) {
    // A slider's number lies beside its track.
    if (const Control* const value = screen.find(path + "/value"); value != nullptr)
      screen.input_.mouse_px = value->rect.centre();
    screen.input_.modifiers.ctrl = true;
  });
  for (Step& step : clicks_here(MouseButton::kLeft, 1)) steps.push_back(std::move(step));
  for (Step& step : press_steps("Ctrl+A")) steps.push_back(std::move(step));
  if (text.empty()) {
    for (Step& step : press_steps("Delete")) steps.push_back(std::move(step));
  } else {
    for (Step& step : type_here_steps(text)) steps.push_back(std::move(step));
  }
  if (with_enter) {
    for (Step& step : press_steps("Enter")) steps.push_back(std::move(step));
  }
  return steps;
}

std::vector<HeadlessUi::Step> HeadlessUi::press_steps(const std::string& chord) {
  const auto parsed = parse_chord(chord);
  if (!parsed) throw std::logic_error("'" + chord + "' is no chord");
  Key key = parsed->key;
  if (parsed->character != 0 && parsed->modifiers.ctrl)
    key = parsed->character == '+' ? Key::kEqual : static_cast<Key>(parsed->character);
  return {[chord = *parsed, key](HeadlessUi& screen) {
            screen.input_.modifiers = chord.modifiers;
            if (key != Key::kNone) screen.input_.keys = {key};
            if (chord.modifiers.ctrl || chord.modifiers.alt) return;
            if (chord.character != 0) screen.input_.characters = std::string(1, chord.character);
            const auto code = static_cast<int>(key);
            if (code >= 32 && code < 127)
              screen.input_.characters = std::string(
                  1, static_cast<char>(
                         chord.modifiers.shift || code < 'A' || code > 'Z' ? code : code + 32));
          },
          [](HeadlessUi& screen) {
            screen.input_.modifiers = {};
            screen.input_.keys.clear();
          }};
}

std::vector<HeadlessUi::Step> HeadlessUi::hover_steps(const std::string& path) {
  std::vector<Step> steps;
  steps.push_back([path](HeadlessUi& screen) {
    if (!screen.at(path).is_visible) screen.context_.scroll_to(path);
  });
  steps.emplace_back();
  steps.emplace_back();
  steps.push_back(
      [path](HeadlessUi& screen) { screen.input_.mouse_px = screen.at(path).rect.centre(); });
  for (int i = 0; i < 3; ++i) {
    steps.push_back([](HeadlessUi& screen) { screen.input_.delta_s = kBetweenGesturesS; });
  }
  return steps;
}

}  // namespace nadir::kit
