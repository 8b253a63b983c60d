// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/bookmarks_panel.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/timeline_run.h"
#include "widgets/kit/headless_ui.h"

namespace nadir {
namespace {

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
  model.moments = {moment};
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
  EXPECT_THAT(shown.click_row("Bookmarks/2/##go"), ElementsAre(Action(actions::Seek{42.3})));
  EXPECT_THAT(shown.click_row("Bookmarks/Worst moments/1/##go"),
              ElementsAre(Action(actions::Seek{17.5})));
}

TEST(BookmarksPanel, TellsTimesNotesKindsAndWords) {
  ShownBookmarks shown(two_bookmarks());
  EXPECT_TRUE(shown.screen.shows("00:42.3")) << shown.screen.words();
  EXPECT_TRUE(shown.screen.shows("odd turn"));
  EXPECT_TRUE(shown.screen.shows("without a note"));
  EXPECT_THAT(shown.screen.at("Bookmarks/Worst moments/1/##go").tooltip,
              testing::HasSubstr("largest error"));
  EXPECT_TRUE(shown.screen.shows("2.8 m off"));
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
  EXPECT_FALSE(shown.state.edited);
}

TEST(BookmarksPanel, EscapeLeavesANoteAsItWas) {
  ShownBookmarks shown(two_bookmarks());
  shown.screen.click("Bookmarks/1/Edit", shown.draw());
  shown.screen.type("Bookmarks/1/##Note", "wrong", shown.draw(), false);
  EXPECT_THAT(shown.screen.press("Escape", shown.draw()), IsEmpty());
  EXPECT_FALSE(shown.state.edited);
}

TEST(BookmarksPanel, TakesABookmarkAway) {
  ShownBookmarks shown(two_bookmarks());
  EXPECT_THAT(shown.screen.click("Bookmarks/2/Remove", shown.draw()),
              ElementsAre(Action(actions::RemoveBookmark{2})));
  shown.state.edited = 1;
  shown.model.bookmarks.pop_back();
  shown.screen.wait(2, shown.draw());
  EXPECT_FALSE(shown.state.edited) << "what was edited is gone";
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

}  // namespace
}  // namespace nadir
