// SPDX-License-Identifier: Apache-2.0
// What users are told. All that copies and moves notices stands here: each holds any action, which takes long to compile.
#include <algorithm>
#include <utility>

#include "core/session/session_core.h"

namespace nadir {
namespace {

constexpr std::size_t kMostNotices = 200;

/// The run that a notice offers to open; null: none.
const std::string* offered_file(const Notice& notice) {
  const auto* const open =
      notice.remedy ? std::get_if<actions::OpenFile>(&*notice.remedy) : nullptr;
  return open != nullptr ? &open->path : nullptr;
}

}  // namespace

void Session::Implementation::add_notice(const Notice& notice) {
  if (!notices.empty()) {  // the same again says nothing new
    const Notice& last = notices.back();
    if (last.kind == notice.kind && last.text == notice.text) return;
  }
  notices.push_back(notice);
  notices.back().number = ++last_number;
  if (notices.size() > kMostNotices) notices.erase(notices.begin());
}

void Session::Implementation::add_notice(Notice::Kind kind, std::string text, std::string details) {
  add_notice(Notice{0, kind, std::move(text), std::move(details), std::nullopt, {}});
}

void Session::Implementation::forget_notices(const std::function<bool(const Notice&)>& is_one) {
  std::erase_if(notices, is_one);
}

void Session::Implementation::age_notices(double elapsed_s) {
  constexpr double kInfoShownS =
      10.0;  // what has gone well is read once, all else stays until it is dismissed
  for (Notice& notice : notices) notice.shown_s += elapsed_s;
  forget_notices([](const Notice& notice) {
    return notice.kind == Notice::Kind::kInfo && !notice.remedy && notice.shown_s > kInfoShownS;
  });
}

void Session::Implementation::settle_unfinished(const std::string& run) {
  if (std::erase(unfinished, run) == 0) return;
  take_off_lists(places.config, run);
  forget_notices([&run](const Notice& notice) {
    const std::string* const offered_run = offered_file(notice);
    return offered_run != nullptr && *offered_run == run;
  });
}

Result<void> Session::Implementation::perform(const actions::DismissNotice& action) {
  const auto forget_offer = [this](const Notice& notice) {
    const std::string* const offered_run = offered_file(notice);
    if (offered_run != nullptr) settle_unfinished(std::string(*offered_run));
  };
  if (!action.notice) {
    const std::vector<Notice> dismissed = std::exchange(notices, {});
    for (const Notice& notice : dismissed) forget_offer(notice);
    return {};
  }
  const auto found = std::find_if(notices.begin(), notices.end(), [&](const Notice& notice) {
    return notice.number == *action.notice;
  });
  if (found == notices.end()) {
    // What a notice offered may have settled it, before the same press dismisses it.
    if (*action.notice >= 1 && *action.notice <= last_number) return {};
    return fail(ErrorCode::kInvalidOptions, "there is no notice {}", *action.notice);
  }
  const Notice dismissed = *found;
  notices.erase(found);
  forget_offer(dismissed);
  return {};
}

}  // namespace nadir
