// SPDX-License-Identifier: Apache-2.0
#include "core/session/step_cache.h"

#include <utility>

#include "core/base/require.h"
#include "core/session/cache_worker.h"

namespace nadir {

StepCache::StepCache(std::shared_ptr<const RunDocument> document,
                     std::shared_ptr<const FlightRecording> flight,
                     std::size_t budget_bytes) {
  NADIR_REQUIRE(document != nullptr);
  worker_ =
      std::make_unique<detail::CacheWorker>(std::move(document), std::move(flight), budget_bytes);
}
StepCache::StepCache(StepCache&&) noexcept = default;
StepCache& StepCache::operator=(StepCache&&) noexcept = default;
StepCache::~StepCache() = default;

void StepCache::set_document(std::shared_ptr<const RunDocument> document) {
  NADIR_REQUIRE(document != nullptr);
  worker_->set_document(std::move(document));
}
void StepCache::set_flight(std::shared_ptr<const FlightRecording> flight) {
  worker_->set_flight(std::move(flight));
}
void StepCache::set_budget_bytes(std::size_t bytes) { worker_->set_budget(bytes); }
void StepCache::request(const Cursor& cursor) { worker_->request(cursor); }

std::shared_ptr<const RunStep> StepCache::step(std::size_t index) const {
  return worker_->ask([&](const auto& worker) { return worker.steps().find(index); });
}
std::shared_ptr<const RunStep> StepCache::nearest_step(std::size_t index, std::size_t reach) const {
  return worker_->ask([&](const auto& worker) { return worker.steps().nearest(index, reach); });
}
std::optional<std::size_t> StepCache::frame_of(std::size_t index) const {
  return worker_->ask([&](const auto& worker) { return worker.frame_of(index); });
}
std::shared_ptr<const CameraMoment> StepCache::camera(std::size_t index) const {
  return worker_->ask([&](const auto& worker) { return worker.camera(index); });
}
std::size_t StepCache::used_bytes() const {
  return worker_->ask([](const auto& worker) { return worker.used(); });
}
std::size_t StepCache::budget_bytes() const {
  return worker_->ask([](const auto& worker) { return worker.budget(); });
}
bool StepCache::is_idle() const {
  return worker_->ask([](const auto& worker) { return worker.is_idle(); });
}
bool StepCache::is_cursor_ready() const {
  return worker_->ask([](const auto& worker) { return worker.is_cursor_ready(); });
}
bool StepCache::wait_until_idle(std::chrono::milliseconds most) const {
  return worker_->wait_until_idle(most);
}
std::vector<Error> StepCache::take_errors() { return worker_->take_errors(); }

}  // namespace nadir
