// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/input_queue.h"

#include <algorithm>
#include <cstdint>

namespace nadir::kit {
namespace {

using EventKind = WindowEvent::Kind;

constexpr int kLeftShiftKey = 340, kModifierKinds = 4, kRightSuperKey = 347;
/// The mouse trembles while its wheel is turned.
constexpr double kTremblePx = 4.0;
/// A shortcut's work is done at the end of its frame; what it opened is there in the next, and takes text from then on.
constexpr int kFramesToOpen = 2;
/// A hand that moves the mouse far while it turns the wheel makes more of that than frames can keep apart.
constexpr std::size_t kManyEvents = 64;

bool is_modifier(int key) { return key >= kLeftShiftKey && key <= kRightSuperKey; }
bool is_printable(int key) { return key >= ' ' && key < 256; }

std::string utf8_of(int character) {
  const auto code = static_cast<std::uint32_t>(character);
  const auto tail = [code](unsigned shift) {
    return static_cast<char>(0x80U | ((code >> shift) & 0x3FU));
  };
  if (code < 0x80U) return {static_cast<char>(code)};
  if (code < 0x800U) return {static_cast<char>(0xC0U | (code >> 6U)), tail(0)};
  if (code < 0x10000U) return {static_cast<char>(0xE0U | (code >> 12U)), tail(6), tail(0)};
  return {static_cast<char>(0xF0U | (code >> 18U)), tail(12), tail(6), tail(0)};
}

/// The state of the modifier `kind` (0 shift, 1 control, 2 alt, 3 super) as the keys of both sides say.
bool is_modifier_held(const std::vector<int>& keys, int kind) {
  return std::any_of(keys.begin(), keys.end(),
                     [kind](int key) { return (key - kLeftShiftKey) % kModifierKinds == kind; });
}

}  // namespace

struct InputQueue::Told {
  std::vector<int> keys;  ///< That changed.
  bool has_press = false, has_button = false, has_wheel = false, has_text = false;
  bool has_moved = false;
  int character = 0;  ///< The last one.
  std::optional<Eigen::Vector2d> mouse_before;

