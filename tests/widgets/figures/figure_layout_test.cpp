// SPDX-License-Identifier: Apache-2.0
// Every figure on pages of every size: what is drawn can be read.
#include <gmock/gmock.h>

#include "tests/support/recorded_page.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/figures/recorded_flight.h"
#include "widgets/figures/figures.h"

namespace nadir {
namespace figure_layout_test {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class FigureLayout : public ::testing::Test {
 protected:
  FigureLayout() {
    write_street(scratch_.path() / "map");
    write_drive(scratch_.path() / "a-rather-long-name-of-a-run.nadir", scratch_.path() / "map", 20);
    write_drive(scratch_.path() / "b.nadir", scratch_.path() / "map", 12, {.shift_m = 3.0});
    route_ = scratch_.file("route.toml",
                           "name = \"street\"\n[[waypoint]]\neast_m = 10\nnorth_m = 20\n"
                           "[[waypoint]]\neast_m = 11\nnorth_m = 20\n"
                           "[[waypoint]]\neast_m = 50\nnorth_m = 20\n");
  }

  FigureRecipe recipe(const FigureKind& kind) {
    FigureRecipe made;
    made.figure = kind.name;
    made.map = (scratch_.path() / "map").string();
    if (kind.name == "route") made.route = route_.string();
    for (const char* name : {"a-rather-long-name-of-a-run.nadir", "b.nadir"}) {
      if (made.runs.size() < kind.most_runs && kind.fewest_runs > 0) {
        made.runs.push_back((scratch_.path() / name).string());
      }
    }
    return made;
  }

  /// Draws all figures at some sizes and gathers what is wrong.
  std::vector<std::string> faults(const std::vector<PageSize>& sizes, double dpi = 0.0) {
    std::vector<std::string> found;
    for (const FigureKind& kind : figure_kinds()) {
      FigureRecipe asked = recipe(kind);
      asked.options.dpi = dpi;
      auto figure = make_figure(asked);
      if (!figure) {
        found.push_back(std::string(kind.name) + ": " + figure.error().message);
        continue;
      }
      for (const PageSize& size : sizes) {
        asked.options.size = size;
        context_.set_format(page_format(asked.options, kind.aspect));
        context_.supersampling = 1;
        RecordedPage canvas;
        const auto drawn = (*figure)->draw(canvas, context_);
        const std::string where = fmt::format("{} at {}: ", kind.name, size.text());
        if (!drawn) found.push_back(where + drawn.error().message);
        if (canvas.open_clips() != 0) found.push_back(where + "a clip stays open");
        const PageFormat& format = context_.format();
        for (const std::string& fault :
             unreadable_texts(canvas, format.width, format.height, 6.9 * format.px_per_pt())) {
          found.push_back(where + fault);
        }
      }
    }
    return found;
  }

  ScratchFolder scratch_;
  std::filesystem::path route_;
  FigureContext context_{PageFormat{}};
};

TEST_F(FigureLayout, KeepsTextReadableInTheFiguresOwnShape) {
  EXPECT_THAT(faults({{200, 0}, {260, 0}, {320, 0}, {420, 0}, {600, 0}, {1600, 0}}), IsEmpty());
}

TEST_F(FigureLayout, KeepsTextReadableOnLowAndHighPages) {
  EXPECT_THAT(faults({{200, 100},
                      {200, 150},
                      {200, 600},
                      {320, 150},
                      {420, 150},
                      {600, 150},
                      {1600, 150},
                      {1600, 300},
                      {600, 1600}}),
              IsEmpty());
}

TEST_F(FigureLayout, KeepsTextReadableWhateverThePixelsAnInch) {
  EXPECT_THAT(faults({{600, 400}, {1280, 720}}, 72.0), IsEmpty());
  EXPECT_THAT(faults({{600, 400}, {1280, 720}}, 300.0), IsEmpty());
}

TEST_F(FigureLayout, DrawsOnPagesTooSmallForAnything) {
  for (const FigureKind& kind : figure_kinds()) {
    auto figure = make_figure(recipe(kind));
    ASSERT_TRUE(figure.has_value()) << figure.error().message;
    for (const auto& [width, height] : {std::pair(1, 1), {30, 20}, {90, 400}, {400, 30}}) {
      PageFormat format;
      format.width = width;
      format.height = height;
      format.dpi = 96.0;
      context_.set_format(format);
      RecordedPage canvas;
      const auto drawn = (*figure)->draw(canvas, context_);
      EXPECT_TRUE(drawn.has_value()) << kind.name << ": " << drawn.error().message;
      EXPECT_THAT(unreadable_texts(canvas, width, height, 0.0), IsEmpty()) << kind.name;
    }
  }
}

TEST_F(FigureLayout, LeavesNoPanelOutAtTheSizeOfAPrintedPage) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> expected = {
      {"overhead-pair", {"(a)", "(b)"}},
      {"flight", {"(a)", "(b)", "(c)", "(d)", "(e)"}},
      {"reconstruction", {"(a)", "(b)", "(c)", "(d)"}},
      {"moment", {"(a)", "(b)", "(c)", "(d)", "(e)", "(f)", "(g)"}},
      {"error-surface", {"(a)", "(b)", "(c)"}},
      {"compare", {"(a)", "(b)", "(c)", "(d)", "(e)"}}};
  for (const auto& [name, captions] : expected) {
    FigureRecipe asked = recipe(figure_kind(name).value());
    for (const int width : {600, 1600}) {
      asked.options.size.width = width;
      auto figure = make_figure(asked);
      ASSERT_TRUE(figure.has_value()) << figure.error().message;
      context_.set_format(page_format(asked.options, figure_kind(name)->aspect));
      RecordedPage canvas;
      ASSERT_TRUE((*figure)->draw(canvas, context_).has_value());
      for (const std::string& caption : captions) {
        EXPECT_TRUE(canvas.has_text(caption)) << name << " at " << width << ": " << caption;
      }
    }
  }
}

TEST(UnreadableTexts, FindsWhatOverlapsLeavesThePageOrIsCutOff) {
  TextStyle style;
  style.size_px = 10.0;
  RecordedPage fine;
  fine.text({10.0, 10.0}, "one", style);
  fine.text({10.0, 30.0}, "two", style);
  fine.push_clip({0.0, 50.0, 10.0, 10.0});
  fine.text({50.0, 10.0}, "outside", style);
  fine.pop_clip();
  EXPECT_THAT(unreadable_texts(fine, 100.0, 100.0, 10.0), IsEmpty());
  RecordedPage bad;
  bad.text({10.0, 10.0}, "one", style);
  bad.text({12.0, 12.0}, "two", style);
  bad.text({95.0, 50.0}, "three", style);
  bad.push_clip({0.0, 70.0, 12.0, 30.0});
  bad.text({10.0, 80.0}, "four", style);
  bad.pop_clip();
  EXPECT_THAT(unreadable_texts(bad, 100.0, 100.0, 10.0),
              ElementsAre("'two' covers 'one'", "'three' leaves the page", "'four' is cut off"));
}

}  // namespace figure_layout_test
}  // namespace nadir
