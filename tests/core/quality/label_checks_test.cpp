// SPDX-License-Identifier: Apache-2.0
#include "core/quality/label_checks.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <numbers>
#include <set>

#include "core/base/parallel.h"
#include "core/label/label_raster.h"
#include "core/quality/cell_codes.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace label_checks_test {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<Finding> findings_of(const LabelDocument& document,
                                 const CheckSettings& settings = {},
                                 const std::optional<PlaneBounds>& within = std::nullopt) {
  auto findings = check_labels(document, document.grid(), settings, within);
  EXPECT_TRUE(findings) << error_text(findings);
  return findings ? *findings : std::vector<Finding>{};
}

std::vector<Finding> of_kind(FindingKind kind, std::vector<Finding> findings) {
  std::erase_if(findings, [kind](const Finding& finding) { return finding.kind != kind; });
  return findings;
}

std::vector<std::string> sentences(const std::vector<Finding>& findings) {
  std::vector<std::string> all;
  for (const Finding& finding : findings) all.push_back(finding.sentence);
  return all;
}

/// Terrain over all of a grid of cells of a metre.
LabelObject ground(ObjectId id = 100) { return area(kTerrain, {box(0, 0, 40, 30)}, id); }

PlaneBounds bounds_of(double left, double top, double right, double bottom) {
  PlaneBounds bounds;
  bounds.include({left, -top});
  bounds.include({right, -bottom});
  return bounds;
}

TEST(CheckLabels, FindsNothingInLabelsWithoutFault) {
  const LabelDocument document = document_of(
      {ground(), area(kRoad, {box(0, 10, 40, 18)}, 2), line(kCurb, ring({{0, 10}, {40, 10}}), 1, 3),
       outline(kBuilding, {box(4, 20, 14, 28)}, 1, 4),
       line(kLaneMarking, ring({{2, 14}, {8, 14}}), 1.0, 5)});
  EXPECT_THAT(sentences(findings_of(document)), IsEmpty());
  EXPECT_THAT(findings_of(test_document()), IsEmpty());
}

TEST(CheckLabels, FindsUnlabelledGroundButNotTheInsideOfAContourOrWhatWasMadeUnclassified) {
  LabelDocument document = document_of({area(kTerrain, {box(0, 0, 40, 30), box(5, 5, 12, 9)}, 1),
                                        outline(kBuilding, {box(20, 5, 30, 15)}, 1, 2),
                                        area(kUnclassified, {box(2, 20, 8, 26)}, 3)});
  document.apply(painting(document, {30, 20, 36, 26}, kUnclassified));
  const auto findings = findings_of(document);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, FindingKind::kUnlabelled);
  EXPECT_EQ(findings[0].severity, FindingSeverity::kDoubt);
  EXPECT_EQ(findings[0].size, 28.0);
  EXPECT_EQ(findings[0].bounds.low, Eigen::Vector2d(5, -9));
  EXPECT_EQ(findings[0].bounds.high, Eigen::Vector2d(12, -5));
  EXPECT_EQ(findings[0].sentence, "unlabelled ground of 28 m2");
}

TEST(CheckLabels, UnlabelledGroundAtTheEdgeOfTheLabelsIsAHintAndBeyondThemNothing) {
  const auto findings = findings_of(
      document_of({area(kTerrain, {box(5, 5, 20, 10)}, 1), area(kTerrain, {box(5, 9, 10, 20)}, 2)}),
      {.overlap_m2 = 100.0});
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].severity, FindingSeverity::kHint);
  EXPECT_EQ(findings[0].size, 100.0);
  EXPECT_THAT(findings[0].sentence, HasSubstr("at the edge of what is labelled"));
}

