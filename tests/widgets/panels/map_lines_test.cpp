// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/map_lines.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/widgets/panels/made_moment.h"
#include "tests/widgets/views/drawn_chart.h"

namespace nadir {
namespace map_lines_test {

using ::testing::Contains;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::SizeIs;

/// The made moment, 40 m across 800 pixels, in the dark theme on a picture.
class MapLinesTest : public ::testing::Test {
 protected:
  static constexpr double kMetresPerPx = 0.05;

  [[nodiscard]] RecordingCanvas drawn(Layer layer) {
    RecordingCanvas canvas;
    draw_map_layer(drawing(canvas), layer);
    return canvas;
  }
  [[nodiscard]] RecordingCanvas drawn_poses() {
    RecordingCanvas canvas;
    draw_map_poses(drawing(canvas));
    return canvas;
  }
  [[nodiscard]] MapDrawing drawing(Canvas& canvas) {
    return {canvas, frame, model, shown, paths, dark};
  }
  void add_run(int number, std::size_t colour) {
    MapRun other = model.runs.back();
    other.number = number;
    other.colour = colour;
    other.is_active = false;
    model.runs.insert(model.runs.begin(), other);
    shown.push_back(number);
  }
  /// A document like the made one whose steps are changed.
  void change_steps(const std::function<void(RunStep& step)>& change) {
    RunDocument made_anew = *made.document;
    for (RunStep& step : made_anew.steps) change(step);
    model.runs.back().document = RunDocument::from_steps(std::move(made_anew));
  }
  static double width_of(const std::vector<Eigen::Vector2d>& points) {
    const auto [least, most] = std::minmax_element(
        points.begin(), points.end(), [](const auto& a, const auto& b) { return a.x() < b.x(); });
    return most->x() - least->x();
  }

