// SPDX-License-Identifier: Apache-2.0
#include "core/session/ground_reconstruction.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <limits>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "core/eval/evaluated_step.h"
#include "core/run/run_file.h"
#include "core/session/step_pose.h"
#include "core/topview/semantic_reconstruction.h"

namespace nadir {
namespace {

using Clock = std::chrono::steady_clock;

bool is_of_one_run(const ReconstructionQuestion& a, const ReconstructionQuestion& b) {
  return a.run && b.run && a.run->path == b.run->path && a.run->file == b.run->file &&
         a.poses == b.poses;
}

/// What was laid after so many steps, to go back to. All of it is bounded in bytes.
class KeptGround {
 public:
  struct State {
    std::size_t steps = 0;
    SemanticReconstruction seen;
  };

  void keep(State state) {
    const auto at =
        std::lower_bound(states_.begin(), states_.end(), state.steps,
                         [](const State& kept, std::size_t steps) { return kept.steps < steps; });
    if (at != states_.end() && at->steps == state.steps) return;
    states_.insert(at, std::move(state));
    while (!states_.empty() && bytes() > kMostBytes) states_.erase(least_needed());
  }
  /// The last one that is not after so many steps; null: none.
  [[nodiscard]] const State* before(std::size_t steps) const {
    const auto after = std::find_if(states_.begin(), states_.end(),
                                    [steps](const State& state) { return state.steps > steps; });
    return after == states_.begin() ? nullptr : &*(after - 1);
  }

 private:
  static constexpr std::size_t kMostBytes = 96U << 20U;

  [[nodiscard]] std::size_t bytes() const {
    std::size_t sum = 0;
    for (const State& state : states_) sum += state.seen.bytes();
    return sum;
  }
  /// The one whose neighbours are nearest to each other.
  [[nodiscard]] std::vector<State>::iterator least_needed() {
    auto least = states_.end() - 1;
    std::size_t least_gap = std::numeric_limits<std::size_t>::max();
    for (auto at = states_.begin(); at + 1 < states_.end(); ++at) {
      const std::size_t from = at == states_.begin() ? 0 : (at - 1)->steps;
      const std::size_t gap = (at + 1)->steps - from;
      if (gap < least_gap) least = at;
      least_gap = std::min(least_gap, gap);
    }
    return least;
  }

  std::vector<State> states_;  ///< Rising in steps.
};

/// What the thread has laid so far.
class Laying {
 public:
  explicit Laying(ReconstructionQuestion question) : question_(std::move(question)) {}

  [[nodiscard]] bool is_for(const ReconstructionQuestion& question) const {
    return is_of_one_run(question_, question);
  }
  /// Back to a state from which steps have only to be added for this question.
  void go_back_for(const ReconstructionQuestion& question) {
    const std::size_t wanted = question.last_step + 1;
    if (next_ <= wanted) return;
    if (seen_) kept_.keep({next_, std::move(*seen_)});
    seen_.reset();
    next_ = 0;
    if (const KeptGround::State* const state = kept_.before(wanted)) {
      next_ = state->steps;
      seen_ = state->seen;
    }
  }
  [[nodiscard]] std::size_t next() const { return next_; }

  /// Lays the next step. @errors as RunReader.
  Result<void> add_next(const RunDocument& run) {
    constexpr std::size_t kBetweenKept = 200;
    if (!reader_) {
      auto opened = RunReader::open(question_.run->path);
      if (!opened) return forward_error(opened);
      reader_.emplace(std::move(*opened));
    }
    const auto step = reader_->step(run.steps[next_].step);
    if (!step) return forward_error(step);
    ++next_;
    const auto pose = pose_of(*step, question_.poses);
    const bool is_laid = step->topview && !step->topview->cells.empty() && pose && is_finite(*pose);
    if (is_laid && !seen_) seen_.emplace(step->topview->metres_per_cell);
    if (is_laid) seen_->add(*step->topview, *pose);
    if (seen_ && next_ % kBetweenKept == 0) kept_.keep({next_, *seen_});
    return {};
  }

  [[nodiscard]] Result<std::shared_ptr<const ReconstructedGround>> ground() const {
    auto ground = std::make_shared<ReconstructedGround>();
    ground->steps = next_;
    if (seen_ && !seen_->empty()) {
      auto labels = seen_->labels();
      if (!labels) return forward_error(labels, question_.run->path.string());
      ground->labels = std::move(*labels);
      ground->top_left_in_enu_m = seen_->top_left_in_enu_m();
      ground->metres_per_cell = seen_->metres_per_cell();
    }
    return ground;
  }

  Clock::time_point shown{};  ///< When its ground was last handed out.

