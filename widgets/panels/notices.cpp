// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/notices.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

namespace nadir {
namespace {

constexpr const char* kEarlier = "earlier";

[[nodiscard]] kit::Level level_of(Notice::Kind kind) {
  switch (kind) {
    case Notice::Kind::kError:
      return kit::Level::kBad;
    case Notice::Kind::kWarning:
      return kit::Level::kWarning;
    case Notice::Kind::kInfo:
      break;
  }
  return kit::Level::kInfo;
}

[[nodiscard]] Actions wish_for_notice(const Notice& notice, kit::NoticeWish::Kind kind) {
  switch (kind) {
    case kit::NoticeWish::Kind::kCopy:
      return {actions::Copy{notice.details.empty()
                                ? notice.text
                                : fmt::format("{}\n{}", notice.text, notice.details)}};
    case kit::NoticeWish::Kind::kAction:
      if (notice.remedy) return {*notice.remedy, actions::DismissNotice{notice.number}};
      return {};
    case kit::NoticeWish::Kind::kDismiss:
      break;
  }
  return {actions::DismissNotice{notice.number}};
}

[[nodiscard]] Actions wish_for_earlier(const NoticesModel& model, kit::NoticeWish::Kind kind) {
  Actions asked;
  if (kind == kit::NoticeWish::Kind::kAction) {
    asked.emplace_back(actions::ShowPanel{Panel::kLog, Switch::kOn});
  } else {
    for (const int number : model.not_shown) asked.emplace_back(actions::DismissNotice{number});
  }
  return asked;
}

}  // namespace

NoticesModel notices_model(const Session& session) {
  NoticesModel model;
  const auto all = session.notices();
  const std::size_t hidden = all.size() - std::min(all.size(), NoticesModel::kMostShown);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i < hidden) {
      model.not_shown.push_back(all[i].number);
    } else {
      model.shown.push_back(all[i]);
    }
  }
  return model;
}

Actions draw_notices(kit::Ui& ui, const NoticesModel& model, const kit::Rect& inside) {
  std::vector<kit::Notice> shown;
  if (!model.not_shown.empty()) {
    kit::Notice earlier;
    earlier.id = kEarlier;
    earlier.text = model.not_shown.size() == 1
                       ? "An earlier notice waits to be read."
                       : fmt::format("{} earlier notices wait to be read.", model.not_shown.size());
    earlier.action = "Show the log";
    shown.push_back(std::move(earlier));
  }
  for (const Notice& notice : model.shown) {
    kit::Notice one;
    one.id = std::to_string(notice.number);
    one.level = level_of(notice.kind);
    one.text = notice.text;
    one.details = notice.details;
    if (notice.remedy) one.action = notice.remedy_title;
    shown.push_back(std::move(one));
  }
  const auto wish = ui.notices(shown, inside);
  if (!wish) return {};
  if (wish->id == kEarlier) return wish_for_earlier(model, wish->kind);
  const auto notice = std::find_if(model.shown.begin(), model.shown.end(), [&](const Notice& one) {
    return std::to_string(one.number) == wish->id;
  });
  return notice == model.shown.end() ? Actions{} : wish_for_notice(*notice, wish->kind);
}

}  // namespace nadir
