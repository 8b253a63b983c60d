// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/run_table_texts.h"

#include <gmock/gmock.h>

#include "tests/widgets/panels/shown_runs.h"
#include "widgets/panels/run_metric_rows.h"

namespace nadir {
namespace run_table_texts_test {

using ::testing::SizeIs;

/// What is kept is drawn as it is: a word that nobody made stands until all are made anew.
class KeptTexts : public ::testing::Test {
 protected:
  void mark() { shown.state.texts.metrics[0].digits[0] = "marked"; }
  [[nodiscard]] bool is_marked() { return shown.state.texts.metrics[0].digits[0] == "marked"; }
  void draw(int frames = 2) { shown.screen.wait(frames, shown.draw()); }

  ShownRuns shown{two_runs()};
};

TEST_F(KeptTexts, AreMadeOnceForAComparison) {
  ASSERT_THAT(shown.state.texts.metrics, SizeIs(shown_metrics().size()));
  mark();
  draw(5);
  EXPECT_TRUE(is_marked());
  EXPECT_TRUE(shown.screen.shows("marked")) << "and drawn";
  shown.screen.click("Runs/Settings that differ", shown.draw());
  shown.model.rows[0].is_shown = false;
  draw();
  EXPECT_TRUE(is_marked()) << "nothing that they say has changed";
}

TEST_F(KeptTexts, AreMadeAnewForOtherRunsNamesOrSizes) {
  mark();
  shown.model.rows[1].name = "wilder";
  draw();
  EXPECT_FALSE(is_marked());
  EXPECT_EQ(shown.state.texts.names[1], "wilder");
  mark();
  shown.model.rows[1].is_live = true;
  draw();
  EXPECT_FALSE(is_marked()) << "it has come that far, and does not end there";
  mark();
  shown.model.rows[1].document = made_document(90, [](RunStep& step) { set_error_m(step, 0.1); });
  draw();
  EXPECT_FALSE(is_marked());
  mark();
  shown.model.rows.pop_back();
  draw();
  EXPECT_FALSE(is_marked());
  EXPECT_THAT(shown.state.texts.names, SizeIs(1));
}

TEST_F(KeptTexts, AreBrokenAnewForAnotherRoom) {
  RunsModel model;
  for (int i = 1; i <= 6; ++i) {
    model.rows.push_back(row_of(i, "run " + std::to_string(i),
                                made_document(50, [i](RunStep& step) { set_error_m(step, i); })));
  }
  ShownRuns many(model);
  const std::size_t narrow = many.state.texts.metric_columns.parts.size();
  EXPECT_GT(narrow, 1U);
  many.screen.input().size_px.x() = 1000.0;
  many.screen.wait(3, many.draw());
  EXPECT_LT(many.state.texts.metric_columns.parts.size(), narrow);
  std::size_t next = 0;
  for (const RunColumns& part : many.state.texts.metric_columns.parts) {
    EXPECT_EQ(part.first, next) << "every run once, in order";
    EXPECT_EQ(part.columns.size(), 1 + part.end - part.first);
    next = part.end;
  }
  EXPECT_EQ(next, 6U);
}

TEST_F(KeptTexts, MarkTheBestAndLeaveOutWhatIsNotKnown) {
  const RunTableTexts& texts = shown.state.texts;
  for (std::size_t i = 0; i < texts.metrics.size(); ++i) {
    const MetricTexts& metric = texts.metrics[i];
    if (!metric.is_there) continue;
    ASSERT_THAT(metric.digits, SizeIs(2));
    for (std::size_t run = 0; run < 2; ++run) {
      EXPECT_EQ(metric.digits[run].starts_with(kBestMark), metric.is_best[run])
          << shown_metrics()[i].name;
    }
    EXPECT_EQ(metric.is_shared, metric.is_best[0] && metric.is_best[1]);
  }
}

TEST(RunTableTexts, LabelASettingByItsUnit) {
  SettingDifference setting;
  setting.name = "along-noise";
  EXPECT_EQ(label_of_setting(setting), "along-noise");
  setting.unit = "m/m";
  EXPECT_EQ(label_of_setting(setting), "along-noise [m/m]");
}

}  // namespace run_table_texts_test
}  // namespace nadir
