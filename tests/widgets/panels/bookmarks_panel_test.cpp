// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/bookmarks_panel.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include "tests/widgets/panels/timeline_run.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/moment_kinds.h"

namespace nadir {
namespace bookmarks_panel_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

BookmarksModel two_bookmarks() {
  BookmarksModel model;
  model.has_run = true;
  model.time_s = 5.0;
  model.bookmarks = {{5.0, "odd turn", {}}, {42.3, "", {}}};
  WorstMoment moment;
  moment.time_s = 17.5;
  moment.kind = MomentKind::kLargestError;
  moment.words = "2.8 m off, 95 % ellipse 0.9 m";
  moment.severity = 2.8;
  model.moments = {moment};
  model.values = {{"2.8", "m"}};
  return model;
}

struct ShownBookmarks {
  explicit ShownBookmarks(BookmarksModel shown)
      : model(std::move(shown)), screen(ThemeName::kDark, 1.0, {280.0, 600.0}) {
    asked = screen.wait(3, draw());
  }
  [[nodiscard]] std::function<Actions(kit::Ui&)> draw() {
    return [this](kit::Ui& ui) { return draw_bookmarks(ui, model, state); };
  }
  /// A click on the row's left, where no button lies.
  Actions click_row(const std::string& path) { return screen.click_at(path, 20.0, 14.0, draw()); }