TEST(CheckLabels, FindsIslandsOfWhatCoversGroundOnly) {
  const LabelDocument document =
      document_of({ground(), area(kRoad, {box(10, 10, 12, 11)}, 2),
                   area(kTrafficSign, {box(20, 10, 21, 11)}, 3),
                   area(kRoad, {box(20, 20, 30, 25)}, 4), area(kRoad, {box(0, 29, 1, 30)}, 5)});
  const auto findings = findings_of(document, {.island_m2 = 5.0});
  ASSERT_EQ(findings.size(), 1U) << "one at the edge of the image may go on beyond it";
  EXPECT_EQ(findings[0].kind, FindingKind::kIsland);
  EXPECT_EQ(findings[0].class_id, kRoad);
  EXPECT_EQ(findings[0].sentence, "road island of 2 m2 in terrain");
  EXPECT_THAT(findings[0].objects, ElementsAre(2));
  EXPECT_EQ(findings[0].place_in_enu_m, Eigen::Vector2d(11.5, -10.5));
}

TEST(CheckLabels, AnIslandOnUnlabelledGroundIsNotFixable) {
  const auto findings =
      of_kind(FindingKind::kIsland,
              findings_of(document_of({area(kTerrain, {box(0, 0, 40, 30), box(5, 5, 15, 15)}, 1),
                                       area(kRoad, {box(9, 9, 10, 10)}, 2)}),
                          {.island_m2 = 5.0}));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings[0].why_not_fix, HasSubstr("unlabelled"));
}

TEST(CheckLabels, FindsGapsAlongRowsColumnsAndAslant) {
  for (const double degrees : {0.0, 90.0, 30.0, 45.0, 118.0}) {
    const double yaw = degrees * std::numbers::pi / 180.0;
    const Eigen::Vector2d along(std::cos(yaw), std::sin(yaw));
    const Eigen::Vector2d across(-along.y(), along.x());
    const Eigen::Vector2d middle(20, -15);
    const auto strip = [&](double from, double to) {
      return Ring{middle - 10 * along + from * across, middle + 10 * along + from * across,
                  middle + 10 * along + to * across, middle - 10 * along + to * across};
    };
    LabelDocument document = test_document(400, 300, 0.1);
    document.apply(
        adding({area(kRoad, {strip(-3, -0.15)}, 1), area(kSidewalk, {strip(0.15, 3)}, 2)}));
    const auto gaps = of_kind(FindingKind::kGap, findings_of(document));
    ASSERT_EQ(gaps.size(), 1U) << degrees;
    EXPECT_NEAR(gaps[0].size, 0.3, 0.08) << degrees;
    EXPECT_FALSE(gaps[0].has_area);
    EXPECT_THAT(gaps[0].sentence, HasSubstr("road")) << degrees;
    EXPECT_THAT(gaps[0].sentence, HasSubstr("sidewalk")) << degrees;
    EXPECT_THAT(of_kind(FindingKind::kGap, findings_of(document, {.gap_width_m = 0.2})), IsEmpty())
        << degrees;
  }
}

TEST(CheckLabels, AGapIsNoUnlabelledAreaAndPartsThoseThatItJoins) {
  const LabelDocument document = document_of({area(
      kTerrain, {box(0, 0, 40, 30), box(5, 5, 12, 12), box(20, 5, 27, 12), box(12, 8, 20, 9)})});
  const auto findings = findings_of(document, {.gap_width_m = 1.0});
  EXPECT_EQ(of_kind(FindingKind::kGap, findings).size(), 1U);
  const auto ground = of_kind(FindingKind::kUnlabelled, findings);
  ASSERT_EQ(ground.size(), 2U);
  EXPECT_EQ(ground[0].size, 49.0);
  EXPECT_EQ(ground[1].size, 49.0);
}

