// SPDX-License-Identifier: Apache-2.0
#include "app/gui/label_ground.h"

#include <system_error>

#include "widgets/views/label_pictures.h"

namespace nadir {
namespace {

constexpr int kPictureTilesAFrame = 3;
constexpr int kLabelTilesAFrame = 12;

Eigen::Vector2d middle_of(const LabelGrid& grid) {
  return grid.enu_from_cells({0.5 * grid.width, 0.5 * grid.height});
}

}  // namespace

LabelGround::LabelGround(const LabelDesk& desk,
                         const std::filesystem::path& named,
                         std::shared_ptr<TileBudget> budget)
    : scene_(middle_of(desk.sheet().now().grid())),
      texture_(scene_.renderer()),
      budget_(std::move(budget)),
      borders_(scene_) {
  stroke_.follow(desk);
  labels_ = std::make_unique<TilePyramidView>(
      scene_, MapLayer::kLabels, std::make_shared<const LabelPictures>(stroke_.document()), budget_,
      TileMaking::kInThread);
  open_picture(desk, named);
}

void LabelGround::open_picture(const LabelDesk& desk, const std::filesystem::path& named) {
  std::error_code error;
  const std::filesystem::path& image = desk.sheet().image();
  std::shared_ptr<const OverheadTiles> tiles;
  if (std::filesystem::exists(named / "map.toml", error)) {
    if (!std::filesystem::exists(named / "image.tif", error)) return;
    auto opened = OverheadTiles::open(named, OverheadTiles::Layer::kPicture);
    if (!opened) {
      picture_fault_ = opened.error();
      return;
    }
    tiles = std::make_shared<const OverheadTiles>(std::move(*opened));
  } else {
    if (image.empty()) return;
    ImageOptions options;
    options.plane = desk.sheet().now().plane();
    auto opened = open_overhead_image(image, options);
    if (!opened) {
      picture_fault_ = opened.error();
      return;
    }
    tiles = std::make_shared<const OverheadTiles>(std::move(opened->tiles));
  }
  picture_ = std::make_unique<TilePyramidView>(
      scene_, MapLayer::kPicture,
      std::make_shared<const OverheadPictures>(std::move(tiles), OverheadTiles::Layer::kPicture),
      budget_, TileMaking::kInThread);
}

bool LabelGround::follow(const LabelDesk& desk) {
  const LabelChanges changes = stroke_.follow(desk);
  if (bordered_ != desk.sheet().revision()) {
    bordered_ = desk.sheet().revision();
    borders_.show(desk.sheet().document());
    drawn_.reset();
  }
  if (changes.empty()) return false;
  labels_->show(std::make_shared<const LabelPictures>(stroke_.document()));
  if (changes.is_everything) {
    labels_->forget_all();
  } else {
    for (const PlaneBounds& part : changes.parts) labels_->forget(part);
  }
  return true;
}

Result<void> LabelGround::draw(const LabelDesk& desk,
                               const LabelGroundLook& look,
                               const MapCamera& camera,
                               int width,
                               int height,
                               double px_per_pt) {
  Result<void> outcome;
  if (picture_fault_) outcome = tl::unexpected(*std::exchange(picture_fault_, std::nullopt));
  const bool is_changed = follow(desk);
  const Drawn wanted{look, camera, width, height, px_per_pt};
  if (!is_changed && !wants_more_ && drawn_ == wanted) return outcome;
  if (picture_) {
    picture_->set_visible(look.picture_opacity > 0.0);
    picture_->set_opacity(look.picture_opacity);
  }
  labels_->set_visible(look.labels_opacity > 0.0);
  labels_->set_opacity(look.labels_opacity);
  borders_.set_visible(look.shows_borders);
  bool is_complete = true;
  const auto update = [&](TilePyramidView* view, bool is_seen, int most_tiles) {
    if (view == nullptr || !is_seen) return;
    const auto is_all = view->update(camera, width, height, most_tiles);
    if (!is_all) outcome = forward_error(is_all);
    if (!is_all || !*is_all) is_complete = false;
  };
  update(picture_.get(), look.picture_opacity > 0.0, kPictureTilesAFrame);
  update(labels_.get(), look.labels_opacity > 0.0, kLabelTilesAFrame);
  wants_more_ = !is_complete;
  scene_.set_background(look.background, false);
  scene_.look({camera, 1.0 * width, 1.0 * height, px_per_pt});
  texture_.draw(width, height);
  drawn_ = wanted;
  return outcome;
}

}  // namespace nadir