  MadeMoment made;
  MapViewModel model = made.map_view();
  std::vector<int> shown = {1};
  RunPathsCache paths;
  const Theme& dark = theme(ThemeName::kDark);
  MapFrame frame{{0.0, 0.0, 800.0, 600.0}, {model.look.centre_in_enu_m, kMetresPerPx}, 1.0};
};

TEST_F(MapLinesTest, ATrailIsFullUpToNowAndFaintAhead) {
  const RecordingCanvas canvas = drawn(Layer::kTruth);
  const auto full = canvas.strokes_in(dark.truth_on_imagery);
  ASSERT_THAT(full, SizeIs(1));
  EXPECT_LT((full[0].points.front() - frame.page({20.0, 25.0})).norm(), 1e-6);
  EXPECT_LT((full[0].points.back() - frame.page({24.0, 25.0})).norm(), 1e-6) << "step 8";
  const auto faint = canvas.strokes_in(with_opacity(dark.truth_on_imagery, 0.5));
  ASSERT_THAT(faint, SizeIs(1));
  EXPECT_LT((faint[0].points.back() - frame.page({29.5, 25.0})).norm(), 1e-6) << "step 19";
  EXPECT_LT(faint[0].style.width_px, full[0].style.width_px);
}

TEST_F(MapLinesTest, BelowEachLineLiesAWiderCasing) {
  for (const Layer layer : {Layer::kTruth, Layer::kOdometry, Layer::kEstimate, Layer::kEllipses}) {
    const RecordingCanvas canvas = drawn(layer);
    ASSERT_THAT(canvas.strokes, Not(IsEmpty()));
    ASSERT_EQ(canvas.strokes.size() % 2, 0U);
    for (std::size_t i = 0; i < canvas.strokes.size(); i += 2) {
      const StrokeStyle& casing = canvas.strokes[i].style;
      const StrokeStyle& line = canvas.strokes[i + 1].style;
      EXPECT_EQ(canvas.strokes[i].points, canvas.strokes[i + 1].points) << enum_name(layer);
      EXPECT_GE(casing.width_px, line.width_px + 0.8) << enum_name(layer);
      const Rgba& dark_casing = dark.casing_on_imagery;
      EXPECT_EQ(casing.colour,
                (Rgba{dark_casing.red, dark_casing.green, dark_casing.blue, casing.colour.alpha}));
      EXPECT_GE(int{casing.colour.alpha}, 90) << "strong enough to be seen";
    }
  }
}

TEST_F(MapLinesTest, OverThePlainWindowTheCasingIsTheWindows) {
  model.map.reset();
  const RecordingCanvas canvas = drawn(Layer::kEstimate);
  EXPECT_EQ(canvas.strokes.back().style.colour, dark.estimate);
  EXPECT_THAT(canvas.strokes_in(with_opacity(dark.window, 0.8)), SizeIs(1));
}

TEST_F(MapLinesTest, TruthIsDrawnOnceAndEveryEstimateInItsColour) {
  const std::size_t alone = drawn(Layer::kTruth).strokes.size();
  add_run(2, 1);
  EXPECT_EQ(drawn(Layer::kTruth).strokes.size(), alone);
  const RecordingCanvas canvas = drawn(Layer::kEstimate);
  EXPECT_THAT(canvas.strokes_in(dark.estimate_on_imagery), SizeIs(1));
  EXPECT_THAT(canvas.strokes_in(dark.second_run), SizeIs(1));
  EXPECT_EQ(canvas.strokes.back().style.colour, dark.estimate_on_imagery)
      << "the active one lies on top";
  shown = {2};
  EXPECT_THAT(drawn(Layer::kEstimate).strokes_in(dark.estimate_on_imagery), IsEmpty());
}

TEST_F(MapLinesTest, OdometryIsDashedAndWhatIsNotKnownLeavesAGap) {
  EXPECT_FALSE(
      drawn(Layer::kOdometry).strokes_in(dark.odometry_on_imagery)[0].style.dashes_px.empty());
  change_steps([](RunStep& step) {
    if (step.step == 4) step.truth_in_enu.reset();
  });
  EXPECT_THAT(drawn(Layer::kTruth).strokes_in(dark.truth_on_imagery), SizeIs(2));
}

TEST_F(MapLinesTest, EllipsesOfTheActiveRunAreThreeOfOthersTwo) {
  const auto rings = [&](const RecordingCanvas& canvas) {
    std::vector<double> widths;
    for (std::size_t i = 1; i < canvas.strokes.size(); i += 2) {
      widths.push_back(width_of(canvas.strokes[i].points) * kMetresPerPx);
    }
    return widths;
  };
  // Half a metre of standard deviation, so a metre of width a sigma.
  const auto of_active = rings(drawn(Layer::kEllipses));
  ASSERT_THAT(of_active, SizeIs(3));
  EXPECT_NEAR(of_active[0], 3.0, 0.02);
  EXPECT_NEAR(of_active[1], 2.0, 0.02);
  EXPECT_NEAR(of_active[2], 1.0, 0.02);
  add_run(2, 1);
  EXPECT_THAT(rings(drawn(Layer::kEllipses)), SizeIs(5));
}

TEST_F(MapLinesTest, EllipsesFadeWithTheirLayerAllOfThem) {
  const auto alphas = [&] {
    std::vector<int> all;
    const RecordingCanvas canvas = drawn(Layer::kEllipses);
    for (const auto& stroke : canvas.strokes) all.push_back(stroke.style.colour.alpha);
    for (const auto& fill : canvas.fills) all.push_back(fill.colour.alpha);
    return all;
  };
  const std::vector<int> full = alphas();
  model.look.layer(Layer::kEllipses).opacity = 0.5;
  const std::vector<int> half = alphas();
  ASSERT_EQ(half.size(), full.size());
  for (std::size_t i = 0; i < full.size(); ++i) EXPECT_NEAR(half[i], full[i] / 2.0, 1.5);
}

TEST_F(MapLinesTest, ModesShowWhereThereAreSeveral) {
  EXPECT_THAT(drawn(Layer::kModes).fills, IsEmpty()) << "one is where the estimate is";
  change_steps([](RunStep& step) {
    PoseMode mode;
    mode.moments.mean = {22.0, 27.0, 0.0};
    mode.mass = 0.62;
    PoseMode other = mode;
    other.moments.mean = {30.0, 33.0, 0.0};
    other.mass = 0.38;
    step.estimate.modes = {mode, other};
  });
  const RecordingCanvas canvas = drawn(Layer::kModes);
  std::vector<std::string> words;
  for (const auto& text : canvas.texts) words.push_back(text.line);
  EXPECT_THAT(words, ::testing::UnorderedElementsAre("62 %", "38 %"));
}

TEST_F(MapLinesTest, ArrowsAreThoseOfTheLayersThatShow) {
  const std::size_t all = drawn_poses().fills.size();
  EXPECT_EQ(all, 3U);
  model.look.layer(Layer::kOdometry).is_visible = false;
  const RecordingCanvas canvas = drawn_poses();
  EXPECT_EQ(canvas.fills.size(), 2U);
  EXPECT_EQ(canvas.fills.back().colour, dark.estimate_on_imagery);
  EXPECT_THAT(canvas.fills_in(dark.odometry_on_imagery), IsEmpty());
}

TEST_F(MapLinesTest, ABookmarkIsADiamondOnItsPlace) {
  model.runs[0].bookmarks_in_enu_m = {{22.0, 28.0}, Eigen::Vector2d::Constant(std::nan(""))};
  model.runs[0].bookmark_notes = {"here", "nowhere"};
  const auto diamonds = drawn_poses().fills_in(dark.accent);
  ASSERT_THAT(diamonds, SizeIs(1));
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : diamonds[0].outline) middle += corner / 4.0;
  EXPECT_LT((middle - frame.page({22.0, 28.0})).norm(), 1e-6);
}

TEST_F(MapLinesTest, TheGridIsCasedOnAPictureAndQuietOnThePlainWindow) {
  const RecordingCanvas on_picture = drawn(Layer::kGraticule);
  RecordingCanvas plain;
  model.map.reset();
  draw_map_grid(drawing(plain), true);
  EXPECT_EQ(on_picture.strokes.size(), 2 * plain.strokes.size());
  EXPECT_THAT(plain.strokes_in(dark.line), SizeIs(plain.strokes.size()));
  std::vector<std::string> words;
  for (const auto& text : plain.texts) {
    words.push_back(text.line);
    EXPECT_EQ(text.style.colour, dark.muted);
  }
  EXPECT_THAT(words, Contains("E 20"));
  EXPECT_THAT(words, Contains("N 30"));
  // Numbers keep off each other and inside the map.
  for (std::size_t i = 0; i < plain.texts.size(); ++i) {
    const Eigen::AlignedBox2d box = plain.texts[i].box();
    EXPECT_GE(box.min().x(), 0.0);
    EXPECT_LE(box.max().y(), 600.0);
    for (std::size_t k = 0; k < i; ++k) {
      EXPECT_TRUE(box.intersection(plain.texts[k].box()).isEmpty());
    }
  }
}

TEST_F(MapLinesTest, LayersOfTheGroundHaveNoLines) {
  for (const Layer layer : {Layer::kPicture, Layer::kParticles, Layer::kTopview, Layer::kLegend}) {
    const RecordingCanvas canvas = drawn(layer);
    EXPECT_THAT(canvas.strokes, IsEmpty()) << enum_name(layer);
    EXPECT_THAT(canvas.fills, IsEmpty()) << enum_name(layer);
  }
}

TEST_F(MapLinesTest, AMeasuredLineNamesItsLegsAndFillsWhatItEncloses) {
  RecordingCanvas canvas;
  const std::vector<Eigen::Vector2d> two = {{20.0, 25.0}, {28.0, 25.0}};
  draw_measured(canvas, frame, two, Eigen::Vector2d(28.0, 31.0), dark);
  ASSERT_THAT(canvas.texts, SizeIs(1)) << "what is still open is said at the mouse";
  EXPECT_EQ(canvas.texts[0].line, "8.00 m");
  EXPECT_TRUE(std::any_of(canvas.strokes.begin(), canvas.strokes.end(), [](const auto& stroke) {
    return !stroke.style.dashes_px.empty();
  })) << "and is dashed";
  EXPECT_THAT(canvas.fills_in(with_opacity(dark.accent, 0.15)), IsEmpty());
  RecordingCanvas closed;
  draw_measured(closed, frame, {{20.0, 25.0}, {28.0, 25.0}, {28.0, 31.0}}, std::nullopt, dark);
  EXPECT_THAT(closed.fills_in(with_opacity(dark.accent, 0.15)), SizeIs(1));
  EXPECT_THAT(closed.texts, SizeIs(2));
  RecordingCanvas none;
  draw_measured(none, frame, {}, Eigen::Vector2d(0.0, 0.0), dark);
  EXPECT_THAT(none.strokes, IsEmpty());
}

TEST_F(MapLinesTest, ARingIsStrongerAroundWhatIsPickedThanAroundWhatWouldBe) {
  const Rigid2 pose{22.0, 28.0, 0.3};
  RecordingCanvas picked, near, nowhere;
  draw_particle_ring(picked, frame, pose, true, dark);
  draw_particle_ring(near, frame, pose, false, dark);
  draw_particle_ring(nowhere, frame, {std::nan(""), 28.0, 0.0}, true, dark);
  const auto ring_of = [&](const RecordingCanvas& canvas) {
    return canvas.strokes_in(dark.accent).at(0);
  };
  EXPECT_GT(ring_of(picked).style.width_px, ring_of(near).style.width_px);
  Eigen::AlignedBox2d box;
  for (const Eigen::Vector2d& point : ring_of(picked).points) box.extend(point);
  EXPECT_LT((box.center() - frame.page({22.0, 28.0})).norm(), 1e-6);
  EXPECT_THAT(picked.fills, SizeIs(2)) << "its inside, and its heading";
  EXPECT_THAT(near.fills, IsEmpty());
  EXPECT_THAT(nowhere.strokes, IsEmpty());
}

TEST_F(MapLinesTest, AColourOfTheUsersOwnFadesLikeTheThemes) {
  model.look.layer(Layer::kTruth).colour = "#102030";
  model.look.layer(Layer::kTruth).opacity = 0.4;
  const PathLook look = run_path_look(model, model.runs[0], PoseSource::kTruth, dark);
  EXPECT_EQ(look.colour, (Rgba{0x10, 0x20, 0x30, 102}));
  EXPECT_EQ(look.casing.alpha, 102);
  model.look.layer(Layer::kTruth).colour = "no colour";
  EXPECT_EQ(run_path_look(model, model.runs[0], PoseSource::kTruth, dark).colour,
            with_opacity(dark.truth_on_imagery, 0.4));
}

TEST_F(MapLinesTest, AFaintPictureIsNoGroundForLines) {
  EXPECT_TRUE(has_ground_picture(model));
  model.look.layer(Layer::kPicture).opacity = 0.2;
  EXPECT_FALSE(has_ground_picture(model));
  model.look.layer(Layer::kLabels).is_visible = true;
  EXPECT_TRUE(has_ground_picture(model));
  model.map.reset();
  EXPECT_FALSE(has_ground_picture(model));
}

}  // namespace map_lines_test
}  // namespace nadir