TEST(CheckLabels, FindsOverlapsOfOneLevelOnly) {
  const LabelDocument document =
      document_of({ground(), area(kRoad, {box(2, 2, 12, 12)}, 1),
                   area(kRoad, {box(9, 8, 22, 12)}, 2), area(kSidewalk, {box(2, 2, 30, 25)}, 3)});
  const auto findings = findings_of(document);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].kind, FindingKind::kOverlap);
  EXPECT_THAT(findings[0].objects, ElementsAre(1, 2));
  EXPECT_EQ(findings[0].size, 12.0);
  EXPECT_EQ(findings[0].sentence, "road area 1 and road area 2 overlap by 12 m2");
  EXPECT_THAT(findings_of(document, {.overlap_m2 = 12.5}), IsEmpty());
  EXPECT_THAT(findings_of(document, {.overlap_width_m = 9.0}), IsEmpty());
}

TEST(CheckLabels, OverlapsOfRandomAreasAreThoseOfTheirCells) {
  for (std::uint32_t number = 0; number < 20; ++number) {
    const auto some = [&](std::uint32_t draw) {
      const auto drawn = uniforms({3, 0, number, 0, draw});
      return Eigen::Vector2d(2 + 36 * drawn[0], -2 - 26 * drawn[1]);
    };
    const LabelObject a = area(kRoad, {{some(0), some(1), some(2)}}, 1);
    const LabelObject b = area(kRoad, {{some(3), some(4), some(5)}}, 2);
    const Raster<ClassId> of_a = rasterise(document_of({a}));
    const Raster<ClassId> of_b = rasterise(document_of({b}));
    int common = 0;
    for (std::size_t i = 0; i < of_a.size(); ++i) {
      common += of_a.values()[i] == kRoad && of_b.values()[i] == kRoad ? 1 : 0;
    }
    const auto found =
        of_kind(FindingKind::kOverlap,
                findings_of(document_of({a, b}), {.overlap_m2 = 1.0, .overlap_width_m = 0.0}));
    EXPECT_EQ(found.size(), common > 0 ? 1U : 0U) << number;
    for (const Finding& one : found) EXPECT_EQ(one.size, common) << number;
  }
}

TEST(CheckLabels, FindsLinesWhoseEndsNearlyMeet) {
  const LabelDocument document =
      document_of({line(kFence, ring({{2, 2}, {12, 2}, {12, 12}, {2.3, 2.4}}), 0.2, 1),
                   line(kCurb, ring({{20, 2}, {25, 2}}), 0.2, 2),
                   line(kCurb, ring({{25.3, 2.1}, {30, 8}}), 0.2, 3),
                   line(kFence, ring({{20, 20}, {30, 20}, {30, 25}, {20, 20}}), 0.2, 4)});
  const auto findings = of_kind(FindingKind::kOpenOutline, findings_of(document));
  EXPECT_THAT(sentences(findings), ElementsAre("ends of curb lines 2 and 3 are 0.32 m apart",
                                               "fence line 1 is open by 0.5 m"));
  EXPECT_THAT(findings_of(document, {.unlabelled_m2 = 1e6, .end_gap_m = 0.2, .curb_length_m = 1e4}),
              IsEmpty());
}

TEST(CheckLabels, LinesThatEndBesideEachOtherAndJunctionsAreNotOpen) {
  const LabelDocument document =
      document_of({line(kLaneMarking, ring({{2, 2}, {12, 2}}), 0.1, 1),
                   line(kLaneMarking, ring({{2, 2.3}, {12, 2.3}}), 0.1, 2),
                   line(kFence, ring({{2, 10}, {12, 10}}), 0.1, 3),
                   line(kFence, ring({{12, 10}, {12, 20}}), 0.1, 4),
                   line(kFence, ring({{12, 10}, {20, 5}}), 0.1, 5)});
  EXPECT_THAT(of_kind(FindingKind::kOpenOutline, findings_of(document)), IsEmpty());
}

