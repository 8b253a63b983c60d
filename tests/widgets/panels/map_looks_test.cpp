// SPDX-License-Identifier: Apache-2.0
// How lines and particles of a map look.
#include <gmock/gmock.h>

#include "tests/widgets/panels/made_moment.h"
#include "widgets/panels/map_lines.h"

namespace nadir {
namespace map_looks_test {

TEST(MapLook, AColourOfTheUsersOwnIsTheActiveRuns) {
  const MadeMoment made;
  MapViewModel model = made.map_view();
  model.look.layer(Layer::kEstimate).colour = "#FF8000";
  const Theme& dark = theme(ThemeName::kDark);
  EXPECT_EQ(run_path_look(model, model.runs[0], PoseSource::kEstimate, dark).colour,
            (Rgba{255, 128, 0}));
  MapRun other = model.runs[0];
  other.is_active = false;
  other.colour = 1;
  EXPECT_EQ(run_path_look(model, other, PoseSource::kEstimate, dark).colour, dark.second_run);
  EXPECT_FALSE(colour_from_hex("#12345"));
  EXPECT_FALSE(colour_from_hex("#12345G"));
}

TEST(MapLook, ParticlesAreCasedInTheOppositeOfWhatTheyLieOn) {
  for (const ThemeName name : {ThemeName::kDark, ThemeName::kLight}) {
    const Theme& colours = theme(name);
    EXPECT_EQ(particle_casing(colours, true), with_opacity(colours.casing_on_imagery, 0.85));
    EXPECT_EQ(particle_casing(colours, false), with_opacity(colours.window, 0.85));
  }
}

}  // namespace map_looks_test
}  // namespace nadir
