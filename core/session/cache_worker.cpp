// SPDX-License-Identifier: Apache-2.0
#include "core/session/cache_worker.h"

#include <algorithm>
#include <utility>

#include "core/flight/nearest_frame.h"

namespace nadir::detail {

CacheWorker::CacheWorker(std::shared_ptr<const RunDocument> document,
                         std::shared_ptr<const FlightRecording> flight,
                         std::size_t budget_bytes)
    : document_(std::move(document)), flight_(std::move(flight)), budget_(budget_bytes) {
  thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
}

void CacheWorker::set_document(std::shared_ptr<const RunDocument> document) {
  const std::lock_guard lock(mutex_);
  if (document == document_) return;
  const bool is_same_run = document->file == document_->file &&
                           document->header == document_->header &&
                           document->steps.size() >= document_->steps.size();
  if (!is_same_run) {
    steps_.clear();
    cameras_.clear();
    ++run_number_;
  }
  steps_.forget_broken();  // what could not be read then may be whole now
  document_ = std::move(document);
  wake();
}

void CacheWorker::set_flight(std::shared_ptr<const FlightRecording> flight) {
  const std::lock_guard lock(mutex_);
  if (flight == flight_) return;
  flight_ = std::move(flight);
  cameras_.clear();
  wake();
}

void CacheWorker::set_budget(std::size_t bytes) {
  const std::lock_guard lock(mutex_);
  budget_ = bytes;
  wake();
}

void CacheWorker::request(const Cursor& cursor) {
  const std::lock_guard lock(mutex_);
  if (cursor_ && *cursor_ == cursor) return;
  cursor_ = cursor;
  wake();
}

bool CacheWorker::wait_until_idle(std::chrono::milliseconds most) {
  std::unique_lock lock(mutex_);
  return changed_.wait_for(lock, most, [this] { return is_idle_; });
}

std::vector<Error> CacheWorker::take_errors() {
  const std::lock_guard lock(mutex_);
  return std::exchange(errors_, {});
}

std::optional<std::size_t> CacheWorker::frame_of(std::size_t index) const {
  if (!flight_ || index >= document_->steps.size()) return std::nullopt;
  const FlightDescription& flight = flight_->description();
  const FlightFrame* const nearest =
      nearest_frame(flight, document_->steps[index].time_s, has_picture_or_cloud);
  if (nearest == nullptr) return std::nullopt;
  return static_cast<std::size_t>(nearest - flight.frames.data());
}

std::shared_ptr<const CameraMoment> CacheWorker::camera(std::size_t index) const {
  const auto frame = frame_of(index);
  return frame ? cameras_.find(*frame) : nullptr;
}

bool CacheWorker::is_cursor_ready() const {
  if (!has_cursor()) return true;
  if (!steps_.is_settled(cursor().index)) return false;
  const auto frame = frame_here();
  return !frame || cameras_.is_settled(*frame);
}

void CacheWorker::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!stop.stop_requested()) {
    const std::optional<Wanted> wanted = choose();
    if (!wanted) {
      is_idle_ = true;
      changed_.notify_all();
      changed_.wait(lock, stop, [this] { return !is_idle_; });
      continue;
    }
    if (wanted->is_camera) {
      take_camera(lock, wanted->index);
    } else {
      take_step(lock, wanted->index);
    }
  }
}

void CacheWorker::wake() {
  is_idle_ = false;
  if (cursor_) nearby_ = steps_nearby(cursor(), document_->steps.size());
  steps_.forget_room();
  cameras_.forget_room();
  shrink();
  changed_.notify_all();
}

void CacheWorker::shrink() {
  if (!has_cursor()) return;
  steps_.shrink(step_budget(), step_distance());
  cameras_.shrink(camera_budget(), camera_distance());
}

std::optional<CacheWorker::Wanted> CacheWorker::choose() {
  if (!has_cursor()) return std::nullopt;
  const std::size_t here = cursor().index;
  if (!steps_.is_settled(here)) return Wanted{false, here};
  if (const auto frame = frame_here()) {
    last_frame_ = *frame;
    if (!cameras_.is_settled(*frame)) return Wanted{true, *frame};
  }
  for (const NearbyStep& near : nearby_) {
    if (!steps_.is_settled(near.index) &&
        steps_.has_room(step_budget(), step_distance()(near.index), step_distance())) {
      return Wanted{false, near.index};
    }
    if (!near.is_with_camera || !wants_camera()) continue;
    const auto frame = frame_of(near.index);
    if (frame && !cameras_.is_settled(*frame) &&
        cameras_.has_room(camera_budget(), camera_distance()(*frame), camera_distance())) {
      return Wanted{true, *frame};
    }
  }
  return std::nullopt;
}

template <typename Item>
void CacheWorker::keep(CacheShelf<Item>& shelf,
                       std::size_t index,
                       Result<std::shared_ptr<const Item>> item,
                       std::size_t budget,
                       const CursorDistance& distance) {
  if (!item) {
    shelf.mark_broken(index);
    if (told_.insert(item.error().message).second) errors_.push_back(std::move(item.error()));
    return;
  }
  const std::size_t bytes = bytes_of(**item);
  shelf.put(index, std::move(*item), bytes, budget, distance);
}

void CacheWorker::take_step(std::unique_lock<std::mutex>& lock, std::size_t index) {
  const auto document = document_;
  const std::size_t run_number = run_number_;
  lock.unlock();
  auto step = decoder_.read(*document, run_number, index);
  lock.lock();
  if (run_number != run_number_) return;  // of a run that is not shown any more
  keep(steps_, index, std::move(step), step_budget(), step_distance());
}

void CacheWorker::take_camera(std::unique_lock<std::mutex>& lock, std::size_t frame) {
  const auto flight = flight_;
  lock.unlock();
  auto moment = read_camera(*flight, frame);
  lock.lock();
  if (flight != flight_) return;
  keep(cameras_, frame, std::move(moment), camera_budget(), camera_distance());
}

Cursor CacheWorker::cursor() const {
  Cursor inside = *cursor_;
  const std::size_t count = document_->steps.size();
  if (count > 0) inside.index = std::min(inside.index, count - 1);
  return inside;
}

std::optional<std::size_t> CacheWorker::frame_here() const {
  return wants_camera() ? frame_of(cursor().index) : std::nullopt;
}

CursorDistance CacheWorker::distance_from(std::size_t here) const {
  return {here, cursor_->direction >= 0, cursor_->is_playing};
}

}  // namespace nadir::detail
