// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/work_card.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/asked.h"
#include "widgets/kit/headless_ui.h"
#include "widgets/panels/welcome_panel.h"

namespace nadir {
namespace work_card_test {

using ::testing::ElementsAre;

JobStatus making_the_demo() { return {7, "making the demo", 0.4, "rendering frames", 18.0, true}; }

struct Card {
  kit::HeadlessUi screen;
  kit::Rect inside{100.0, 50.0, 900.0, 500.0};
  Actions operator()(kit::Ui& ui) { return draw_work_card(ui, making_the_demo(), inside); }
};

TEST(WorkCard, SaysWhatIsDoneHowFarAndForHowLong) {
  Card card;
  card.screen.leave_out_region();
  card.screen.wait(2, card);
  EXPECT_TRUE(card.screen.shows("Making the demo"));
  EXPECT_EQ(card.screen.at("Card/Work/##Progress").value, "40 %, rendering frames · 18 s left");
}

TEST(WorkCard, StopsTheWork) {
  Card card;
  card.screen.leave_out_region();
  EXPECT_THAT(texts(card.screen.click("Card/Work/Cancel", card)), ElementsAre("cancel 7"));
}

TEST(WorkCard, StandsInTheMiddleAndHoldsAllOfIt) {
  for (const double scale : {1.0, 1.5}) {
    Card card{kit::HeadlessUi(ThemeName::kLight, scale, {1280.0, 800.0})};
    card.screen.leave_out_region();
    card.screen.wait(2, card);
    const kit::Rect track = card.screen.at("Card/Work/##Progress").rect;
    EXPECT_NEAR(track.centre().x(), 550.0, 1.0);
    for (const kit::Control& control : card.screen.controls()) {
      if (!control.path.starts_with("Card/Work/")) continue;
      EXPECT_GE(control.rect.top, 300.0 - 72.0 * scale) << control.path;
      EXPECT_LE(control.rect.bottom(), 300.0 + 72.0 * scale - 12.0) << control.path;
    }
  }
}

TEST(WorkCard, IsLeftOutWhereItHasNoRoom) {
  Card card;
  card.screen.leave_out_region();
  card.inside = {0.0, 0.0, 200.0, 500.0};
  card.screen.wait(2, card);
  EXPECT_TRUE(card.screen.controls().empty());
}

struct Welcome {
  kit::HeadlessUi screen;
  WelcomeModel model;
  Actions operator()(kit::Ui& ui) { return draw_welcome(ui, model); }
};

TEST(Welcome, ShowsTheDemoOnItsWayWhereItWasOffered) {
  Welcome welcome;
  welcome.model.busy = "making the demo";
  welcome.screen.wait(2, welcome);
  EXPECT_FALSE(welcome.screen.has("Welcome/Work/Cancel")) << "nobody waits for it";
  const kit::Rect offered = welcome.screen.at("Welcome/Open the demo").rect;
  welcome.model.work = making_the_demo();
  EXPECT_THAT(texts(welcome.screen.click("Welcome/Work/Cancel", welcome)), ElementsAre("cancel 7"));
  EXPECT_EQ(welcome.screen.at("Welcome/Work/##Progress").rect.left, offered.left);
  EXPECT_FALSE(welcome.screen.has("Welcome/Open the demo")) << "it is being made";
  EXPECT_TRUE(welcome.screen.has("Welcome/Open files…"));
}

}  // namespace work_card_test
}  // namespace nadir
