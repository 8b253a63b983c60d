// SPDX-License-Identifier: Apache-2.0
// What the window offers to export is what the program can draw.
#include "core/session/export_kinds.h"

#include <gtest/gtest.h>

#include "widgets/figures/figures.h"
#include "widgets/figures/page_size.h"

namespace nadir {
namespace export_kinds_test {

TEST(ExportKinds, AreAllFiguresOfTheProgram) {
  for (const FigureKind& figure : figure_kinds()) {
    const ExportKind* const kind = export_kind(figure.name);
    ASSERT_NE(kind, nullptr) << figure.name;
    EXPECT_EQ(kind->runs == RunsOfFigure::kNone, figure.fewest_runs == 0) << figure.name;
    EXPECT_EQ(kind->runs == RunsOfFigure::kAll, figure.most_runs > 1) << figure.name;
    EXPECT_EQ(kind->needs_map, figure.needs_map) << figure.name;
    EXPECT_EQ(kind->needs_truth, figure.needs_truth) << figure.name;
  }
  for (const ExportKind& kind : export_kinds()) {
    if (kind.form == ExportKind::Form::kFigure) {
      EXPECT_TRUE(figure_kind(kind.name)) << kind.name;
    }
  }
}

TEST(ExportKinds, HaveTheWidthsOfPages) {
  EXPECT_EQ(kLeastFigureWidthPx, PageSize::kLeastWidth);
  EXPECT_EQ(kMostFigureWidthPx, PageSize::kMost);
}

}  // namespace export_kinds_test
}  // namespace nadir
