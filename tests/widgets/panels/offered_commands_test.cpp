// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/offered_commands.h"

#include <gmock/gmock.h>

#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/asked.h"

namespace nadir {
namespace offered_commands_test {

struct Looks {
  ViewState view = default_view_state();
  Playback playback;
  [[nodiscard]] std::optional<bool> operator()(const Action& action) const {
    return is_on(action, view, playback);
  }
};

TEST(IsOn, SaysWhetherALayerAPanelOrAStripShows) {
  Looks looks;
  looks.view.map.layer(Layer::kParticles).is_visible = false;
  looks.view.map.layer(Layer::kTruth).is_visible = true;
  EXPECT_EQ(looks(actions::ShowLayer{Layer::kParticles}), false);
  EXPECT_EQ(looks(actions::ShowLayer{Layer::kTruth}), true);
  looks.view.layout.is_shown[static_cast<std::size_t>(Panel::kLog)] = true;
  EXPECT_EQ(looks(actions::ShowPanel{Panel::kLog}), true);
  looks.view.layout.strips = {{Strip::kNees, false, 40.0}, {Strip::kSigma, true, 40.0}};
  EXPECT_EQ(looks(actions::ShowStrip{Strip::kNees}), false);
  EXPECT_EQ(looks(actions::ShowStrip{Strip::kSigma}), true);
}

TEST(IsOn, SaysWhichOfSeveralIsChosen) {
  Looks looks;
  looks.view.appearance.theme = LightOrDark::kLight;
  looks.view.map.up = MapUp::kHeading;
  looks.view.map.tool = MapTool::kMeasure;
  looks.view.map.topview_at = PoseSource::kTruth;
  looks.playback.speed = 2.0;
  EXPECT_EQ(looks(actions::SetTheme{LightOrDark::kLight}), true);
  EXPECT_EQ(looks(actions::SetTheme{LightOrDark::kDark}), false);
  EXPECT_EQ(looks(actions::SetUp{MapUp::kHeading}), true);
  EXPECT_EQ(looks(actions::UseTool{MapTool::kPan}), false);
  EXPECT_EQ(looks(actions::LayTopview{PoseSource::kTruth}), true);
  EXPECT_EQ(looks(actions::SetSpeed{2.0}), true);
  EXPECT_EQ(looks(actions::SetSpeed{1.0}), false);
}

TEST(IsOn, SaysWhatIsSwitched) {
  Looks looks;
  looks.view.map.is_following = true;
  looks.view.layout.is_map_only = true;
  EXPECT_EQ(looks(actions::Follow{}), true);
  EXPECT_EQ(looks(actions::MapOnly{}), true);
  EXPECT_EQ(looks(actions::SplitView{}), false);
  EXPECT_EQ(looks(actions::ReduceMotion{}), false);
}

TEST(IsOn, KnowsNothingOfActionsThatDoSomethingOnce) {
  const Looks looks;
  EXPECT_EQ(looks(actions::OpenDemo{}), std::nullopt);
  EXPECT_EQ(looks(actions::Seek{1.0}), std::nullopt);
}

TEST(OfferedCommands, AreAllInTheirOrderWithTheSessionsReasons) {
  const ScratchFolder folder;
  const Session session({folder.path() / "config", folder.path() / "data", {}});
  const std::vector<OfferedCommand> offered = offered_commands(session);
  ASSERT_EQ(offered.size(), session_commands().size());
  for (std::size_t i = 0; i < offered.size(); ++i) {
    EXPECT_EQ(offered[i].command, &session_commands()[i]);
    EXPECT_EQ(offered[i].why_not, why_not(session_commands()[i], session));
  }
}

TEST(OfferedCommands, MarkTheThemeThatTheWindowHas) {
  const ScratchFolder folder;
  Session session({folder.path() / "config", folder.path() / "data", {}});
  ASSERT_TRUE(session.apply(actions::SetTheme{LightOrDark::kLight}));
  std::vector<OfferedCommand> offered = offered_commands(session);
  EXPECT_EQ(offered_as(offered, "theme light").is_on, true);
  EXPECT_EQ(offered_as(offered, "theme dark").is_on, false);
}

}  // namespace offered_commands_test
}  // namespace nadir
