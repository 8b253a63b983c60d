// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <thread>
#include <vector>

#include "core/session/cache_shelf.h"
#include "core/session/cursor_order.h"
#include "core/session/step_decoder.h"

namespace nadir::detail {

/// The thread behind a StepCache and what it shares with the owner. The calls mean what they mean there.
class CacheWorker {
 public:
  CacheWorker(std::shared_ptr<const RunDocument> document,
              std::shared_ptr<const FlightRecording> flight,
              std::size_t budget_bytes);

  void set_document(std::shared_ptr<const RunDocument> document);
  void set_flight(std::shared_ptr<const FlightRecording> flight);
  void set_budget(std::size_t bytes);
  void request(const Cursor& cursor);
  bool wait_until_idle(std::chrono::milliseconds most);
  std::vector<Error> take_errors();

  /// Answers a question while nothing changes. @param question  (const CacheWorker&) -> what the calls below say.
  template <typename Question>
  auto ask(const Question& question) const {
    const std::lock_guard lock(mutex_);
    return question(*this);
  }

  // For questions.
  [[nodiscard]] const CacheShelf<RunStep>& steps() const { return steps_; }
  [[nodiscard]] std::optional<std::size_t> frame_of(std::size_t index) const;
  [[nodiscard]] std::shared_ptr<const CameraMoment> camera(std::size_t index) const;
  [[nodiscard]] std::size_t used() const { return steps_.used() + cameras_.used(); }
  [[nodiscard]] std::size_t budget() const { return budget_; }
  [[nodiscard]] bool is_idle() const { return is_idle_; }
  [[nodiscard]] bool is_cursor_ready() const;

 private:
  /// One thing to decode.
  struct Wanted {
    bool is_camera = false;
    std::size_t index = 0;  ///< Of a step, or of a frame.
  };

  void work(const std::stop_token& stop);

  // Called with the mutex held; the take_ functions let it go while they read.
  void wake();
  void shrink();
  [[nodiscard]] std::optional<Wanted> choose();
  void take_step(std::unique_lock<std::mutex>& lock, std::size_t index);
  void take_camera(std::unique_lock<std::mutex>& lock, std::size_t frame);
  template <typename Item>
  void keep(CacheShelf<Item>& shelf,
            std::size_t index,
            Result<std::shared_ptr<const Item>> item,
            std::size_t budget,
            const CursorDistance& distance);

  [[nodiscard]] bool has_cursor() const { return cursor_ && !document_->steps.empty(); }
  /// The last request, inside the run as it is now.
  [[nodiscard]] Cursor cursor() const;
  [[nodiscard]] bool wants_camera() const { return flight_ && cursor_ && cursor_->with_camera; }
  [[nodiscard]] std::optional<std::size_t> frame_here() const;
  [[nodiscard]] std::size_t camera_budget() const { return wants_camera() ? budget_ / 2 : 0; }
  [[nodiscard]] std::size_t step_budget() const { return budget_ - camera_budget(); }
  [[nodiscard]] CursorDistance distance_from(std::size_t here) const;
  [[nodiscard]] CursorDistance step_distance() const { return distance_from(cursor().index); }
  [[nodiscard]] CursorDistance camera_distance() const {
    return distance_from(frame_here().value_or(last_frame_));
  }

  mutable std::mutex mutex_;
  std::condition_variable_any changed_;
  std::shared_ptr<const RunDocument> document_;
  std::shared_ptr<const FlightRecording> flight_;
  std::size_t run_number_ = 0;  ///< Rises when another run takes this one's place.
  std::optional<Cursor> cursor_;
  std::vector<NearbyStep> nearby_;
  std::size_t budget_;
  std::size_t last_frame_ = 0;  ///< Of the last cursor that had one.
  CacheShelf<RunStep> steps_;
  CacheShelf<CameraMoment> cameras_;
  bool is_idle_ = false;
  std::vector<Error> errors_;
  std::set<std::string> told_;

  StepDecoder decoder_;  ///< The thread's own.
  std::jthread thread_;  ///< Ends before what it uses goes.
};

}  // namespace nadir::detail
