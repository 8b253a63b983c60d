// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/widgets/panels/made_moment.h"
#include "tests/widgets/views/drawn_chart.h"
#include "widgets/panels/map_lines.h"

namespace nadir {
namespace map_legend_test {

using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::IsSupersetOf;
using ::testing::Not;

SemanticTopview one_cell(ClassId id) {
  SemanticTopview topview;
  topview.cells.resize(1);
  for (std::size_t next = id + 1U; next < topview.class_begin.size(); ++next) {
    topview.class_begin.at(next) = 1;
  }
  return topview;
}

class MapLegend : public ::testing::Test {
 protected:
  MapLegend() {
    for (LayerLook& layer : model.look.layers) layer.is_visible = false;
  }
  void show(Layer layer) { model.look.layer(layer).is_visible = true; }
  [[nodiscard]] std::vector<LegendEntry> entries() const {
    return map_legend(model, {1}, seen, theme(ThemeName::kDark));
  }
  [[nodiscard]] std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const LegendEntry& entry : entries()) all.push_back(entry.name);
    return all;
  }

  const MadeMoment made;
  MapViewModel model = made.map_view();
  SeenClasses seen;
};

TEST_F(MapLegend, NamesWhatIsShownOnly) {
  EXPECT_THAT(names(), IsEmpty());
  show(Layer::kTruth);
  show(Layer::kEstimate);
  EXPECT_THAT(names(), ElementsAre("truth", "estimate"));
  show(Layer::kLabels);
  EXPECT_THAT(names(), Contains("road"));
  EXPECT_THAT(names(), Not(Contains("car")));
  model.look.layer(Layer::kLabels).opacity = 0.0;
  EXPECT_THAT(names(), ElementsAre("truth", "estimate")) << "what is clear is not in sight";
}

TEST_F(MapLegend, ShowsParticlesAsTheyAreDrawn) {
  show(Layer::kParticles);
  ASSERT_THAT(names(), ElementsAre("particles"));
  const LegendEntry alike = entries()[0];
  EXPECT_EQ(alike.kind, LegendEntry::Kind::kParticle);
  EXPECT_EQ(alike.colour, value_colour(ValueColours::kViridis, kEqualWeightShare));
  EXPECT_EQ(alike.casing.alpha, particle_casing(theme(ThemeName::kDark), true).alpha);
  RunStep weighed = *made.step;
  weighed.particles->weight[7] *= 2.0;
  model.step = std::make_shared<const RunStep>(weighed);
  EXPECT_EQ(entries()[0].kind, LegendEntry::Kind::kParticles);
  EXPECT_THAT(names(), ElementsAre("particles")) << "as long as before, so that nothing moves";
  weighed.particles.reset();
  model.step = std::make_shared<const RunStep>(weighed);
  EXPECT_THAT(names(), IsEmpty()) << "none were recorded";
}

TEST_F(MapLegend, NamesClassesOfTheTopview) {
  show(Layer::kTopview);
  EXPECT_THAT(names(), Contains("road"));
  model.step.reset();
  EXPECT_THAT(names(), IsEmpty()) << "nothing is decoded";
  model.step = made.step;
  model.map.reset();
  EXPECT_THAT(names(), Not(Contains("road"))) << "nothing has been seen";
  seen.add("loop", *made.step);
  EXPECT_THAT(names(), Contains("road")) << "without a map those that were seen";
  model.look.topview_at = PoseSource::kOdometry;
  RunStep lost = *made.step;
  lost.odometry_in_enu.reset();
  model.step = std::make_shared<const RunStep>(lost);
  EXPECT_THAT(names(), IsEmpty()) << "it lies nowhere";
}

TEST_F(MapLegend, NamesClassesThatOnlyTopviewsHaveAndKeepsThem) {
  show(Layer::kTopview);
  EXPECT_THAT(names(), Not(Contains("car")));
  RunStep with_car = *made.step;
  with_car.topview = one_cell(kCar);
  seen.add("loop", *made.step);
  seen.add("loop", with_car);
  EXPECT_THAT(names(), Contains("car"));
  seen.add("loop", *made.step);
  EXPECT_THAT(names(), Contains("car")) << "the legend rests";
  show(Layer::kLabels);
  model.look.layer(Layer::kTopview).is_visible = false;
  EXPECT_THAT(names(), Not(Contains("car"))) << "the map has none";
  show(Layer::kTopview);
  seen.add("another run", *made.step);
  EXPECT_THAT(names(), Not(Contains("car"))) << "of another run nothing is known";
}

