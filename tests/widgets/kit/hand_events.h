// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "widgets/kit/chord.h"
#include "widgets/kit/input_queue.h"

namespace nadir::kit {

/// Writes down what a hand does to a window, as the window would tell it.
class Hand {
 public:
  static constexpr int kShift = 340, kCtrl = 341, kAlt = 342, kRightShift = 344, kRightAlt = 346;

  Hand& key(int code, bool is_down) {
    events.push_back({WindowEvent::Kind::kKey, code, is_down, {0.0, 0.0}});
    return *this;
  }
  Hand& down(Key which) { return key(static_cast<int>(which), true); }
  Hand& up(Key which) { return key(static_cast<int>(which), false); }
  Hand& tap(Key which) { return down(which).up(which); }
  /// Ctrl and a key, let go in the order in which hands mostly do.
  Hand& chord(Key which) { return key(kCtrl, true).tap(which).key(kCtrl, false); }
  Hand& character(int unicode) {
    events.push_back({WindowEvent::Kind::kCharacter, unicode, true, {0.0, 0.0}});
    return *this;
  }
  /// Small letters, digits and spaces: each key goes down, types, and comes up.
  Hand& type(const std::string& text) {
    for (const char sign : text) {
      const int code = sign >= 'a' && sign <= 'z' ? sign - 'a' + 'A' : sign;
      key(code, true).character(sign).key(code, false);
    }
    return *this;
  }
  Hand& move(double x, double y) {
    events.push_back({WindowEvent::Kind::kMouse, 0, true, {x, y}});
    return *this;
  }
  Hand& leave() {
    events.push_back({WindowEvent::Kind::kMouse, 0, false, {0.0, 0.0}});
    return *this;
  }
  Hand& press(int button = 0) {
    events.push_back({WindowEvent::Kind::kButton, button, true, {0.0, 0.0}});
    return *this;
  }
  Hand& release(int button = 0) {
    events.push_back({WindowEvent::Kind::kButton, button, false, {0.0, 0.0}});
    return *this;
  }
  Hand& click(int button = 0) { return press(button).release(button); }
  Hand& wheel(double notches) {
    events.push_back({WindowEvent::Kind::kWheel, 0, false, {0.0, notches}});
    return *this;
  }

  std::vector<WindowEvent> events;
};

}  // namespace nadir::kit
