// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <string>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace nadir {

/// How far a job is.
struct JobProgress {
  double fraction = 0.0;  ///< Done, in [0, 1].
  std::string activity;  ///< What is being done now, in a few words; empty before the first report.
  double elapsed_s = 0.0;  ///< Since the job began; stands still once it is done.

  /// What is left at the speed so far; nothing before a hundredth is done.
  [[nodiscard]] std::optional<double> remaining_s() const {
    if (!(fraction >= 0.01)) return std::nullopt;
    return elapsed_s * (1.0 - fraction) / fraction;
  }
};

/// Work in a thread of its own, for a frame loop that polls and never waits.
///
/// The body is `(const WorkContext&, const Publish&) -> Result<Value>`. What it publishes are immutable snapshots, of
/// which the newest alone is kept; what it returns is the outcome. It is told to stop by its WorkContext and may use
/// context and `publish` from any thread until it returns. An exception becomes an outcome of kIo with its words.
///
/// All calls of one job come from one thread, the owner's. The destructor asks the body to stop and waits for it, so a
/// body looks at its context often; to let it end in peace, ask request_stop() and destroy it once is_done().
template <typename Snapshot, typename Value = void>
class Job {
 public:
  using Publish = std::function<void(std::shared_ptr<const Snapshot>)>;
  using Body = std::function<Result<Value>(const WorkContext& context, const Publish& publish)>;

  /// Begins at once. A thread that cannot be started is an outcome too. @param body  Not empty.
  explicit Job(Body body) : state_(std::make_shared<State>()) {
    try {
      thread_ = std::jthread([state = state_, work = std::move(body)](const std::stop_token& stop) {
        state->finish(run(*state, work, stop));
      });
    } catch (const std::system_error& error) {
      state_->finish(fail(ErrorCode::kIo, "the work could not be started: {}", error.what()));
    }
  }
  Job(Job&&) noexcept = default;
  Job& operator=(Job&&) noexcept = default;

  /// The newest snapshot; null before the first. The same pointer as long as there is no newer one.
  [[nodiscard]] std::shared_ptr<const Snapshot> latest() const {
    const std::lock_guard lock(state_->mutex);
    return state_->latest;
  }
  [[nodiscard]] JobProgress progress() const {
    const std::lock_guard lock(state_->mutex);
    JobProgress progress{state_->fraction, state_->activity, 0.0};
    const auto until = state_->outcome ? state_->ended : Clock::now();
    progress.elapsed_s = std::chrono::duration<double>(until - state_->began).count();
    return progress;
  }
  /// Whether the body has returned. All that it published came before.
  [[nodiscard]] bool is_done() const {
    const std::lock_guard lock(state_->mutex);
    return state_->outcome.has_value();
  }
  /// What came of it, for as long as the job lives; null while it works. Large values may be moved out.
  [[nodiscard]] Result<Value>* outcome() {
    const std::lock_guard lock(state_->mutex);
    return state_->outcome ? &*state_->outcome : nullptr;
  }
  [[nodiscard]] const Result<Value>* outcome() const {
    const std::lock_guard lock(state_->mutex);
    return state_->outcome ? &*state_->outcome : nullptr;
  }

  /// Asks the body to stop; it goes on until it looks.
  void request_stop() { thread_.request_stop(); }
  [[nodiscard]] bool is_stop_requested() const { return thread_.get_stop_token().stop_requested(); }

 private:
  using Clock = std::chrono::steady_clock;

  /// Shared with the thread, so that a job can be moved while it works.
  struct State {
    std::mutex mutex;
    std::shared_ptr<const Snapshot> latest;
    double fraction = 0.0;
    std::string activity;
    std::optional<Result<Value>> outcome;
    Clock::time_point began = Clock::now(), ended;

    void finish(Result<Value> result) {
      const std::lock_guard lock(mutex);
      ended = Clock::now();
      outcome.emplace(std::move(result));
    }
  };

  static Result<Value> run(State& state, const Body& body, const std::stop_token& stop) {
    const WorkContext context{.stop = stop,
                              .progress = [&state](double fraction, const std::string& activity) {
                                const std::lock_guard lock(state.mutex);
                                state.fraction = fraction;
                                state.activity = activity;
                              }};
    // The one before is let go outside the lock, for a large one takes its time.
    const Publish publish = [&state](std::shared_ptr<const Snapshot> snapshot) {
      const std::lock_guard lock(state.mutex);
      state.latest.swap(snapshot);
    };
    try {
      return body(context, publish);
    } catch (const std::bad_alloc&) {
      return fail(ErrorCode::kIo, "there is not enough memory");
    } catch (const std::exception& error) {
      return fail(ErrorCode::kIo, "the work failed: {}", error.what());
    } catch (...) {
      return fail(ErrorCode::kIo, "the work failed in a way that it did not say");
    }
  }

  std::shared_ptr<State> state_;
  std::jthread thread_;  ///< Ends before the state goes.
};

}  // namespace nadir