TEST(CheckLabels, ABuildingWithoutAWallIsOpenAndSaysWhyItCannotBeFixed) {
  const LabelDocument document =
      document_of({line(kBuilding, ring({{2, 2}, {12, 2}, {12, 12}, {2, 12}}), 0.3, 1),
                   line(kFence, ring({{20, 2}, {32, 2}, {32, 12}, {20, 12}}), 0.3, 2)});
  const auto findings = of_kind(FindingKind::kOpenOutline, findings_of(document));
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].sentence, "building line 1 is open by 10 m");
  EXPECT_THAT(findings[0].why_not_fix, HasSubstr("image"));
}

TEST(CheckLabels, FindsCurbsFarFromRoadsAndInTheMiddleOfOne) {
  LabelDocument document = test_document(400, 300, 0.1);
  document.apply(adding({ground(), area(kRoad, {box(0, 10, 40, 20)}, 1),
                         line(kCurb, ring({{0, 10}, {40, 10}}), 0.2, 2),
                         line(kCurb, ring({{5, 15}, {25, 15}}), 0.2, 3),
                         line(kCurb, ring({{10, 20}, {10, 28}}), 0.2, 4),
                         line(kCurb, ring({{20, 25}, {21, 25}}), 0.2, 5)}));
  const auto findings = of_kind(FindingKind::kStrayCurb, findings_of(document));
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_THAT(findings[0].objects, ElementsAre(3));
  EXPECT_NEAR(findings[0].size, 20.0, 1.0);
  EXPECT_THAT(findings[1].objects, ElementsAre(4));
  EXPECT_NEAR(findings[1].size, 7.0, 0.6) << "its first metre is at the road";
  EXPECT_EQ(findings[1].sentence, "about 7 m of curb follow no road");
}

TEST(CheckLabels, FindsObjectsThatCrossThemselvesOrAreNothing) {
  const LabelDocument document =
      document_of({ground(), area(kRoad, {ring({{2, 2}, {10, 10}, {10, 2}, {2, 10}})}, 1),
                   area(kSidewalk, {ring({{20, 2}, {30, 2}, {25, 2}})}, 2),
                   line(kCurb, ring({{20, 20}, {20.001, 20}}), 0.1, 3),
                   line(kFence, ring({{2, 20}, {10, 28}, {10, 20}, {2, 28}}), 1.0, 4)});
  auto findings = findings_of(document, {.island_m2 = 0.0});
  EXPECT_THAT(sentences(findings),
              ElementsAre("sidewalk area 2 covers 0 m2", "road area 1 crosses itself",
                          "curb line 3 is 0.001 m long"));
  EXPECT_NEAR(
      (of_kind(FindingKind::kSelfCrossing, findings)[0].place_in_enu_m - Eigen::Vector2d(6, -6))
          .norm(),
      0.0, 1e-6);
}

TEST(CheckLabels, FindsTheSameObjectTwiceWhereverItBegins) {
  LabelObject second = area(kRoad, {ring({{12, 12}, {2, 12}, {2, 2}, {12, 2}})}, 7);
  LabelObject third = area(kRoad, {box(2.004, 2, 12, 12)}, 8);
  LabelObject other = area(kRoad, {box(2, 2, 12, 11.9)}, 9);
  const auto findings =
      of_kind(FindingKind::kDuplicate,
              findings_of(document_of({area(kRoad, {box(2, 2, 12, 12)}, 1), second, third, other,
                                       line(kCurb, ring({{20, 2}, {30, 2}}), 0.1, 10),
                                       line(kCurb, ring({{30, 2}, {20, 2}}), 0.1, 11)})));
  EXPECT_THAT(sentences(findings),
              ElementsAre("road area 1 and 7 are the same", "road area 1 and 8 are the same",
                          "curb line 10 and 11 are the same"));
}

TEST(CheckLabels, FindsObjectsFarOutsideOfTheImage) {
  const auto findings =
      of_kind(FindingKind::kFarOutside,
              findings_of(document_of({ground(), area(kRoad, {box(10, 10, 100, 20)}, 1),
                                       area(kRoad, {box(-340, 10, -330, 20)}, 2),
                                       area(kRoad, {box(35, 25, 59, 29)}, 3)})));
  EXPECT_THAT(sentences(findings), ElementsAre("road area 2 lies up to 340 m outside of the image",
                                               "road area 1 reaches 60 m out of the image"));
}