  BookmarksModel model;
  BookmarksState state;
  kit::HeadlessUi screen;
  Actions asked;
};

TEST(BookmarksPanel, ARowGoesToItsMoment) {
  ShownBookmarks shown(two_bookmarks());
  EXPECT_THAT(shown.asked, IsEmpty());
  EXPECT_THAT(shown.click_row("Bookmarks/2/##go"), ElementsAre(Action(actions::GoToMoment{42.3})));
  EXPECT_THAT(shown.click_row("Bookmarks/Worst moments/1/##go"),
              ElementsAre(Action(actions::GoToMoment{17.5})));
}

TEST(BookmarksPanel, TellsTimesNotesKindsAndWords) {
  ShownBookmarks shown(two_bookmarks());
  EXPECT_TRUE(shown.screen.shows("00:42.3")) << shown.screen.words();
  EXPECT_TRUE(shown.screen.shows("odd turn"));
  EXPECT_TRUE(shown.screen.shows("without a note"));
  EXPECT_THAT(shown.screen.at("Bookmarks/Worst moments/1/##go").tooltip,
              testing::HasSubstr("largest error"));
  EXPECT_THAT(shown.screen.at("Bookmarks/Worst moments/1/##go").tooltip,
              testing::HasSubstr("2.8 m off, 95 % ellipse 0.9 m"));
  EXPECT_THAT(shown.screen.at("Bookmarks/Worst moments/1/##go").tooltip,
              testing::HasSubstr("2.8 times what is worth a look"));
  EXPECT_EQ(shown.screen.at("Bookmarks/Worst moments/1/largest error").value, "largest error");
  EXPECT_EQ(shown.screen.at("Bookmarks/Worst moments/1/2.8").value, "2.8");
  EXPECT_EQ(shown.screen.at("Bookmarks/Worst moments/1/m").value, "m");
  EXPECT_TRUE(shown.screen.at("Bookmarks/1/##go").is_selected) << "the cursor stands there";
  EXPECT_FALSE(shown.screen.at("Bookmarks/2/##go").is_selected);
}

TEST(BookmarksPanel, MarksThisMomentWithOrWithoutANote) {
  ShownBookmarks shown(two_bookmarks());
  EXPECT_THAT(shown.screen.click("Bookmarks/Mark this moment", shown.draw()),
              ElementsAre(Action(actions::AddBookmark{std::nullopt})));
  EXPECT_THAT(all_of<actions::AddBookmark>(
                  shown.screen.type("Bookmarks/##Note", "lost here", shown.draw())),
              ElementsAre(actions::AddBookmark{"lost here"}));
  EXPECT_EQ(shown.state.note, "");
}

TEST(BookmarksPanel, ChangesANoteInItsPlace) {
  ShownBookmarks shown(two_bookmarks());
  EXPECT_THAT(shown.screen.click("Bookmarks/1/Edit", shown.draw()), IsEmpty());
  const auto asked = shown.screen.type("Bookmarks/1/##Note", "wrong turn", shown.draw());
  EXPECT_THAT(asked, ElementsAre(Action(actions::EditBookmark{1, "wrong turn"})));
  EXPECT_FALSE(shown.state.edited_s);
}

TEST(BookmarksPanel, AClickElsewhereEndsANote) {
  ShownBookmarks shown(two_bookmarks());
  shown.screen.click("Bookmarks/1/Edit", shown.draw());
  shown.screen.wait(2, shown.draw());
  EXPECT_TRUE(shown.screen.has("Bookmarks/1/##Note"));
  shown.click_row("Bookmarks/2/##go");
  shown.screen.wait(2, shown.draw());
  EXPECT_FALSE(shown.screen.has("Bookmarks/1/##Note")) << "nothing was typed: it is a row again";
  EXPECT_TRUE(shown.screen.has("Bookmarks/1/##go"));
  shown.screen.click("Bookmarks/1/Edit", shown.draw());
  shown.screen.type("Bookmarks/1/##Note", "right turn", shown.draw(), false);
  Actions asked = shown.click_row("Bookmarks/2/##go");
  for (Action& more : shown.screen.wait(2, shown.draw())) asked.push_back(std::move(more));
  EXPECT_THAT(all_of<actions::EditBookmark>(asked),
              ElementsAre(actions::EditBookmark{1, "right turn"}));
  EXPECT_FALSE(shown.screen.has("Bookmarks/1/##Note"));
}

TEST(BookmarksPanel, ANoteStaysWithItsBookmarkWhenAnEarlierOneComes) {
  ShownBookmarks shown(two_bookmarks());
  shown.screen.click("Bookmarks/2/Edit", shown.draw());
  shown.model.bookmarks.insert(shown.model.bookmarks.begin(), Bookmark{1.0, "begin", {}});
  shown.screen.wait(1, shown.draw());
  EXPECT_TRUE(shown.screen.has("Bookmarks/3/##Note")) << "42.3 s is the third one now";
  EXPECT_FALSE(shown.screen.has("Bookmarks/2/##Note"));
}

TEST(BookmarksPanel, EscapeLeavesANoteAsItWas) {
  ShownBookmarks shown(two_bookmarks());
  shown.screen.click("Bookmarks/1/Edit", shown.draw());
  shown.screen.type("Bookmarks/1/##Note", "wrong", shown.draw(), false);
  EXPECT_THAT(shown.screen.press("Escape", shown.draw()), IsEmpty());
  EXPECT_FALSE(shown.state.edited_s);
}

TEST(BookmarksPanel, TakesABookmarkAway) {
  ShownBookmarks shown(two_bookmarks());
  EXPECT_THAT(shown.screen.click("Bookmarks/2/Remove", shown.draw()),
              ElementsAre(Action(actions::RemoveBookmark{2})));
  shown.state.edited_s = 42.3;
  shown.model.bookmarks.pop_back();
  shown.screen.wait(2, shown.draw());
  EXPECT_FALSE(shown.state.edited_s) << "what was edited is gone";
}

/// Forty moments, the more severe the later.
BookmarksModel many_moments() {
  BookmarksModel model;
  model.has_run = true;
  for (int i = 0; i < 40; ++i) {
    WorstMoment moment;
    moment.time_s = 10.0 * i;
    moment.kind = static_cast<MomentKind>(i % 6);
    moment.severity = 1.0 + i;
    model.moments.push_back(moment);
    model.values.push_back({fmt::format("{}.5", i), "m"});
  }
  return model;
}

TEST(BookmarksPanel, HasTheMostSevereFirstOrTheEarliest) {
  ShownBookmarks shown(many_moments());
  EXPECT_TRUE(shown.screen.at("Bookmarks/Worst moments/##Order/worst first").is_selected);
  EXPECT_EQ(shown.screen.at("Bookmarks/Worst moments/1/39.5").value, "39.5");
  EXPECT_THAT(shown.click_row("Bookmarks/Worst moments/1/##go"),
              ElementsAre(Action(actions::GoToMoment{390.0})));
  shown.screen.click("Bookmarks/Worst moments/##Order/by time", shown.draw());
  EXPECT_TRUE(shown.state.is_by_time);
  EXPECT_THAT(shown.click_row("Bookmarks/Worst moments/1/##go"),
              ElementsAre(Action(actions::GoToMoment{0.0})));
}

TEST(BookmarksPanel, ScrollsToTheLastOfManyMoments) {
  ShownBookmarks shown(many_moments());
  EXPECT_FALSE(shown.screen.at("Bookmarks/Worst moments/40/##go").is_visible);
  EXPECT_THAT(shown.click_row("Bookmarks/Worst moments/40/##go"),
              ElementsAre(Action(actions::GoToMoment{0.0})));
  EXPECT_TRUE(shown.screen.at("Bookmarks/Worst moments/40/##go").is_visible);
}

TEST(BookmarksPanel, KeepsKindsAndValuesInTheirRowAtEveryWidth) {
  for (const double width : {180.0, 280.0, 500.0}) {
    BookmarksState state;
    kit::HeadlessUi screen(ThemeName::kDark, 1.0, {width, 600.0});
    screen.wait(3, [&](kit::Ui& ui) { return draw_bookmarks(ui, many_moments(), state); });
    for (int row = 1; row <= 6; ++row) {
      const std::string path = fmt::format("Bookmarks/Worst moments/{}/", row);
      const double right = screen.at(path + "##go").rect.right();
      const kit::Control* const shown = screen.find(fmt::format("{}{}.5", path, 40 - row));
      EXPECT_EQ(shown != nullptr, width > 200.0) << width;
      if (shown == nullptr) continue;
      const kit::Rect number = screen.at(fmt::format("{}{}.5", path, 40 - row)).rect;
      EXPECT_LE(number.right(), right) << width;
      const auto kind = static_cast<MomentKind>((40 - row) % 6);
      const std::string name(moment_kind_look(kind).name);
      EXPECT_LE(screen.at(path + name).rect.right(), number.left) << width << name;
    }
  }
}

TEST(BookmarksPanel, SaysWhatWouldFillIt) {
  ShownBookmarks shown(BookmarksModel{});
  EXPECT_THAT(shown.screen.click("Bookmarks/Open the demo", shown.draw()),
              ElementsAre(Action(actions::OpenDemo{})));
  shown.model.has_run = true;
  shown.screen.wait(2, shown.draw());
  EXPECT_TRUE(shown.screen.shows("No bookmarks yet"));
  EXPECT_TRUE(shown.screen.shows("Nothing in this run"));
}

}  // namespace bookmarks_panel_test
}  // namespace nadir
