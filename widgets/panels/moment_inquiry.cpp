// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/moment_inquiry.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <stop_token>
#include <thread>

#include "core/session/place_hold.h"

namespace nadir {
namespace {

bool is_same(const MomentQuestion& a, const MomentQuestion& b) {
  return a.step == b.step && a.map == b.map && a.options_key == b.options_key &&
         a.with_surface == b.with_surface;
}

MomentAnswer failed(const MomentQuestion& question, const std::string& why) {
  MomentAnswer answer;
  answer.step = question.step;
  answer.map = question.map;
  answer.has_tried_surface = true;
  answer.error = why;
  return answer;
}

}  // namespace

MomentAnswer answer_moment(const MomentQuestion& question, const MapMatcher& matcher) {
  MomentAnswer answer;
  answer.step = question.step;
  answer.map = question.map;
  auto explanation = explain_moment(*question.step, matcher);
  if (!explanation) return failed(question, explanation.error().message);
  answer.words = in_words(*explanation);
  answer.surety = surety_in_words(*explanation);
  answer.explanation = std::move(*explanation);
  if (!question.with_surface) return answer;
  answer.has_tried_surface = true;
  auto surface = moment_surface(*question.step, matcher);
  if (surface) {
    answer.hold_words = in_words(place_hold(*surface, answer.explanation->rules.alike_cost),
                                 question.step->estimate.moments.mean.yaw_rad);
    answer.surface = std::move(*surface);
  } else {
    answer.error = surface.error().message;
  }
  return answer;
}

RunOptions options_of(const RunHeader& header) {
  RunOptions options;
  for (const auto& [name, text] : header.options) {
    const auto set = set_option(options, name, text);
    (void)set;  // an option that another version had
  }
  return options;
}

struct MomentInquiry::Implementation {
  mutable std::mutex mutex;
  std::condition_variable_any wake;
  std::optional<MomentQuestion> asked;    ///< The newest, answered or not.
  std::optional<MomentQuestion> waiting;  ///< Not begun yet.
  std::shared_ptr<const MomentAnswer> answer;
  bool is_working = false;

  // Of the thread alone.
  std::shared_ptr<const MapIndex> matched_map;
  std::string matched_key;
  std::optional<MapMatcher> matcher;

  std::jthread thread;  ///< Ends before all else goes.

  void publish(MomentAnswer made) {
    auto shared = std::make_shared<const MomentAnswer>(std::move(made));
    const std::lock_guard lock(mutex);
    answer.swap(shared);
  }

  [[nodiscard]] std::string make_matcher(const MomentQuestion& question) {
    if (matcher && matched_map == question.map && matched_key == question.options_key) return {};
    auto made = MapMatcher::create(question.map, question.options.localiser);
    matcher.reset();
    if (!made) return made.error().message;
    matcher = std::move(*made);
    matched_map = question.map;
    matched_key = question.options_key;
    return {};
  }

  void work_on(const MomentQuestion& question) {
    try {
      if (const std::string why = make_matcher(question); !why.empty()) {
        publish(failed(question, why));
        return;
      }
      MomentQuestion quick = question;
      quick.with_surface = false;
      publish(answer_moment(quick, *matcher));  // words first
      const bool is_newer = [&] {
        const std::lock_guard lock(mutex);
        return waiting.has_value();
      }();
      if (question.with_surface && !is_newer) publish(answer_moment(question, *matcher));
    } catch (const std::exception& error) {
      publish(failed(question, error.what()));
    }
  }

  void run(const std::stop_token& stop) {
    while (true) {
      MomentQuestion question;
      {
        std::unique_lock lock(mutex);
        is_working = false;
        if (!wake.wait(lock, stop, [this] { return waiting.has_value(); })) return;
        question = std::move(*waiting);
        waiting.reset();
        is_working = true;
      }
      work_on(question);
    }
  }
};

MomentInquiry::MomentInquiry() : implementation_(std::make_unique<Implementation>()) {
  implementation_->thread = std::jthread(
      [state = implementation_.get()](const std::stop_token& stop) { state->run(stop); });
}

MomentInquiry::~MomentInquiry() {
  implementation_->thread.request_stop();
  implementation_->thread.join();
}

void MomentInquiry::ask(const MomentQuestion& question) {
  if (!question.step || !question.map) return;
  {
    const std::lock_guard lock(implementation_->mutex);
    if (implementation_->asked && is_same(*implementation_->asked, question)) return;
    implementation_->asked = question;
    implementation_->waiting = question;
  }
  implementation_->wake.notify_one();
}

std::shared_ptr<const MomentAnswer> MomentInquiry::answer() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->answer;
}

bool MomentInquiry::is_working() const {
  const std::lock_guard lock(implementation_->mutex);
  return implementation_->is_working || implementation_->waiting.has_value();
}

}  // namespace nadir