 private:
  ReconstructionQuestion question_;
  std::optional<RunReader> reader_;
  std::optional<SemanticReconstruction> seen_;
  KeptGround kept_;
  std::size_t next_ = 0;  ///< Index of the step that is laid next.
};

}  // namespace

struct GroundReconstruction::Implementation {
  mutable std::mutex mutex;
  std::condition_variable_any has_question;
  ReconstructionQuestion question;
  std::uint64_t asked = 0, answered = 0;  ///< Of the questions so far, the last.
  std::shared_ptr<const ReconstructedGround> answer;
  std::string error;
  std::jthread thread;

  void work(const std::stop_token& stop);
  void work_on(const ReconstructionQuestion& asked_now,
               std::uint64_t number,
               std::optional<Laying>& laying,
               const std::stop_token& stop);
  /// Whether it is still wanted.
  bool publish(const ReconstructionQuestion& asked_now,
               std::uint64_t number,
               Result<std::shared_ptr<const ReconstructedGround>> ground,
               bool is_last);
};

bool GroundReconstruction::Implementation::publish(
    const ReconstructionQuestion& asked_now,
    std::uint64_t number,
    Result<std::shared_ptr<const ReconstructedGround>> ground,
    bool is_last) {
  const std::lock_guard lock(mutex);
  if (ground) {
    // One for an older question of the same run still shows more than the one before, but never more than was asked for.
    const std::size_t steps = (*ground)->steps;
    const bool is_wanted = is_of_one_run(asked_now, question) && steps <= question.last_step + 1;
    if (is_wanted && (answer == nullptr || steps >= answer->steps)) answer.swap(*ground);
  } else if (number == asked) {
    error = ground.error().message;
  }
  if (is_last || !ground) answered = std::max(answered, number);
  return number == asked;
}

void GroundReconstruction::Implementation::work(const std::stop_token& stop) {
  std::optional<Laying> laying;
  while (!stop.stop_requested()) {
    ReconstructionQuestion now;
    std::uint64_t number = 0;
    {
      std::unique_lock lock(mutex);
      if (!has_question.wait(lock, stop, [this] { return answered < asked; })) return;
      now = question;
      number = asked;
    }
    try {
      work_on(now, number, laying, stop);
    } catch (const std::exception& fault) {
      laying.reset();
      publish(now, number, fail(ErrorCode::kIo, "{}: {}", now.run->path.string(), fault.what()),
              true);
    }
  }
}

void GroundReconstruction::Implementation::work_on(const ReconstructionQuestion& now,
                                                   std::uint64_t number,
                                                   std::optional<Laying>& laying,
                                                   const std::stop_token& stop) {
  constexpr std::chrono::milliseconds kShowEvery(300);
  if (!laying || !laying->is_for(now)) laying.emplace(now);
  laying->go_back_for(now);
  while (laying->next() <= now.last_step && !stop.stop_requested()) {
    if (const auto added = laying->add_next(*now.run); !added) {
      publish(now, number, forward_error(added), true);
      laying.reset();
      return;
    }
    bool is_wanted = true;
    if (Clock::now() - laying->shown > kShowEvery) {  // also where questions come faster than that
      is_wanted = publish(now, number, laying->ground(), false);
      laying->shown = Clock::now();
    } else {
      const std::lock_guard lock(mutex);
      is_wanted = number == asked;
    }
    if (!is_wanted) return;  // what is laid serves the next question, if that goes on from it
  }
  if (!stop.stop_requested()) publish(now, number, laying->ground(), true);
}

GroundReconstruction::GroundReconstruction() : implementation_(std::make_unique<Implementation>()) {
  implementation_->thread = std::jthread(
      [shared = implementation_.get()](const std::stop_token& stop) { shared->work(stop); });
}

GroundReconstruction::~GroundReconstruction() {
  implementation_->thread.request_stop();
  implementation_->thread.join();
}

void GroundReconstruction::ask(const ReconstructionQuestion& question) {
  if (!question.run || question.run->steps.empty()) return;
  ReconstructionQuestion asked = question;
  asked.last_step = std::min(asked.last_step, asked.run->steps.size() - 1);
  Implementation& shared = *implementation_;
  {
    const std::lock_guard lock(shared.mutex);
    const bool is_same_run = is_of_one_run(shared.question, asked);
    if (is_same_run && shared.question.last_step == asked.last_step) return;
    const bool shows_too_much =
        shared.answer != nullptr && shared.answer->steps > asked.last_step + 1;
    if (!is_same_run || shows_too_much) shared.answer.reset();
    shared.question = std::move(asked);
    ++shared.asked;
  }
  shared.has_question.notify_one();
}

std::shared_ptr<const ReconstructedGround> GroundReconstruction::answer() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->answer;
}

bool GroundReconstruction::is_working() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->answered < implementation_->asked;
}

std::string GroundReconstruction::take_error() {
  const std::lock_guard lock(implementation_->mutex);
  return std::exchange(implementation_->error, {});
}

}  // namespace nadir
