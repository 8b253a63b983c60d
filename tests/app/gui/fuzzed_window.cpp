// SPDX-License-Identifier: Apache-2.0
#include "tests/app/gui/fuzzed_window.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <sstream>
#include <stdexcept>

#include "core/session/commands.h"
#include "tests/app/gui/session_truths.h"

namespace nadir {
namespace {

using Clock = std::chrono::steady_clock;

double since_s(Clock::time_point began) {
  return std::chrono::duration<double>(Clock::now() - began).count();
}

/// As scripts hold a word together.
std::string quoted_word(const std::string& word) {
  std::ostringstream text;
  text << std::quoted(word);
  return text.str();
}

}  // namespace

FuzzedWindow::FuzzedWindow(GuiRequest request, std::filesystem::path trail)
    : request_(std::move(request)), trail_(trail) {
  input_.size_px = {1.0 * request_.width, 1.0 * request_.height};
  auto renderer = kit::UiRenderer::create(context_);
  if (!renderer) throw std::runtime_error(renderer.error().message);
  renderer_ = std::move(*renderer);
  shell_ = std::make_unique<GuiShell>(
      request_, [this](const std::string& text) { context_.set_clipboard(text); });
}

FuzzedWindow::~FuzzedWindow() = default;

void FuzzedWindow::note(const std::string& line) { trail_ << line << std::endl; }

void FuzzedWindow::frame() {
  const auto began = Clock::now();
  context_.set_look(shell_->theme_name(), shell_->scale(1.0));
  context_.set_motion_reduced(session().view().appearance.is_motion_reduced);
  kit::Ui& ui = context_.begin_frame(input_);
  try {
    shell_->frame(ui, input_.delta_s);
  } catch (...) {
    context_.abandon_frame();
    throw;
  }
  context_.end_frame();
  constexpr int kBetweenPictures = 20;
  if (++frames_ % kBetweenPictures == 0) {  // the rest is triangles that nobody looks at
    const auto pixels = renderer_->draw_to_pixels();
    if (!pixels) throw std::runtime_error(pixels.error().message);
  }
  longest_frame_s_ = std::max(longest_frame_s_, since_s(began));
  input_.wheel.setZero();
  input_.characters.clear();
}

void FuzzedWindow::draw(int frames) {
  for (int i = 0; i < frames; ++i) frame();
}

bool FuzzedWindow::settle(double most_s) {
  const auto began = Clock::now();
  for (int at_rest = 0; at_rest < 3; at_rest = shell_->is_busy() ? 0 : at_rest + 1) {
    if (since_s(began) > most_s) return false;
    frame();
  }
  return true;
}

void FuzzedWindow::act(const std::string& line) { act_at_once({line}); }

void FuzzedWindow::act_at_once(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    note(line);
    const auto began = Clock::now();
    if (const auto action = parse_action(line)) {
      asked_.emplace_back(action_name(*action));
      if (const auto done = session().apply(*action)) {
        done_.emplace_back(action_name(*action));
      } else {
        last_refusal_ = line + ": " + done.error().message;
      }
    }
    longest_frame_s_ = std::max(longest_frame_s_, since_s(began));
  }
  frame();
}

kit::Control FuzzedWindow::some_control(FuzzWords& words) const {
  std::vector<const kit::Control*> seen;
  for (const kit::Control& control : context_.controls()) {
    const bool is_in_sight =
        control.is_visible && control.rect.width > 0.0 && control.rect.height > 0.0;
    if (is_in_sight && control.kind != kit::ControlKind::kText) seen.push_back(&control);
  }
  return seen.empty() ? kit::Control{} : *words.one_of(seen);
}

bool FuzzedWindow::would_write(const std::string& path) {
  const Overlay overlay = session().overlay();
  return (overlay == Overlay::kExport || overlay == Overlay::kSaveRecipe) &&
         path.ends_with("##take");
}