  [[nodiscard]] bool knows(int key) const {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
  }
  /// Farther than a hand trembles.
  [[nodiscard]] bool is_far(const std::optional<Eigen::Vector2d>& mouse) const {
    if (!mouse || !mouse_before) return mouse.has_value() != mouse_before.has_value();
    return (*mouse - *mouse_before).norm() > kTremblePx;
  }
};

void InputQueue::add(const std::vector<WindowEvent>& events) {
  for (const WindowEvent& event : events) merge(event);
}

void InputQueue::merge(const WindowEvent& event) {
  const bool is_button = event.kind == EventKind::kButton;
  if (is_button && (event.code < 0 || event.code >= static_cast<int>(frame_.buttons.size()))) {
    return;
  }
  if (!waiting_.empty() && waiting_.back().kind == event.kind) {
    WindowEvent& last = waiting_.back();
    if (event.kind == EventKind::kWheel) {
      last.at += event.at;
      return;
    }
    if (event.kind == EventKind::kMouse && last.is_down == event.is_down) {
      last = event;
      return;
    }
  }
  waiting_.push_back(event);
}

FrameInput InputQueue::next(bool is_typing) {
  Told told;
  told.mouse_before = frame_.mouse_px;
  frame_.wheel.setZero();
  frame_.characters.clear();
  frames_since_press_ = std::min(frames_since_press_ + 1, kManyFrames);
  while (!waiting_.empty() && fits(waiting_.front(), told, is_typing)) {
    tell(waiting_.front(), told, is_typing);
    waiting_.pop_front();
  }
  return frame_;
}

/// Pressing it says no more than the character that follows.
bool InputQueue::is_letter(const WindowEvent& event, bool is_typing) const {
  const Modifiers& held = frame_.modifiers;
  return is_typing && event.is_down && is_printable(event.code) && !held.ctrl && !held.alt &&
         !held.super;
}

bool InputQueue::fits(const WindowEvent& event, const Told& told, bool is_typing) const {
  const bool is_late = waiting_.size() > kManyEvents;
  switch (event.kind) {
    case EventKind::kMouse: {
      const auto to = event.is_down ? std::optional(event.at) : std::nullopt;
      return !told.has_button && (!told.has_wheel || !told.is_far(to) || is_late);
    }
    case EventKind::kButton:
      return !told.has_moved && !told.has_wheel && !told.has_text && !told.has_press &&
             !told.has_button;
    case EventKind::kWheel:
      return !told.has_button && (!told.is_far(frame_.mouse_px) || is_late);
    case EventKind::kKey:
      return fits_key(event, told, is_typing);
    case EventKind::kCharacter:
      if (told.has_button) return false;
      if (is_typing) return !told.has_press;
      if (told.has_text) return event.code == told.character;
      return told.has_press || frames_since_press_ >= kFramesToOpen;
  }
  return true;
}

bool InputQueue::fits_key(const WindowEvent& event, const Told& told, bool is_typing) const {
  if (is_letter(event, is_typing)) return true;
  if (told.knows(event.code) || told.has_button) return false;
  if (is_modifier(event.code)) return !told.has_press && !told.has_wheel && !told.has_text;
  if (!event.is_down) return true;
  if (told.has_press || (told.has_text && !is_typing)) return false;
  const bool may_be_text = is_printable(event.code) && event.code != last_pressed_ && !is_typing;
  return !may_be_text || frames_since_press_ >= kFramesToOpen;
}

void InputQueue::tell(const WindowEvent& event, Told& told, bool is_typing) {
  switch (event.kind) {
    case EventKind::kMouse: {
      const auto before = frame_.mouse_px;
      // What is held is dragged on outside of the window.
      const bool is_held_down =
          std::find(frame_.buttons.begin(), frame_.buttons.end(), true) != frame_.buttons.end();
      if (event.is_down) frame_.mouse_px = event.at;
      if (!event.is_down && !is_held_down) frame_.mouse_px.reset();
      told.has_moved = told.has_moved || frame_.mouse_px != before;
      break;
    }
    case EventKind::kButton:
      frame_.buttons.at(static_cast<std::size_t>(event.code)) = event.is_down;
      told.has_button = true;
      last_pressed_ = 0;
      frames_since_press_ = 0;
      break;
    case EventKind::kWheel:
      frame_.wheel += event.at;
      told.has_wheel = true;
      break;
    case EventKind::kKey:
      tell_key(event, told, is_typing);
      break;
    case EventKind::kCharacter:
      // Outside of texts, what a held key repeats is one.
      if (is_typing || !told.has_text) frame_.characters += utf8_of(event.code);
      told.has_text = true;
      told.character = event.code;
      break;
  }
}

void InputQueue::tell_key(const WindowEvent& event, Told& told, bool is_typing) {
  if (is_letter(event, is_typing)) return;
  if (is_modifier(event.code)) {
    std::erase(modifiers_, event.code);
    if (event.is_down) modifiers_.push_back(event.code);
    frame_.modifiers = {is_modifier_held(modifiers_, 1), is_modifier_held(modifiers_, 0),
                        is_modifier_held(modifiers_, 2), is_modifier_held(modifiers_, 3)};
    told.keys.push_back(event.code);
    return;
  }
  const auto key = static_cast<Key>(event.code);
  const auto there = std::find(frame_.keys.begin(), frame_.keys.end(), key);
  if (event.is_down == (there != frame_.keys.end())) return;  // a letter of a text comes up
  told.keys.push_back(event.code);
  if (!event.is_down) {
    frame_.keys.erase(there);
    return;
  }
  frame_.keys.push_back(key);
  told.has_press = true;
  last_pressed_ = event.code;
  frames_since_press_ = 0;
}

}  // namespace nadir::kit
