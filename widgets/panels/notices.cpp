// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/notices.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

namespace nadir {
namespace {

constexpr const char* kMoreNotices = "more";
constexpr double kMoreLine = 52.0;  ///< Height of the line that counts them; of the design.

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

/// How high a notice will be, about, with what parts it from the next one. Of the design: lengths as kit draws them.
[[nodiscard]] double height_of_notice(const kit::Ui& ui, const Notice& notice, double width) {
  constexpr double kBeside = 108.0, kLine = 17.0, kLeastWords = 28.0, kAround = 24.0,
                   kButtons = 44.0;
  const double words = std::max(ui.px(80.0), std::min(width, ui.px(400.0)) - ui.px(kBeside));
  const double lines = std::ceil(ui.text_width(notice.text) / (0.9 * words));  // words break early
  const double buttons = notice.remedy || !notice.details.empty() ? kButtons : 0.0;
  return ui.px(std::max(kLeastWords, kLine * lines + 10.0) + kAround + buttons);
}

/// How many of the newest have room. The newest has it always.
[[nodiscard]] std::size_t count_with_room(const kit::Ui& ui,
                                          const std::vector<Notice>& all,
                                          const kit::Rect& inside) {
  double room = inside.height - ui.px(12.0);
  std::size_t count = 0;
  for (; count < all.size(); ++count) {
    room -= height_of_notice(ui, all[all.size() - 1 - count], inside.width);
    const bool is_last = count + 1 == all.size();
    if (count > 0 && room < (is_last ? 0.0 : ui.px(kMoreLine))) break;
  }
  return count;
}

/// The line above those that are shown, as grave as the gravest that it counts; nothing where all are shown, as always.
[[nodiscard]] std::optional<kit::Notice> line_of_more(const std::vector<Notice>& all,
                                                      std::size_t with_room,
                                                      std::size_t shown,
                                                      bool shows_all) {
  if (all.size() <= NoticesModel::kMostShown && shown == all.size()) return std::nullopt;
  kit::Notice more;
  more.id = kMoreNotices;
  more.is_brief = true;
  const std::size_t hidden = all.size() - shown;
  more.text = hidden > 0 ? fmt::format("{} more", hidden) : fmt::format("{} notices", all.size());
  Notice::Kind gravest = Notice::Kind::kInfo;
  for (std::size_t i = 0; i < hidden; ++i) gravest = std::max(gravest, all[i].kind);
  more.level = level_of(gravest);
  if (shows_all && shown > NoticesModel::kMostShown) more.action = "Show fewer";
  if (!shows_all && with_room > shown) more.action = "Show all";
  return more;
}

/// Where the line that counts them has no room, the only one that is shown says before its own words how many there are, and
/// whether errors are among those that it hides: "Newest of 9, 2 errors hidden".
[[nodiscard]] std::string words_of_count(const std::vector<Notice>& all) {
  const auto errors = std::count_if(all.begin(), all.end() - 1, [](const Notice& notice) {
    return notice.kind == Notice::Kind::kError;
  });
  std::string words = fmt::format("Newest of {}", all.size());
  if (errors > 0) words += fmt::format(", {} {} hidden", errors, errors == 1 ? "error" : "errors");
  return words;
}

}  // namespace

NoticesModel notices_model(const Session& session) {
  const auto all = session.notices();
  return {{all.begin(), all.end()}};
}

Actions draw_notices(kit::Ui& ui,
                     const NoticesModel& model,
                     NoticesState& state,
                     const kit::Rect& inside) {
  if (model.all.size() <= NoticesModel::kMostShown) state.shows_all = false;
  const std::size_t with_room = count_with_room(ui, model.all, inside);
  const std::size_t count =
      state.shows_all ? with_room : std::min(with_room, NoticesModel::kMostShown);
  const auto first = model.all.end() - static_cast<std::ptrdiff_t>(count);
  std::vector<kit::Notice> shown;
  auto more = line_of_more(model.all, with_room, count, state.shows_all);
  const bool is_low =
      more && count == 1 &&
      height_of_notice(ui, model.all.back(), inside.width) + ui.px(12.0 + kMoreLine) >
          inside.height;
  if (more && !is_low) shown.push_back(std::move(*more));
  for (auto notice = first; notice != model.all.end(); ++notice) {
    kit::Notice one;
    one.id = std::to_string(notice->number);
    one.level = level_of(notice->kind);
    one.text = is_low ? words_of_count(model.all) + ": " + notice->text : notice->text;
    one.details = notice->details;
    if (notice->remedy) one.action = notice->remedy_title;
    shown.push_back(std::move(one));
  }
  const auto wish = ui.notices(shown, inside);
  if (!wish) return {};
  if (wish->id == kMoreNotices && wish->kind == kit::NoticeWish::Kind::kAction) {
    state.shows_all = !state.shows_all;
    return {};
  }
  if (wish->id == kMoreNotices) {  // puts away what it counts
    Actions asked;
    const auto end = first == model.all.begin() ? model.all.end() : first;
    for (auto notice = model.all.begin(); notice != end; ++notice) {
      asked.emplace_back(actions::DismissNotice{notice->number});
    }
    return asked;
  }
  const auto notice = std::find_if(first, model.all.end(), [&](const Notice& one) {
    return std::to_string(one.number) == wish->id;
  });
  return notice == model.all.end() ? Actions{} : wish_for_notice(*notice, wish->kind);
}

}  // namespace nadir