void FuzzedWindow::use_mouse(FuzzWords& words) {
  const kit::Control control = some_control(words);
  if (would_write(control.path)) return;
  const auto anywhere = [&words](double from, double length) {
    return from + length * words.between(0.0, 1.0);
  };
  input_.mouse_px = words.chance(0.5)
                        ? control.rect.centre()
                        : Eigen::Vector2d(anywhere(control.rect.left, control.rect.width),
                                          anywhere(control.rect.top, control.rect.height));
  if (words.chance(0.2)) input_.modifiers = {words.chance(0.5), words.chance(0.5), false, false};
  const std::size_t button = words.chance(0.8) ? 0 : 1 + words.below(2);
  const auto set_button = [&](bool is_down) {
    input_.buttons.at(button) = is_down;
    frame();
  };
  frame();
  switch (words.below(6)) {
    case 0:
    case 1:
    case 2:
      note((button == 1 ? "right-click " : "click ") + quoted_word(control.path));
      set_button(true);
      set_button(false);
      break;
    case 3:
      note("double-click " + quoted_word(control.path));
      for (const bool is_down : {true, false, true, false}) set_button(is_down);
      break;
    case 4: {
      const Eigen::Vector2d by(words.between(-300.0, 300.0), words.between(-200.0, 200.0));
      note(fmt::format("drag {} {:.0f} {:.0f}", quoted_word(control.path), by.x(), by.y()));
      set_button(true);
      for (int i = 0; i < 3; ++i) {
        *input_.mouse_px += by / 3.0;
        frame();
      }
      set_button(false);
      break;
    }
    default:
      note("scroll " + quoted_word(control.path) + " 3");
      input_.wheel = {words.between(-1.0, 1.0), words.between(-8.0, 8.0)};
      frame();
      break;
  }
  input_.modifiers = {};
  frame();
  if (words.chance(0.1)) input_.mouse_px.reset();
}

void FuzzedWindow::use_keys(FuzzWords& words) {
  std::vector<std::string> chords = {"Escape", "Enter",  "Tab",       "Backspace", "Up",
                                     "Down",   "Left",   "Page Down", "Delete",    "Ctrl+A",
                                     "Ctrl+X", "Ctrl+V", "Escape",    "Enter"};
  for (const Command& command : session_commands()) {
    if (!command.shortcut.empty()) chords.emplace_back(command.shortcut);
  }
  if (words.chance(0.35)) {
    const std::string typed = words.text();
    note("# types " + quoted_word(typed));
    input_.characters = typed;
    frame();
    if (words.chance(0.5)) return frame();
  }
  const std::string& text = words.one_of(chords);
  if (text == "Enter" && would_write("##take")) return frame();
  const auto chord = kit::parse_chord(text);
  if (!chord) throw std::logic_error(text + " is no chord");
  note("press " + text);
  input_.modifiers = chord->modifiers;
  if (chord->key != kit::Key::kNone) input_.keys = {chord->key};
  if (chord->character != 0) input_.characters = std::string(1, chord->character);
  draw(words.chance(0.1) ? 8 : 1);
  input_.modifiers = {};
  input_.keys.clear();
  frame();
}

void FuzzedWindow::resize(FuzzWords& words) {
  static const std::vector<Eigen::Vector2d> kSizes = {
      {800.0, 500.0}, {320.0, 200.0}, {1280.0, 800.0}, {200.0, 900.0}, {1400.0, 210.0}};
  input_.size_px = words.one_of(kSizes);
  note(fmt::format("resize {} {}", input_.size_px.x(), input_.size_px.y()));
  draw(2);
}

std::string FuzzedWindow::fault_of_controls() const {
  for (const kit::Control& control : context_.controls()) {
    const kit::Rect& rect = control.rect;
    const bool is_place = std::isfinite(rect.left) && std::isfinite(rect.top) &&
                          std::isfinite(rect.width) && std::isfinite(rect.height);
    if (!is_place) return fmt::format("'{}' is nowhere", control.path);
  }
  return "";
}

std::string FuzzedWindow::leave_and_come_back() {
  note("# leaves and comes back");
  asked_.emplace_back("quit");
  done_.emplace_back("quit");
  const bool is_at_work = !session().jobs().empty();
  const ViewState before = session().view();
  const std::vector<std::string> layouts = session().layout_names();
  shell_.reset();
  request_.files.clear();
  shell_ = std::make_unique<GuiShell>(
      request_, [this](const std::string& text) { context_.set_clipboard(text); });
  frame();
  if (session().layout_names() != layouts) return "the next start has lost layouts";
  if (is_at_work || session().view() == before) return "";
  std::string notices;
  for (const Notice& notice : session().notices()) notices += notice.text + "\n";
  return "the next start does not show what the last one has left\n" + notices;
}

std::string FuzzedWindow::do_something(FuzzWords& words) {
  const std::size_t what = words.below(20);
  if (what < 10) {
    act(words.chance(0.02) ? action_text(actions::PasteView{context_.clipboard()})
                           : words.action());
  } else if (what < 15) {
    use_mouse(words);
  } else if (what < 19) {
    use_keys(words);
  } else {
    resize(words);
  }
  if (shell_->wants_to_quit()) {
    if (std::string fault = leave_and_come_back(); !fault.empty()) return fault;
  }
  if (std::string fault = fault_of(session()); !fault.empty()) return fault;
  if (words.chance(0.15)) {
    if (std::string fault = fault_of_undo(session()); !fault.empty()) return fault;
    frame();
    if (std::string fault = fault_of(session()); !fault.empty()) return fault;
  }
  return fault_of_controls();
}

}  // namespace nadir
