// SPDX-License-Identifier: Apache-2.0
#include "core/insight/stretch_rerun.h"

#include <gmock/gmock.h>

#include "core/insight/label_ground.h"
#include "core/label/label_raster.h"
#include "core/run/resume_point.h"
#include "tests/core/insight/driven_flight.h"
#include "tests/core/label/drawn_labels.h"
#include "tests/support/error_text.h"
#include "tests/support/scenery.h"
#include "tests/support/scratch_folder.h"

namespace nadir {
namespace stretch_rerun_test {

constexpr int kDriveFrames = 48;  // 12 s, 24 m

/// A drive on labels whose bars of the second half nobody has drawn, while its odometry thinks that it goes a fifth too far.
struct Drive {
  ScratchFolder folder;
  std::shared_ptr<const FlightRecording> flight =
      std::make_shared<const DrivenFlight>(barred_road(), kDriveFrames, 1.2);
  std::shared_ptr<const MapIndex> complete = index_of(barred_road());
  std::shared_ptr<const MapIndex> unfinished = [] {
    OverheadMap map = barred_road();
    for (ClassId& label : map.labels.values()) {
      if (label == kLaneMarking) label = kRoad;
    }
    map.labels.at(0, 0) = kLaneMarking;  // the class is known, so that both runs look for it
    return index_of(std::move(map));
  }();
  std::filesystem::path file = folder.path() / "drive.nadir";

  [[nodiscard]] static const Drive& get() {
    static const Drive drive;
    return drive;
  }
  [[nodiscard]] StretchTask task(double from_s, double to_s) const {
    return {flight, unfinished, complete, quick_options(), from_s, to_s};
  }
  [[nodiscard]] RunReader run() const { return RunReader::open(file).value(); }

 private:
  Drive() { record_drive(*flight, unfinished, quick_options(), file); }
};

TEST(StretchRerun, ShowsThatDrawingWhatWasMissingHelps) {
  const Drive& drive = Drive::get();
  const auto result = rerun_stretch(drive.run(), drive.task(2.0, 9.0));
  ASSERT_TRUE(result.has_value()) << error_text(result);
  ASSERT_EQ(result->steps.size(), 28U) << "later than 2 s, up to and with 9 s";
  EXPECT_NEAR(result->steps.front().time_s, 2.25, 1e-9);
  EXPECT_NEAR(result->steps.back().time_s, 9.0, 1e-9);
  EXPECT_LT(*result->mean_error_after_m, 0.6 * *result->mean_error_before_m);
  EXPECT_LT(*result->steps.back().error_after_m, 0.5 * *result->steps.back().error_before_m);
  const auto before = result->class_before[kLaneMarking];
  const auto after = result->class_after[kLaneMarking];
  EXPECT_EQ(before.agreeing + before.disagreeing + before.unknown,
            after.agreeing + after.disagreeing + after.unknown);
  EXPECT_GT(after.agreeing, 10 * before.agreeing);
}

TEST(StretchRerun, SetsBesideWhatWasRecorded) {
  const Drive& drive = Drive::get();
  const auto run = drive.run();
  const auto result = rerun_stretch(run, drive.task(2.0, 4.0)).value();
  const auto recorded = run.steps().value();
  double sum_m = 0.0;
  for (const StretchStep& step : result.steps) {
    const auto same = std::find_if(recorded.begin(), recorded.end(), [&](const RunStep& other) {
      return std::abs(other.time_s - step.time_s) < 1e-6;
    });
    ASSERT_NE(same, recorded.end());
    EXPECT_EQ(step.before_in_enu, same->estimate.moments.mean);
    sum_m += std::hypot(same->estimate.moments.mean.x_m - same->truth_in_enu->x_m,
                        same->estimate.moments.mean.y_m - same->truth_in_enu->y_m);
  }
  EXPECT_NEAR(*result.mean_error_before_m, sum_m / static_cast<double>(result.steps.size()), 1e-12);
}

TEST(StretchRerun, OnUnchangedLabelsIsAlike) {
  const Drive& drive = Drive::get();
  StretchTask task = drive.task(3.0, 6.0);
  task.after = task.before;
  const auto result = rerun_stretch(drive.run(), task).value();
  EXPECT_NEAR(*result.mean_error_after_m, *result.mean_error_before_m, 0.2);
}

TEST(StretchRerun, TellsHowFarItIsAndStops) {
  const Drive& drive = Drive::get();
  std::stop_source stop;
  std::vector<std::size_t> published;
  const auto stopped =
      rerun_stretch(drive.run(), drive.task(2.0, 9.0), {.stop = stop.get_token(), .progress = {}},
                    [&](const StretchRerun& so_far) {
                      published.push_back(so_far.steps.size());
                      EXPECT_TRUE(so_far.mean_error_after_m.has_value());
                      if (so_far.steps.size() == 3) stop.request_stop();
                    });
  EXPECT_EQ(error_code(stopped), ErrorCode::kCancelled);
  EXPECT_THAT(published, testing::ElementsAre(1U, 2U, 3U));
}

TEST(StretchRerun, RefusesWhatHasNoFramesOrNoParticles) {
  const Drive& drive = Drive::get();
  EXPECT_THAT(error_text(rerun_stretch(drive.run(), drive.task(4.0, 4.1))),
              testing::HasSubstr("no frame lies between 4.000 s and 4.100 s"));
  EXPECT_THAT(error_text(rerun_stretch(drive.run(), drive.task(99.0, 100.0))),
              testing::HasSubstr("99 s to go on from is not among them"));
}

TEST(LabelledGround, HasTheDocumentsLabelsOnTheMapsCells) {
  LabelDocument document = test_document(80, 60);
  LabelEdit edit;
  edit.objects.push_back(
      {nullptr, std::make_shared<LabelObject>(area(kRoad, {box(3, 4, 20, 30)}))});
  document.apply(edit);
  OverheadMap map = patchwork_map(130, 70, 0.3);
  map.plane = test_plane();
  map.top_left_in_enu_m = {1.0, -2.0};
  const auto ground = labelled_ground(map, document);
  ASSERT_TRUE(ground.has_value()) << error_text(ground);
  EXPECT_EQ((*ground)->map().top_left_in_enu_m, map.top_left_in_enu_m);
  EXPECT_EQ((*ground)->map().labels, rasterise(document, grid_of(map), grid_of(map).whole()));
  map.plane = ProjectPlane::create({1.0, 2.0}).value();
  EXPECT_THAT(error_text(labelled_ground(map, document)), testing::HasSubstr("another plane"));
}

}  // namespace stretch_rerun_test
}  // namespace nadir