TEST(CheckLabels, PutsTheMostSevereFirstAndThenGoesFromNorthToSouth) {
  LabelDocument document = document_of({ground()});
  for (std::uint32_t step = 0; step < 60; ++step) document.apply(random_edit(document, 5, step));
  const auto findings = findings_of(document, {.island_m2 = 3.0, .gap_width_m = 1.0});
  ASSERT_GT(findings.size(), 5U);
  for (std::size_t i = 1; i < findings.size(); ++i) {
    const Finding& before = findings[i - 1];
    ASSERT_LE(before.severity, findings[i].severity);
    if (before.severity != findings[i].severity) continue;
    ASSERT_GE(before.place_in_enu_m.y(), findings[i].place_in_enu_m.y());
  }
}

/// Regions by going from cell to cell over codes that are made cell by cell from what the header says.
class SlowCheck {
 public:
  SlowCheck(const LabelDocument& document, double gap_cells)
      : document_(document), labels_(rasterise(document)) {
    const CellRect whole = document.grid().whole();
    CellRect extent;
    std::vector<LabelObject> objects;
    for (const auto& [id, placed] : document.objects()) {
      LabelObject object = *placed.object;
      if (object.class_id != kUnclassified) {
        const CellRect cells{static_cast<std::int64_t>(std::floor(placed.bounds.low.x())),
                             static_cast<std::int64_t>(std::floor(-placed.bounds.high.y())),
                             static_cast<std::int64_t>(std::ceil(placed.bounds.high.x())),
                             static_cast<std::int64_t>(std::ceil(-placed.bounds.low.y()))};
        extent = extent.joined(cells.cut_to(whole));
      }
      if (object.class_id != kUnclassified && object.kind != ObjectKind::kOutline) continue;
      object.class_id = kRoad;
      if (object.kind == ObjectKind::kOutline) object.width_m = 0.0;
      if (object.kind == ObjectKind::kOutline) object.kind = ObjectKind::kArea;
      objects.push_back(object);
    }
    LabelDocument left_out(document.plane(), document.grid());
    left_out.apply(adding(objects));
    const Raster<ClassId> hidden = rasterise(left_out);
    for (int y = 0; y < labels_.height(); ++y) {
      for (int x = 0; x < labels_.width(); ++x) {
        const PaintValue paint = document.paint_at(x, y);
        const bool has_class = paint != kNoPaint && paint != kUnclassified;
        if (has_class) extent = extent.joined({x, y, x + 1, y + 1});
      }
    }
    codes_ = labels_;
    for (int y = 0; y < labels_.height(); ++y) {
      for (int x = 0; x < labels_.width(); ++x) {
        if (labels_.at(x, y) != kUnclassified) continue;
        const bool is_in =
            x >= extent.left && x < extent.right && y >= extent.top && y < extent.bottom;
        const bool is_left_out =
            hidden.at(x, y) != kUnclassified || document.paint_at(x, y) == kUnclassified;
        codes_.at(x, y) = !is_in ? kBeyondLabels : is_left_out ? kLeftOut : kOpenGround;
      }
    }
    Raster<std::uint8_t> narrow = codes_;
    for (int y = 0; y < labels_.height(); ++y) {
      for (int x = 0; x < labels_.width(); ++x) {
        if (codes_.at(x, y) == kOpenGround && is_narrow(x, y, gap_cells))
          narrow.at(x, y) = kNarrowGround;
      }
    }
    codes_ = narrow;
  }

  [[nodiscard]] const Raster<std::uint8_t>& codes() const { return codes_; }

