// SPDX-License-Identifier: Apache-2.0
#include "core/base/random.h"
#include "core/desk/label_coverage.h"
#include "tests/core/desk/desk_at_work.h"

namespace nadir {
namespace label_desk_fuzz_test {

/// Does what a hand might do next, sensible or not.
class RandomHand {
 public:
  RandomHand(std::uint64_t seed, LabelDesk& desk) : seed_(seed), desk_(desk) {}

  Result<void> act(std::uint32_t step) {
    step_ = step;
    draws_ = 0;
    switch (choice(16)) {
      case 0:
        return take_up();
      case 1:
        return desk_.undo();
      case 2:
        return desk_.redo();
      case 3:
        return desk_.finish();
      case 4:
        static_cast<void>(desk_.cancel());
        return {};
      case 5:
        desk_.select_at(place(), 1.0, SelectHow::kAdd);
        return {};
      case 6:
        return command();
      case 7:
        return desk_.draw({ObjectKind::kArea, kRoad, 0.0}, {place(), place(), place()});
      case 8:
        return desk_.stroke({place(), place()}, random(0.3, 6.0), kTerrain);
      default:
        return desk_.add_point(place(), 1.5);
    }
  }

 private:
  double random(double low, double high) {
    return low + (high - low) * uniforms({seed_, 0, step_, 3, draws_++})[0];
  }
  int choice(int count) { return static_cast<int>(random(0.0, count)); }
  Eigen::Vector2d place() { return {random(-5.0, 125.0), random(-95.0, 5.0)}; }
  Result<void> take_up() {
    LabelTool tool = desk_.tool();
    tool.kind = static_cast<ToolKind>(choice(static_cast<int>(EnumNames<ToolKind>::kNames.size())));
    use_class(tool, std::array<ClassId, 4>{kRoad, kBuilding, kCurb, kUnclassified}.at(
                        static_cast<std::size_t>(choice(4))));
    tool.shares_borders = choice(2) == 0;
    tool.paints_over = choice(2) == 0;
    return desk_.set_tool(tool);
  }
  Result<void> command() {
    switch (choice(9)) {
      case 0:
        return desk_.move_selected({random(-9.0, 9.0), random(-9.0, 9.0)});
      case 1:
        return desk_.delete_selected();
      case 2:
        return desk_.duplicate_selected({1.0, 1.0});
      case 3:
        return desk_.set_class(kTerrain);
      case 4:
        return desk_.set_width(random(0.1, 3.0));
      case 5:
        return desk_.reorder(static_cast<OrderMove>(choice(4)));
      case 6:
        return desk_.merge();
      case 7:
        return desk_.objects_to_paint();
      default:
        return desk_.go_to(choice(static_cast<int>(desk_.sheet().history(1, 9999)->size())));
    }
  }

  std::uint64_t seed_;
  LabelDesk& desk_;
  std::uint32_t step_ = 0, draws_ = 0;
};

class RandomHands : public testing::TestWithParam<std::uint64_t> {};

/// Draws again what has changed, as a window does.
void follow(Raster<ClassId>& labels, const LabelSheet& sheet, std::int64_t revision) {
  const LabelChanges changes = sheet.changed_since(revision);
  const LabelGrid& grid = sheet.now().grid();
  for (const PlaneBounds& part : changes.parts) {
    const CellRect cells = grid.cells_of(part, 1).cut_to(grid.whole());
    if (cells.empty()) continue;
    const auto drawn = rasterise(sheet.now(), grid, cells);
    for (int row = 0; row < drawn.height(); ++row) {
      const auto from = drawn.row(row);
      std::copy(from.begin(), from.end(),
                labels.row(row + static_cast<int>(cells.top)).begin() + cells.left);
    }
  }
}

TEST_P(RandomHands, LeaveWhatIsShownEqualToWhatIsThere) {
  const ScratchFolder scratch;
  const auto path = scratch.path() / "labels.gpkg";
  ASSERT_THAT(LabelStore::create(path, test_plane(), test_grid(120, 90), "ada"), Succeeds());
  std::optional<LabelDesk> desk(opened_desk(path));
  Raster<ClassId> labels = rasterise(desk->sheet().now());
  int done = 0;
  for (std::uint32_t step = 0; step < 150; ++step) {
    const std::int64_t revision = desk->sheet().revision();
    const auto before = desk->sheet().document();
    const Result<void> acted = RandomHand(GetParam(), *desk).act(step);
    if (!acted) {
      ASSERT_TRUE(*before == desk->sheet().now()) << error_text(acted);
      ASSERT_FALSE(acted.error().message.empty());
    }
    done += desk->sheet().revision() != revision ? 1 : 0;
    follow(labels, desk->sheet(), revision);
    ASSERT_EQ(labels, rasterise(desk->sheet().now())) << "step " << step;
    ASSERT_TRUE(desk->count_more(4));
    for (const ClassId id : {kRoad, kTerrain, kUnclassified}) {
      ASSERT_EQ(desk->sheet().coverage().cells(id),
                std::count(labels.values().begin(), labels.values().end(), id));
    }
    for (const ObjectId id : desk->selection().ids()) {
      ASSERT_NE(desk->sheet().now().object(id), nullptr);
    }
    if (step % 50 != 49) continue;
    const auto shown = desk->sheet().document();
    const auto undo_title = desk->sheet().undo_title();
    const LabelTool tool = desk->tool();
    desk.reset();
    desk.emplace(opened_desk(path));
    ASSERT_TRUE(desk->sheet().now() == *shown);
    ASSERT_EQ(desk->sheet().undo_title(), undo_title);
    ASSERT_THAT(desk->set_tool(tool), Succeeds());
  }
  EXPECT_GT(done, 20);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomHands, testing::Values(81, 82, 83));

}  // namespace label_desk_fuzz_test
}  // namespace nadir
