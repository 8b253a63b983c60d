// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <memory>

#include "app/gui/ground_picture.h"
#include "core/map/overhead_map_file.h"
#include "tests/support/scratch_folder.h"
#include "tests/widgets/panels/made_moment.h"
#include "widgets/gl/offscreen_context.h"

namespace nadir {

/// A ground of the made moment, whose topview lies 3 m north of where it was seen: there its classes are not the map's.
class MadeGround : public ::testing::Test {
 protected:
  static constexpr int kWidth = 160, kHeight = 120;

  void SetUp() override {
    auto context = OffscreenContext::create();
    if (!context) GTEST_SKIP() << context.error().message;
    context_ = std::move(*context);
    ASSERT_TRUE(write_overhead_map(made_.map->map(), {}, std::nullopt, folder_.path() / "map"));
    ground_ = GroundPicture::open(folder_.path() / "map", budget_).value();
    contents_.look = made_.map_view().look;
    contents_.step = made_.step;
    contents_.labels = std::shared_ptr<const OverheadMap>(made_.map, &made_.map->map());
  }
  /// Shows the contents and draws them once. @param metres_per_px  Of a camera that looks where the contents do.
  void draw_once(const GroundPart& part, double metres_per_px) {
    ground_->show(contents_);
    const MapCamera camera{contents_.look.centre_in_enu_m, metres_per_px};
    const auto drawn = ground_->draw(camera, kWidth, kHeight, 1.0, part);
    EXPECT_TRUE(drawn) << drawn.error().message;
  }
  [[nodiscard]] GroundPart all_layers() const {
    GroundPart part;
    part.layers = contents_.look.order;
    return part;
  }

  MadeMoment made_;
  ScratchFolder folder_;
  std::shared_ptr<TileBudget> budget_ = std::make_shared<TileBudget>();
  GroundContents contents_;
  std::unique_ptr<OffscreenContext> context_;  // before what is drawn with it
  std::unique_ptr<GroundPicture> ground_;
};

}  // namespace nadir