 private:
  /// Steps to the next label in a direction; nothing where there is none.
  [[nodiscard]] std::optional<int> steps(int x, int y, int across, int down) const {
    for (int n = 1;; ++n) {
      const int column = x + n * across;
      const int row = y + n * down;
      if (!codes_.contains(column, row)) return std::nullopt;
      if (codes_.at(column, row) < kClassCount) return n;
      if (codes_.at(column, row) != kOpenGround) return std::nullopt;
    }
  }
  [[nodiscard]] bool is_narrow(int x, int y, double most) const {
    for (const auto& [across, down, length] : {std::tuple{1, 0, 1.0},
                                               {0, 1, 1.0},
                                               {1, 1, std::numbers::sqrt2},
                                               {-1, 1, std::numbers::sqrt2}}) {
      const auto ahead = steps(x, y, across, down);
      const auto behind = steps(x, y, -across, -down);
      if (ahead && behind && (*ahead + *behind - 1) * length <= most + 1e-6) return true;
    }
    return false;
  }

  const LabelDocument& document_;
  Raster<ClassId> labels_;
  Raster<std::uint8_t> codes_;
};

LabelDocument random_document(std::uint64_t seed, int steps) {
  LabelDocument document = test_document(60, 50);
  for (int step = 0; step < steps; ++step) {
    document.apply(random_edit(document, seed, static_cast<std::uint32_t>(step)));
  }
  return document;
}

TEST(CellCoder, CodesRandomDocumentsAsTheWordsOfItsHeaderDo) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const LabelDocument document = random_document(seed, 25);
    const CheckSettings settings{.gap_width_m = 3.0};
    const CellCoder coder(document, document.grid(), settings);
    Raster<CellCode> codes = coder.codes(document.grid().whole());
    for (CellCode& code : codes.values()) code = code == kCurbAstray ? CellCode{kCurb} : code;
    EXPECT_TRUE(codes == SlowCheck(document, 3.0).codes()) << seed;
  }
}

TEST(CellCoder, AnyWindowIsThatPartOfTheWhole) {
  const LabelDocument document = random_document(3, 30);
  const CellCoder coder(document, document.grid(), {.gap_width_m = 4.0, .curb_reach_m = 3.0});
  const Raster<CellCode> whole = coder.codes(document.grid().whole());
  for (const CellRect& window :
       {CellRect{0, 0, 9, 50}, CellRect{20, 17, 41, 33}, CellRect{59, 49, 60, 50}}) {
    const Raster<CellCode> part = coder.codes(window);
    for (std::int64_t y = window.top; y < window.bottom; ++y) {
      for (std::int64_t x = window.left; x < window.right; ++x) {
        ASSERT_EQ(part.at(static_cast<int>(x - window.left), static_cast<int>(y - window.top)),
                  whole.at(static_cast<int>(x), static_cast<int>(y)));
      }
    }
  }
}

TEST(CellCoder, CurbIsAstrayWhereRoadOrAnythingElseIsBeyondReach) {
  LabelDocument document = random_document(9, 30);
  document.apply(adding({line(kCurb, ring({{5, 5}, {50, 40}}), 2.0, document.next_id())}));
  const double reach = 3.0;
  const CellCoder coder(document, document.grid(), {.gap_width_m = 0.0, .curb_reach_m = reach});
  const Raster<CellCode> codes = coder.codes(document.grid().whole());
  const auto is_near = [&](int x, int y, bool wants_road) {
    for (int row = 0; row < codes.height(); ++row) {
      for (int column = 0; column < codes.width(); ++column) {
        const ClassId id = class_of_code(codes.at(column, row));
        const bool is_road = id == kRoad || id == kLaneMarking;
        if (id == kCurb || is_road != wants_road) continue;
        if (std::hypot(column - x, row - y) <= reach) return true;
      }
    }
    return false;
  };
  for (int y = 3; y < codes.height() - 3; ++y) {
    for (int x = 3; x < codes.width() - 3; ++x) {
      if (class_of_code(codes.at(x, y)) != kCurb) continue;
      const bool follows = is_near(x, y, true) && is_near(x, y, false);
      ASSERT_EQ(codes.at(x, y) == kCurbAstray, !follows) << x << ", " << y;
    }
  }
}