TEST_F(MapLegend, ThatLastsIsTheSameAtEveryMomentOfARun) {
  for (const Layer layer : {Layer::kParticles, Layer::kTopview, Layer::kDisagreement,
                            Layer::kErrorSurface, Layer::kTruth}) {
    show(layer);
  }
  const auto lasting = [this] {
    std::vector<std::string> all;
    for (const LegendEntry& entry : lasting_map_legend(model, {1}, theme(ThemeName::kDark))) {
      all.push_back(entry.name);
    }
    return all;
  };
  const std::vector<std::string> at_first = lasting();
  EXPECT_THAT(at_first,
              IsSupersetOf({"truth", "particles", "agrees", "cost 1.00 to 0.00", "road"}));
  model.surface_costs = CostRange{0.21F, 0.84F};
  EXPECT_EQ(lasting(), at_first);
  RunStep bare = *made.step;
  bare.particles.reset();
  bare.topview.reset();
  model.step = std::make_shared<const RunStep>(bare);
  EXPECT_EQ(lasting(), at_first) << "nothing was seen in this step";
  EXPECT_THAT(names(), Not(Contains("particles"))) << "the legend itself says so";
  model.step.reset();
  EXPECT_EQ(lasting(), at_first) << "it is not decoded yet";
  RunDocument blind = *made.document;
  for (RunStep& step : blind.steps) step.topview_cells = step.particle_count = 0;
  model.runs[0].document = std::make_shared<const RunDocument>(blind);
  EXPECT_THAT(lasting(), ElementsAre("truth", "cost 1.00 to 0.00")) << "of a run without either";
}

