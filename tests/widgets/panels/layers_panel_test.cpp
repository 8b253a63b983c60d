// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/layers_panel.h"

#include <gmock/gmock.h>

#include <map>
#include <set>
#include <utility>

#include "tests/widgets/panels/timeline_run.h"
#include "widgets/kit/headless_ui.h"

namespace nadir {
namespace layers_panel_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// The layers of a new window, from the top, all with data.
LayersModel layers_of_new_window() {
  LayersModel model;
  const MapLook look = default_map_look();
  for (auto layer = look.order.rbegin(); layer != look.order.rend(); ++layer) {
    model.rows.push_back({*layer, look.layer(*layer), ""});
  }
  model.classes = {{kRoad, 0.62}, {kTerrain, 0.3}, {kBuilding, 0.08}};
  return model;
}

struct ShownLayers {
  explicit ShownLayers(LayersModel shown, double width_pt = 280.0, double scale = 1.0)
      : model(std::move(shown)),
        screen(ThemeName::kLight, scale, {width_pt * scale, 760.0 * scale}) {
    asked = screen.wait(3, draw());
  }
  [[nodiscard]] std::function<Actions(kit::Ui&)> draw() {
    return [this](kit::Ui& ui) { return draw_layers(ui, model, state); };
  }
  LayersModel model;
  LayersState state;
  kit::HeadlessUi screen;
  Actions asked;
};

TEST(LayersPanel, ListsEveryLayerFromTheTopAndAsksForNothing) {
  ShownLayers shown(layers_of_new_window());
  EXPECT_THAT(shown.asked, IsEmpty());
  std::set<std::string_view> titles;
  for (const LayersModel::Row& row : shown.model.rows) {
    EXPECT_TRUE(shown.screen.has("Layers/" + std::string(enum_name(row.layer)) + "/visible"))
        << shown.screen.words();
    titles.insert(layer_title(row.layer));
  }
  EXPECT_EQ(titles.size(), kLayerCount);
}

TEST(LayersPanel, AnEyeHidesAndShows) {
  ShownLayers shown(layers_of_new_window());
  for (LayersModel::Row& row : shown.model.rows) row.look.is_visible = row.layer != Layer::kTruth;
  EXPECT_THAT(shown.screen.click("Layers/particles/visible", shown.draw()),
              ElementsAre(Action(actions::ShowLayer{Layer::kParticles, Switch::kOff})));
  EXPECT_THAT(shown.screen.click("Layers/truth/visible", shown.draw()),
              ElementsAre(Action(actions::ShowLayer{Layer::kTruth, Switch::kOn})));
}

TEST(LayersPanel, ASliderSetsOpacity) {
  ShownLayers shown(layers_of_new_window());
  const auto asked = all_of<actions::SetLayerOpacity>(
      shown.screen.drag("Layers/topview/opacity", -300.0, 0.0, shown.draw()));
  ASSERT_FALSE(asked.empty());
  EXPECT_EQ(asked.back(), (actions::SetLayerOpacity{Layer::kTopview, 0.0}));
}

TEST(LayersPanel, TheLegendIsThereOrNotButNeverPale) {
  ShownLayers shown(layers_of_new_window());
  EXPECT_FALSE(shown.screen.has("Layers/legend/opacity"));
  EXPECT_TRUE(shown.screen.has("Layers/legend/visible"));
  EXPECT_TRUE(shown.screen.has("Layers/particles/opacity"));
}

TEST(LayersPanel, OnlyLinesHaveAColour) {
  ShownLayers shown(layers_of_new_window());
  EXPECT_TRUE(shown.screen.has("Layers/estimate/##colour"));
  EXPECT_TRUE(shown.screen.has("Layers/truth/##colour"));
  EXPECT_FALSE(shown.screen.has("Layers/particles/##colour"));
  EXPECT_FALSE(shown.screen.has("Layers/picture/##colour"));
}

TEST(LayersPanel, AColourGoesBackToTheThemes) {
  LayersModel model = layers_of_new_window();
  for (LayersModel::Row& row : model.rows) {
    if (row.layer == Layer::kEstimate) row.look.colour = "#FF0000";
  }
  ShownLayers shown(model);
  shown.screen.right_click("Layers/estimate/##colour", shown.draw());
  EXPECT_THAT(shown.screen.click("Layers/estimate/colour menu/As the theme has it", shown.draw()),
              ElementsAre(Action(actions::SetLayerColour{Layer::kEstimate, std::nullopt})));
}

TEST(LayersPanel, AGripRaisesALayer) {
  ShownLayers shown(layers_of_new_window());
  const Layer third = shown.model.rows[2].layer;
  const std::string grip = "Layers/" + std::string(enum_name(third)) + "/grip";
  const double row_height =
      shown.screen.at("Layers/" + std::string(enum_name(shown.model.rows[3].layer)) + "/grip")
          .rect.top -
      shown.screen.at(grip).rect.top;
  const auto asked =
      all_of<actions::MoveLayer>(shown.screen.drag(grip, 0.0, -2.0 * row_height, shown.draw()));
  EXPECT_THAT(asked, ElementsAre(actions::MoveLayer{third, 2}));
}

TEST(LayersPanel, HasItsControlsBelowEachOtherHoweverNarrowItIs) {
  for (const double scale : {1.0, 1.5}) {
    for (double width_pt = 180.0; width_pt <= 400.0; width_pt += 11.0) {
      ShownLayers shown(layers_of_new_window(), width_pt, scale);
      std::map<std::string, std::set<std::pair<double, double>>> columns;
      for (const LayersModel::Row& row : shown.model.rows) {
        const std::string path = "Layers/" + std::string(enum_name(row.layer));
        const kit::Rect name =
            shown.screen.at(path + "/" + std::string(layer_title(row.layer))).rect;
        for (const char* const part : {"opacity", "##colour", "visible"}) {
          const kit::Control* const control = shown.screen.find(path + "/" + part);
          if (control == nullptr) continue;
          columns[part].insert({control->rect.left, control->rect.right()});
          EXPECT_LE(control->rect.right(), width_pt * scale);
          const double least = part == std::string("visible") ? 0.0 : name.right();
          EXPECT_GE(control->rect.left, least) << path;
        }
      }
      for (const auto& [part, places] : columns)
        EXPECT_EQ(places.size(), 1U) << part << " at " << width_pt << " by " << scale;
      EXPECT_TRUE(columns.contains("##colour")) << width_pt;
      EXPECT_EQ(columns.contains("opacity"), width_pt > 220.0) << width_pt;
    }
  }
}

TEST(LayersPanel, SaysWhyALayerIsEmptyInPlaceOfItsSlider) {
  LayersModel model = layers_of_new_window();
  for (LayersModel::Row& row : model.rows) {
    if (row.layer == Layer::kParticles) row.why_empty = "not recorded";
  }
  ShownLayers shown(model);
  EXPECT_TRUE(shown.screen.shows("not recorded"));
  EXPECT_FALSE(shown.screen.has("Layers/particles/opacity"));
  EXPECT_TRUE(shown.screen.has("Layers/particles/visible")) << "it can still be hidden";
}

TEST(LayersPanel, AMenuRaisesAndLowersWithoutADrag) {
  ShownLayers shown(layers_of_new_window());
  const auto choose = [&](Layer layer, const std::string& item) {
    const std::string row = "Layers/" + std::string(enum_name(layer));
    shown.screen.right_click(row + "/" + std::string(layer_title(layer)), shown.draw());
    return shown.screen.click(row + "/order/" + item, shown.draw());
  };
  EXPECT_THAT(choose(Layer::kParticles, "Raise"),
              ElementsAre(Action(actions::MoveLayer{Layer::kParticles, 1})));
  EXPECT_THAT(choose(Layer::kParticles, "Lower"),
              ElementsAre(Action(actions::MoveLayer{Layer::kParticles, -1})));
  // The picture is the lowest of fourteen, the legend the uppermost.
  EXPECT_THAT(choose(Layer::kPicture, "To the top"),
              ElementsAre(Action(actions::MoveLayer{Layer::kPicture, 12})));
  EXPECT_THAT(choose(Layer::kGraticule, "To the ground"),
              ElementsAre(Action(actions::MoveLayer{Layer::kGraticule, -12})));
}

TEST(LayersPanel, AMenuOpensByTheKeyboardOnGripAndEye) {
  for (const char* const part : {"grip", "visible"}) {
    ShownLayers shown(layers_of_new_window());
    const std::string row = "Layers/particles";
    shown.screen.press("Shift+Tab", shown.draw());
    for (int tabs = 0; tabs < 80 && !shown.screen.at(row + "/" + part).is_focused; ++tabs) {
      shown.screen.press("Tab", shown.draw());
    }
    ASSERT_TRUE(shown.screen.at(row + "/" + part).is_focused) << part;
    shown.screen.press("Shift+F10", shown.draw());
    shown.screen.wait(2, shown.draw());
    ASSERT_TRUE(shown.screen.has(row + "/order/Raise")) << part;
    const kit::Rect control = shown.screen.at(row + "/" + part).rect;
    const kit::Rect item = shown.screen.at(row + "/order/Raise").rect;
    EXPECT_NEAR(item.left, control.left, 12.0) << "below the control and not where the mouse is";
    EXPECT_GE(item.top, control.bottom());
    EXPECT_THAT(shown.screen.click(row + "/order/Raise", shown.draw()),
                ElementsAre(Action(actions::MoveLayer{Layer::kParticles, 1})));
  }
}

TEST(LayersPanel, TheLegendStaysOnTopAndSaysSo) {
  ShownLayers shown(layers_of_new_window());
  EXPECT_FALSE(shown.screen.at("Layers/legend/grip").is_enabled);
  EXPECT_TRUE(shown.screen.at("Layers/graticule/grip").is_enabled);
  shown.screen.hover("Layers/legend/grip", shown.draw());
  EXPECT_THAT(shown.screen.tooltip(), HasSubstr("always lies on top"));
}

TEST(LayersPanel, LaysTheTopviewAtAnotherPose) {
  ShownLayers shown(layers_of_new_window());
  EXPECT_THAT(shown.screen.click("Layers/topview at/truth", shown.draw()),
              ElementsAre(Action(actions::LayTopview{PoseSource::kTruth})));
}

TEST(LayersPanel, TellsClassesWithTheirShares) {
  ShownLayers shown(layers_of_new_window());
  EXPECT_EQ(shown.screen.at("Layers/Classes/shares/road/share").value, "62 %");
  EXPECT_EQ(shown.screen.at("Layers/Classes/shares/building/share").value, "8.0 %");
  shown.model.classes.clear();
  shown.screen.wait(2, shown.draw());
  EXPECT_TRUE(shown.screen.shows("No map is open"));
}

TEST(LayersPanel, TakesAColourThatIsNoneForTheThemes) {
  LayersModel model = layers_of_new_window();
  for (LayersModel::Row& row : model.rows) row.look.colour = "#GG00ZZ";
  EXPECT_THAT(ShownLayers(model).asked, IsEmpty());
}

}  // namespace layers_panel_test
}  // namespace nadir
