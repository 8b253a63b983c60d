// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace nadir {

/// Undo and redo of a value: it keeps earlier and later ones. Changes with the same, not empty `merge_key` that follow each
/// other are one step, until seal(): a drag, or a text that is typed.
template <typename State>
class History {
 public:
  explicit History(std::size_t most_steps = 1000) : most_steps_(most_steps) {}

  /// @param before  The value that was left. @param title  What was done, for menus: "Hide particles".
  void commit(State before, std::string title, std::string merge_key = {}) {
    undone_.clear();
    if (!merge_key.empty() && !done_.empty() && merge_key == open_key_) return;
    open_key_ = std::move(merge_key);
    done_.push_back({std::move(before), std::move(title), ++last_change_});
    if (done_.size() > most_steps_) done_.erase(done_.begin());
  }
  void seal() { open_key_.clear(); }

  /// Number of the newest change; the next one's is higher by one.
  [[nodiscard]] std::uint64_t last_change() const { return last_change_; }

  /// Changes every value that is kept, for what has come to light since: a run that cannot be read. Steps that then lead
  /// nowhere go. A drag that goes on is a new step from here. @param now  The value outside, changed likewise by the caller.
  /// @param since  Number of a change: values from before it stay as they are.
  template <typename Change>
  void amend(const Change& change, const State& now, std::uint64_t since = 0) {
    seal();
    for (Step& step : done_) {  // each holds the value before its change
      if (step.change > since) change(step.state);
    }
    for (Step& step : undone_) {  // and each of these the value after it
      if (step.change >= since) change(step.state);
    }
    for (std::vector<Step>* steps : {&done_, &undone_}) {
      for (std::size_t i = steps->size(); i-- > 0;) {
        const State& next = i + 1 < steps->size() ? (*steps)[i + 1].state : now;
        if ((*steps)[i].state == next)
          steps->erase(steps->begin() + static_cast<std::ptrdiff_t>(i));
      }
    }
  }

  [[nodiscard]] bool can_undo() const { return !done_.empty(); }
  [[nodiscard]] bool can_redo() const { return !undone_.empty(); }
  /// What undo would take back, or redo do again. Only where it can.
  [[nodiscard]] const std::string& undo_title() const { return done_.back().title; }
  [[nodiscard]] const std::string& redo_title() const { return undone_.back().title; }

  /// Only where it can. @returns the value before.
  [[nodiscard]] State undo(State now) {
    seal();
    return move_over(done_, undone_, std::move(now));
  }
  [[nodiscard]] State redo(State now) {
    seal();
    return move_over(undone_, done_, std::move(now));
  }

 private:
  struct Step {
    State state;
    std::string title;
    std::uint64_t change = 0;
  };
  static State move_over(std::vector<Step>& from, std::vector<Step>& to, State now) {
    Step step = std::move(from.back());
    from.pop_back();
    to.push_back({std::move(now), step.title, step.change});
    return std::move(step.state);
  }

  std::size_t most_steps_;
  std::uint64_t last_change_ = 0;
  std::vector<Step> done_, undone_;
  std::string open_key_;
};

}  // namespace nadir
