// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/notices.h"

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"

namespace nadir {
namespace notices_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

struct Notices {
  kit::HeadlessUi screen;
  NoticesModel model;
  NoticesState state;
  kit::Rect inside{0.0, 0.0, 1280.0, 800.0};
  Actions operator()(kit::Ui& ui) { return draw_notices(ui, model, state, inside); }
  Notice& add(int number) {
    Notice notice;
    notice.number = number;
    notice.kind = Notice::Kind::kError;
    notice.text = "loop.nadir: step 7 is damaged";
    notice.details = "checksum 12 instead of 34";
    model.all.push_back(notice);
    return model.all.back();
  }
  void add_many(int count) {
    for (int number = 1; number <= count; ++number) add(number);
  }
  [[nodiscard]] std::vector<int> shown() const {
    std::vector<int> numbers;
    for (const Notice& notice : model.all) {
      if (screen.has("Notices/" + std::to_string(notice.number))) numbers.push_back(notice.number);
    }
    return numbers;
  }
};

TEST(Notices, AreDismissedCopiedAndRemedied) {
  Notices notices;
  Notice& notice = notices.add(3);
  notice.remedy = actions::OpenDemo{};
  notice.remedy_title = "Open the demo";
  EXPECT_THAT(texts(notices.screen.click("Notices/3/Open the demo", notices)),
              ElementsAre("open-demo", "dismiss 3"));
  EXPECT_THAT(texts(notices.screen.click("Notices/3/Dismiss", notices)), ElementsAre("dismiss 3"));
  const Actions asked = notices.screen.click("Notices/3/Copy", notices);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(std::get<actions::Copy>(asked[0]).text,
            "loop.nadir: step 7 is damaged\nchecksum 12 instead of 34");
}

TEST(Notices, StandAboveEachOtherInTheLowerRightCorner) {
  Notices notices;
  notices.add_many(2);
  notices.screen.wait(4, notices);
  const kit::Rect older = notices.screen.at("Notices/1").rect,
                  newer = notices.screen.at("Notices/2").rect;
  EXPECT_LE(older.bottom(), newer.top);
  EXPECT_LE(newer.bottom(), 800.0);
  EXPECT_GT(newer.left, 640.0);
  EXPECT_FALSE(notices.screen.has("Notices/more"));
}

TEST(Notices, OfWhichThereAreManyAreCountedAboveTheNewest) {
  Notices notices;
  notices.add_many(6);
  notices.screen.wait(4, notices);
  EXPECT_THAT(notices.shown(), ElementsAre(4, 5, 6));
  EXPECT_EQ(notices.screen.at("Notices/more").value, "3 more");
  const kit::Rect line = notices.screen.at("Notices/more").rect;
  EXPECT_LT(line.bottom(), notices.screen.at("Notices/4").rect.top);
  EXPECT_LT(line.height, 50.0) << "one line with its button";
  EXPECT_LT(notices.screen.at("Notices/more/Show all").rect.right(),
            notices.screen.at("Notices/more/Dismiss").rect.left);
  EXPECT_THAT(texts(notices.screen.click("Notices/more/Dismiss", notices)),
              ElementsAre("dismiss 1", "dismiss 2", "dismiss 3"))
      << "those that it counts, and no others";
}

TEST(Notices, ShowAllOfThemWhereThatIsAskedFor) {
  Notices notices;
  notices.add_many(6);
  EXPECT_THAT(notices.screen.click("Notices/more/Show all", notices), IsEmpty());
  notices.screen.wait(4, notices);
  EXPECT_THAT(notices.shown(), ElementsAre(1, 2, 3, 4, 5, 6));
  EXPECT_EQ(notices.screen.at("Notices/more").value, "6 notices");
  notices.screen.click("Notices/more/Show fewer", notices);
  notices.screen.wait(4, notices);
  EXPECT_THAT(notices.shown(), ElementsAre(4, 5, 6));
  notices.screen.click("Notices/more/Show all", notices);
  notices.model.all.resize(2);
  notices.screen.wait(4, notices);
  EXPECT_FALSE(notices.state.shows_all) << "the next flood begins anew";
}

TEST(Notices, StayInTheirPartOfTheWindow) {
  for (const double height : {150.0, 200.0, 300.0, 420.0, 600.0}) {
    for (const bool shows_all : {false, true}) {
      Notices notices;
      notices.inside = {200.0, 40.0, 700.0, height};
      notices.add_many(9);
      notices.model.all[7].text.clear();
      for (int i = 0; i < 14; ++i) notices.model.all[7].text.append("a story that goes on ");
      notices.state.shows_all = shows_all;
      notices.screen.wait(5, notices);
      EXPECT_TRUE(notices.screen.has("Notices/9")) << "the newest in any case";
      for (const kit::Control& control : notices.screen.controls()) {
        EXPECT_GE(control.rect.top, 40.0) << height << " " << control.path;
        EXPECT_LE(control.rect.bottom(), 40.0 + height) << height << " " << control.path;
      }
    }
  }
}

TEST(Notices, AreCountedByTheNewestWhereALineOfTheirOwnHasNoRoom) {
  Notices notices;
  notices.inside = {200.0, 40.0, 700.0, 150.0};
  notices.add_many(4);
  notices.model.all.back().kind = Notice::Kind::kInfo;
  notices.model.all[1].kind = Notice::Kind::kWarning;
  notices.screen.wait(5, notices);
  EXPECT_THAT(notices.shown(), ElementsAre(4));
  EXPECT_FALSE(notices.screen.has("Notices/more"));
  EXPECT_EQ(notices.screen.at("Notices/4").value,
            "Newest of 4, 2 errors hidden: loop.nadir: step 7 is damaged");
  const Actions asked = notices.screen.click("Notices/4/Copy", notices);
  ASSERT_EQ(asked.size(), 1U);
  EXPECT_EQ(std::get<actions::Copy>(asked[0]).text,
            "loop.nadir: step 7 is damaged\nchecksum 12 instead of 34")
      << "its own words";
  notices.model.all.pop_back();
  notices.screen.wait(5, notices);
  EXPECT_EQ(notices.screen.at("Notices/3").value,
            "Newest of 3, 1 error hidden: loop.nadir: step 7 is damaged");
  notices.model.all.erase(notices.model.all.begin());
  notices.screen.wait(5, notices);
  EXPECT_EQ(notices.screen.at("Notices/3").value, "Newest of 2: loop.nadir: step 7 is damaged")
      << "a warning is counted, and no error is hidden";
  notices.model.all.erase(notices.model.all.begin());
  notices.screen.wait(5, notices);
  EXPECT_EQ(notices.screen.at("Notices/3").value, "loop.nadir: step 7 is damaged");
}

TEST(Notices, HideNoneWithoutACountInAnyRoom) {
  for (double height = 60.0; height <= 640.0; height += 20.0) {
    Notices notices;
    notices.inside = {200.0, 40.0, 700.0, height};
    notices.add_many(5);
    notices.screen.wait(5, notices);
    const std::size_t shown = notices.shown().size();
    ASSERT_GE(shown, 1U) << height;
    const bool is_counted = notices.screen.has("Notices/more") ||
                            notices.screen.at("Notices/5").value.starts_with("Newest of 5");
    EXPECT_EQ(is_counted, shown < 5) << height;
  }
}

TEST(NoticesModel, HasAllOfASession) {
  const ScratchFolder folder;
  Session session({folder.path() / "config", folder.path() / "data", {}});
  for (int i = 0; i < 6; ++i) session.notify(Notice::Kind::kInfo, "notice " + std::to_string(i));
  const NoticesModel model = notices_model(session);
  ASSERT_EQ(model.all.size(), 6U);
  EXPECT_EQ(model.all.back().text, "notice 5");
}

}  // namespace notices_test
}  // namespace nadir
