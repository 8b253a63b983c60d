// SPDX-License-Identifier: Apache-2.0
#include "widgets/panels/stream_bars.h"

#include <gmock/gmock.h>

#include <algorithm>

#include "tests/widgets/panels/timeline_run.h"

namespace nadir {
namespace stream_bars_test {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

/// A flight of which only the list of frames is there.
class ListedFlight : public FlightRecording {
 public:
  explicit ListedFlight(FlightDescription description) : FlightRecording(std::move(description)) {}
  [[nodiscard]] Result<SemanticFrame> load(std::size_t /*frame*/) const override {
    return tl::unexpected(Error{ErrorCode::kNotFound, "nothing to load"});
  }
};

/// Ten frames a second like the made run, with a picture each, labels with every fifth and depth but from 2 s to 4 s.
std::shared_ptr<const FlightRecording> listed_flight(int frames) {
  FlightDescription description;
  for (int i = 0; i < frames; ++i) {
    FlightFrame frame;
    frame.time_s = 100.0 + 0.1 * i;
    frame.image = "image.png";
    if (i % 5 == 0) frame.labels = "labels.png";
    if (i <= 20 || i >= 40) frame.depth = "depth.png";
    description.frames.push_back(frame);
  }
  return std::make_shared<ListedFlight>(std::move(description));
}

const StreamBar& bar_named(const std::vector<StreamBar>& bars, const std::string& name) {
  return *std::find_if(bars.begin(), bars.end(),
                       [&](const StreamBar& bar) { return bar.name == name; });
}

std::vector<std::string> names_of(const std::vector<StreamBar>& bars) {
  std::vector<std::string> names;
  for (const StreamBar& bar : bars) names.push_back(bar.name);
  return names;
}

TEST(StreamBars, TellOfFlightAndRun) {
  TimelineModel model = timeline_of(made_document(60));
  EXPECT_THAT(names_of(stream_bars(model)), ElementsAre("truth", "topview", "steps"));
  model.flight = listed_flight(60);
  EXPECT_THAT(names_of(stream_bars(model)),
              ElementsAre("image", "depth", "labels", "truth", "topview", "steps"));
}

TEST(StreamBars, HaveGapsWhereAStreamPauses) {
  TimelineModel model = timeline_of(made_document(60));
  model.flight = listed_flight(60);
  const std::vector<StreamBar> bars = stream_bars(model);
  const StreamBar& depth = bar_named(bars, "depth");
  ASSERT_EQ(depth.spans.size(), 2U);
  EXPECT_NEAR(depth.spans[0].from_s, 0.0, 1e-9);
  EXPECT_NEAR(depth.spans[0].to_s, 2.1, 1e-9) << "its last sample counts for one period";
  EXPECT_NEAR(depth.spans[1].from_s, 4.0, 1e-9);
  EXPECT_TRUE(depth.is_there(1.0));
  EXPECT_FALSE(depth.is_there(3.0));
  EXPECT_THAT(stream_words(depth), HasSubstr("1 gap, the longest 1.9 s at 00:02.1"));
}

TEST(StreamBars, TakeALowerRateForNoGap) {
  TimelineModel model = timeline_of(made_document(60));
  model.flight = listed_flight(60);
  const std::vector<StreamBar> bars = stream_bars(model);
  const StreamBar& labels = bar_named(bars, "labels");
  EXPECT_EQ(labels.samples, 12U);
  EXPECT_EQ(labels.spans.size(), 1U);
  EXPECT_EQ(stream_words(labels), "labels: 12 samples, no gaps");
}

TEST(StreamBars, OfWhatIsNotThereStayAndSayThatItIsMissing) {
  const auto blind = made_document(20, [](RunStep& step) {
    step.truth_in_enu.reset();
    step.topview_cells = 0;
  });
  const std::vector<StreamBar> bars = stream_bars(timeline_of(blind));
  EXPECT_THAT(names_of(bars), ElementsAre("truth", "topview", "steps"));
  EXPECT_THAT(bars[0].spans, ElementsAre());
  EXPECT_FALSE(bars[0].is_there(1.0));
  EXPECT_EQ(stream_words(bars[0]), "truth: missing");
  EXPECT_EQ(stream_words(bars[1]), "topview: missing");
  const std::vector<StreamBar> one = stream_bars(timeline_of(made_document(1)));
  ASSERT_EQ(one.size(), 3U);
  EXPECT_THAT(one[2].spans, ElementsAre(TimeSpan{0.0, 0.0}));
  EXPECT_TRUE(one[2].is_there(0.0));
  EXPECT_TRUE(stream_bars(TimelineModel{}).empty());
}

TEST(TimelineExtent, CoversAllRunsAndSeeksOnlyInTheActiveOne) {
  TimelineModel model = timeline_of(made_document(101));
  TimelineRun longer = timeline_run(made_document(201), false, 2);
  longer.offset_s = -2.0;
  model.runs.insert(model.runs.begin(), longer);
  const auto extent = model.extent();
  EXPECT_NEAR(extent.from_s, -2.0, 1e-9);
  EXPECT_NEAR(extent.to_s, 18.0, 1e-9);
  EXPECT_NEAR(extent.last_s, 10.0, 1e-9);
}

TEST(TimelineExtent, RestsAtTheFlightsEndWhileARunGrows) {
  TimelineModel model = timeline_of(made_document(11));
  model.flight = listed_flight(301);
  EXPECT_NEAR(model.extent().to_s, 1.0, 1e-9) << "a finished run shows as long as it is";
  model.runs[0].is_live = true;
  EXPECT_NEAR(model.extent().to_s, 30.0, 1e-9);
  EXPECT_NEAR(model.extent().last_s, 1.0, 1e-9);
  model.runs[0].document = made_document(21);
  EXPECT_NEAR(model.extent().to_s, 30.0, 1e-9);
  EXPECT_NEAR(model.extent().last_s, 2.0, 1e-9);
}

TEST(TimelineExtent, OfOneStepIsNotEmpty) {
  for (const int steps : {0, 1}) {
    const auto extent = timeline_of(made_document(steps)).extent();
    EXPECT_LT(extent.from_s, extent.to_s);
    EXPECT_EQ(extent.last_s, 0.0);
  }
}

}  // namespace stream_bars_test
}  // namespace nadir