TEST_F(MapLegend, NamesTheClassesOfAMapOfLabelsOnly) {
  show(Layer::kPicture);
  EXPECT_THAT(names(), IsEmpty()) << "its picture is seen";
  model.has_picture = false;
  EXPECT_THAT(names(), Contains("road")) << "its labels are, in the picture's place";
  model.look.layer(Layer::kPicture).opacity = 0.0;
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(MapLegend, LeavesOutClassesInAHalf) {
  show(Layer::kTopview);
  show(Layer::kTruth);
  std::vector<std::string> all;
  for (const LegendEntry& entry : map_legend(model, {1}, seen, theme(ThemeName::kDark), false)) {
    all.push_back(entry.name);
  }
  EXPECT_THAT(all, ElementsAre("truth"));
}

TEST_F(MapLegend, OutlinesAClassThatIsAsDarkAsThePlate) {
  show(Layer::kLabels);
  for (const LegendEntry& entry : entries()) {
    const bool is_dark = entry.colour == class_colour(kBuilding);
    EXPECT_EQ(entry.kind == LegendEntry::Kind::kOutlinedBar, is_dark) << entry.name;
  }
}

TEST_F(MapLegend, NamesAgreementInItsColours) {
  show(Layer::kDisagreement);
  const Theme& dark = theme(ThemeName::kDark);
  ASSERT_THAT(names(), ElementsAre("agrees", "disagrees", "unknown to the map"));
  EXPECT_EQ(entries()[0].colour, dark.agreement);
  EXPECT_EQ(entries()[1].colour, dark.disagreement);
  EXPECT_EQ(entries()[1].kind, LegendEntry::Kind::kStripedBar);
  model.map.reset();
  EXPECT_THAT(names(), IsEmpty());
}

TEST_F(MapLegend, NamesTheScaleOfTheErrorSurfaceWhileItIsThere) {
  show(Layer::kErrorSurface);
  EXPECT_THAT(names(), IsEmpty());
  model.surface_costs = CostRange{0.21F, 0.84F};
  ASSERT_THAT(names(), ElementsAre("cost 0.84 to 0.21"));
  EXPECT_EQ(entries()[0].kind, LegendEntry::Kind::kRamp);
}

TEST_F(MapLegend, NamesRunsWhereThereAreSeveral) {
  show(Layer::kEstimate);
  MapRun other = model.runs[0];
  other.number = 2;
  other.name = "again";
  other.is_active = false;
  model.runs.insert(model.runs.begin(), other);
  std::vector<std::string> all;
  for (const LegendEntry& entry : map_legend(model, {1, 2}, seen, theme(ThemeName::kDark))) {
    all.push_back(entry.name);
  }
  EXPECT_THAT(all, ElementsAre("loop", "again"));
}

TEST(MapLegendPlate, LiesAtTheLowerRightAndLeavesTheScaleBarItsPlace) {
  const std::vector<LegendEntry> many(12, {"lane marking", {1, 2, 3}, LegendEntry::Kind::kBar});
  for (const double width : {400.0, 576.0, 1200.0}) {
    RecordingCanvas canvas;
    const MapFrame frame{{0.0, 0.0, width, 540.0}, {}, 96.0 / 72.0};
    LegendFit fit;
    const PageRect plate = draw_map_legend(canvas, frame, many, theme(ThemeName::kDark), fit);
    ASSERT_GT(plate.width, 0.0) << width;
    EXPECT_GT(plate.left, 0.27 * width);
    EXPECT_LT(plate.right(), width);
    EXPECT_LT(plate.height, 0.5 * 540.0);
    EXPECT_EQ(canvas.texts.size(), many.size()) << "all of it is said";
  }
}

TEST(MapLegendPlate, CountsWhatItHasNoRoomFor) {
  std::vector<LegendEntry> many;
  for (int i = 0; i < 14; ++i) {
    many.push_back({"class " + std::to_string(i), {1, 2, 3}, LegendEntry::Kind::kBar});
  }
  // As large as the map of a window of 1280 x 800 at interface scale 2, and smaller.
  for (const auto& [width, height] : {std::pair(560.0, 420.0), std::pair(400.0, 300.0)}) {
    RecordingCanvas canvas;
    const MapFrame frame{{0.0, 0.0, width, height}, {}, 2.0 * 96.0 / 72.0};
    LegendFit fit;
    const PageRect plate = draw_map_legend(canvas, frame, many, theme(ThemeName::kDark), fit);
    ASSERT_GT(plate.width, 0.0) << width;
    EXPECT_LE(plate.height, 0.45 * height);
    EXPECT_LE(plate.width, 0.75 * width);
    ASSERT_GE(canvas.texts.size(), 2U);
    EXPECT_EQ(canvas.texts[0].line, "class 0");
    const std::size_t left_out = many.size() + 1 - canvas.texts.size();
    EXPECT_EQ(canvas.texts.back().line, "and " + std::to_string(left_out) + " more");
  }
}

TEST(MapLegendPlate, IsNotThereWhereNotEvenOneEntryHasRoom) {
  const std::vector<LegendEntry> many(12, {"lane marking", {1, 2, 3}, LegendEntry::Kind::kBar});
  RecordingCanvas canvas;
  const MapFrame narrow{{0.0, 0.0, 90.0, 540.0}, {}, 96.0 / 72.0};
  LegendFit fit;
  EXPECT_EQ(draw_map_legend(canvas, narrow, many, theme(ThemeName::kDark), fit).width, 0.0);
  EXPECT_THAT(canvas.fills, IsEmpty());
}

TEST(MapLegendPlate, IsFittedAnewOnlyForOtherNamesOrAnotherMap) {
  std::vector<LegendEntry> entries = {{"truth", {1, 2, 3}}, {"estimate", {4, 5, 6}}};
  MapFrame frame{{0.0, 0.0, 800.0, 540.0}, {}, 96.0 / 72.0};
  LegendFit fit;
  const auto draw = [&] {
    RecordingCanvas canvas;
    return draw_map_legend(canvas, frame, entries, theme(ThemeName::kDark), fit).width;
  };
  const double width = draw() - 10.0 * frame.px_per_pt;
  const auto is_kept = [&] {
    fit.width = width + 7.0;  // what is kept is drawn as it is
    return draw() == fit.width + 10.0 * frame.px_per_pt && fit.width == width + 7.0;
  };
  EXPECT_TRUE(is_kept());
  entries[0].colour = {7, 8, 9};
  entries[1].kind = LegendEntry::Kind::kDashed;
  EXPECT_TRUE(is_kept()) << "no word is another";
  entries[0].name = "odometry";
  EXPECT_FALSE(is_kept());
  frame.where.width = 700.0;
  EXPECT_FALSE(is_kept());
  frame.where.height = 400.0;
  EXPECT_FALSE(is_kept());
  frame.px_per_pt = 2.0;
  EXPECT_FALSE(is_kept());
  entries.pop_back();
  EXPECT_FALSE(is_kept());
}

TEST(MapLegendPlate, MeasuresItsWordsOnceAndKnowsItsPlaceWithoutBeingDrawn) {
  const std::vector<LegendEntry> entries = {{"truth", {1, 2, 3}}, {"estimate", {4, 5, 6}}};
  const MapFrame frame{{0.0, 0.0, 800.0, 540.0}, {}, 96.0 / 72.0};
  LegendFit fit, undrawn;
  RecordingCanvas before, after;
  const PageRect plate = draw_map_legend(before, frame, entries, theme(ThemeName::kDark), fit);
  EXPECT_EQ(place_of_map_legend(frame, entries, undrawn), plate);
  ASSERT_EQ(fit.layout.places.size(), 2U);
  fit.layout.places[1].x() += 5.0;  // what is kept is drawn as it is
  draw_map_legend(after, frame, entries, theme(ThemeName::kDark), fit);
  ASSERT_EQ(after.texts.size(), 2U);
  EXPECT_EQ(after.texts[0].point, before.texts[0].point);
  EXPECT_EQ(after.texts[1].point.x(), before.texts[1].point.x() + 5.0);
}

TEST(MapLegendPlate, IsAsHighAsWhatIsDrawnOnIt) {
  std::vector<LegendEntry> entries;
  for (int i = 0; i < 9; ++i) {
    entries.push_back({"class " + std::to_string(i * i * i), {1, 2, 3}, LegendEntry::Kind::kBar});
    for (const double px : {0.9, 1.33, 2.1}) {
      RecordingCanvas canvas;
      LegendFit fit;
      const MapFrame frame{{0.0, 0.0, 640.0, 480.0}, {}, px};
      const PageRect plate = draw_map_legend(canvas, frame, entries, theme(ThemeName::kDark), fit);
      if (fit.count < entries.size()) continue;
      EXPECT_DOUBLE_EQ(plate.height,
                       legend_layout(fit.width + px, entries, px).height_px + 10.0 * px);
      EXPECT_EQ(canvas.texts.size(), entries.size()) << "nothing falls off it";
    }
  }
}

}  // namespace map_legend_test
}  // namespace nadir