TEST(CheckLabels, APartIsFoundAsACheckOfEverythingFindsIt) {
  LabelDocument document = test_document(700, 600);
  for (int i = 0; i < 40; ++i) {
    for (std::uint32_t step = 0; step < 6; ++step) {
      LabelEdit edit = random_edit(document, static_cast<std::uint64_t>(i + 1), step);
      document.apply(edit);
    }
  }
  const CheckSettings settings{.unlabelled_m2 = 3.0, .island_m2 = 8.0, .gap_width_m = 3.0};
  const auto everything = findings_of(document, settings);
  ASSERT_GT(everything.size(), 50U);
  const auto is_in = [](const std::vector<Finding>& findings, const Finding& one) {
    return std::find(findings.begin(), findings.end(), one) != findings.end();
  };
  const auto meets = [](const PlaneBounds& a, const PlaneBounds& b) {
    return (a.low.array() <= b.high.array()).all() && (b.low.array() <= a.high.array()).all();
  };
  const auto holds = [](const PlaneBounds& box, const Eigen::Vector2d& place) {
    return (place.array() >= box.low.array()).all() && (place.array() <= box.high.array()).all();
  };
  for (const PlaneBounds& within : {bounds_of(100, 100, 180, 190), bounds_of(500, 10, 501, 11),
                                    bounds_of(-50, -50, 60, 700), bounds_of(640, 400, 720, 640)}) {
    const auto part = findings_of(document, settings, within);
    for (const Finding& finding : part) {
      EXPECT_TRUE(is_in(everything, finding)) << finding.sentence;
      EXPECT_TRUE(meets(finding.bounds, within)) << finding.sentence;
    }
    for (const Finding& finding : everything) {
      if (!holds(within, finding.place_in_enu_m)) continue;
      EXPECT_TRUE(is_in(part, finding)) << finding.sentence;
    }
  }
  EXPECT_THAT(findings_of(document, settings, PlaneBounds{}), IsEmpty());
}

TEST(CheckLabels, FindsTheSameOnOneAndFourThreads) {
  const LabelDocument document = random_document(11, 40);
  const auto now = findings_of(document);
  for (const int threads : {1, 4}) {
    const ThreadLimit limit(threads);
    EXPECT_EQ(findings_of(document), now);
  }
}

TEST(CheckLabels, StopsWhenTold) {
  std::stop_source stop;
  stop.request_stop();
  const auto findings = check_labels(document_of({ground()}), test_grid(40, 30), {}, std::nullopt,
                                     {stop.get_token(), {}});
  ASSERT_FALSE(findings);
  EXPECT_EQ(findings.error().code, ErrorCode::kCancelled);
}

TEST(CheckLabels, RefusesASettingOutOfItsRange) {
  const auto findings =
      check_labels(document_of({ground()}), test_grid(40, 30), {.gap_width_m = -1.0});
  ASSERT_FALSE(findings);
  EXPECT_EQ(findings.error().message, "--gap-width: -1 is not in [0, 10]");
}

TEST(CheckLabels, TellsHowFarItIs) {
  std::vector<double> told;
  const auto findings =
      check_labels(random_document(2, 10), test_grid(60, 50), {}, std::nullopt,
                   {{}, [&](double fraction, const std::string&) { told.push_back(fraction); }});
  ASSERT_TRUE(findings);
  ASSERT_GE(told.size(), 2U);
  EXPECT_TRUE(std::is_sorted(told.begin(), told.end()));
  EXPECT_GE(told.front(), 0.0);
  EXPECT_LE(told.back(), 1.0);
}

}  // namespace label_checks_test
}  // namespace nadir
