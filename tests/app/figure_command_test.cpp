// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "tests/app/drawn_run.h"
#include "widgets/canvas/png_file.h"

namespace nadir {
namespace figure_command_test {

namespace fs = std::filesystem;

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class FigureCommand : public DrawnRun {
 protected:
  void expect_refused(std::vector<std::string> words, const std::string& fault, int status = 1) {
    words.insert(words.begin(), "figure");
    const auto refused = run_program(words);
    EXPECT_EQ(refused.status, status) << fault;
    EXPECT_THAT(refused.err, HasSubstr(fault));
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
    EXPECT_EQ(refused.out, "");
    EXPECT_FALSE(exists("f.png"));
  }
};

TEST_F(FigureCommand, DrawsByTheEndingOfItsFile) {
  for (const auto& [name, start] :
       {std::pair("f.png", "\x89PNG"), std::pair("f.svg", "<?xml"), std::pair("f.PDF", "%PDF-")}) {
    const auto drawn = figure({"cdf", "--run", path("run.nadir"), "--out", path(name)});
    EXPECT_EQ(drawn.status, 0) << drawn.err;
    EXPECT_EQ(drawn.err, "");
    EXPECT_THAT(bytes(name), StartsWith(start));
  }
  const auto film = figure({"trajectories", "--run", path("run.nadir"), "--out", path("f.mp4"),
                            "--speed", "10", "--fps", "5"});
  EXPECT_EQ(film.status, 0) << film.err;
  EXPECT_THAT(bytes("f.mp4").substr(4, 4), "ftyp");
}

TEST_F(FigureCommand, StreamsThePngThatItWouldWrite) {
  const auto streamed = figure({"cdf", "--run", path("run.nadir"), "--out", "-"});
  ASSERT_EQ(figure({"cdf", "--run", path("run.nadir"), "--out", path("f.png")}).status, 0);
  EXPECT_EQ(streamed.out, bytes("f.png"));
}

TEST_F(FigureCommand, TakesRunsOneByOneAndLeavesTheFigureItsName) {
  write_drive(path("b.nadir"), path("map"), 10);
  const auto drawn = run_program({"figure", "--run", path("run.nadir"), "--run", path("b.nadir"),
                                  "mse-bars", "--size", "300x200", "--out", path("f.png")});
  ASSERT_EQ(drawn.status, 0) << drawn.err;
  const auto texts = read_png_texts(path("f.png"));
  ASSERT_TRUE(texts);
  EXPECT_THAT(texts->at("nadir-recipe"),
              AllOf(HasSubstr("run.nadir\", \""), HasSubstr("b.nadir\"]"),
                    HasSubstr("size = \"300x200\"")));
  const auto word = run_program(
      {"figure", "cdf", "--run", path("run.nadir"), path("b.nadir"), "--out", path("g.png")});
  EXPECT_EQ(word.status, 2);
  EXPECT_THAT(word.err, HasSubstr("b.nadir' is one argument too many"));
}

TEST_F(FigureCommand, HasAFlagForATransparentPage) {
  ASSERT_EQ(figure({"cdf", "--run", path("run.nadir"), "--out", path("f.png")}).status, 0);
  ASSERT_EQ(
      figure({"cdf", "--transparent", "--run", path("run.nadir"), "--out", path("g.png")}).status,
      0);
  EXPECT_NE(bytes("f.png"), bytes("g.png"));
  EXPECT_THAT(read_png_texts(path("g.png"))->at("nadir-recipe"), HasSubstr("transparent = true\n"));
}

TEST_F(FigureCommand, DrawsAgainWhatAFileCarriesAndFlagsWin) {
  ASSERT_EQ(figure({"trajectories", "--run", path("run.nadir"), "--layers", "-odometry", "--out",
                    path("f.svg")})
                .status,
            0);
  for (const char* name : {"again.svg", "f.png", "again.png"}) {
    const std::string from = std::string(name) == "again.png" ? "f.png" : "f.svg";
    const auto again = run_program({"figure", "--recreate", path(from), "--out", path(name)});
    ASSERT_EQ(again.status, 0) << again.err;
    EXPECT_EQ(again.err, "");
  }
  EXPECT_EQ(bytes("again.svg"), bytes("f.svg"));
  EXPECT_EQ(bytes("again.png"), bytes("f.png"));
  const auto dark = run_program(
      {"figure", "--recreate", path("f.png"), "--theme", "dark", "--out", path("dark.png")});
  ASSERT_EQ(dark.status, 0) << dark.err;
  EXPECT_THAT(read_png_texts(path("dark.png"))->at("nadir-recipe"),
              AllOf(HasSubstr("theme = \"dark\""), HasSubstr("size = \"300\""),
                    HasSubstr("layers = \"picture,truth,estimate,")));
}

TEST_F(FigureCommand, SaysWhichInputHasChangedSinceAndDrawsAllTheSame) {
  ASSERT_EQ(figure({"labels", "--map", path("map"), "--out", path("map.png")}).status, 0);
  ASSERT_EQ(figure({"flight", "--run", path("run.nadir"), "--out", path("f.png")}).status, 0);
  write_drive(path("run.nadir"), path("map"), 11);
  fs::remove_all(path("map"));
  OverheadMap other = drawn_map(1.0, std::vector<std::string>(40, std::string(60, 'R')));
  ASSERT_TRUE(write_overhead_map(other, {.name = "other"}, std::nullopt, path("map")));
  const auto flight = run_program({"figure", "--recreate", path("f.png"), "--out", path("g.png")});
  EXPECT_EQ(flight.status, 0) << flight.err;
  EXPECT_EQ(flight.err, "nadir: " + path("run.nadir") +
                            " has changed since the figure was drawn\n"
                            "nadir: the run's map has changed since the figure was drawn\n");
  EXPECT_TRUE(exists("g.png"));
  const auto labels =
      run_program({"figure", "--recreate", path("map.png"), "--out", path("g.png")});
  EXPECT_EQ(labels.err, "nadir: " + path("map") + " has changed since the figure was drawn\n");
  const auto quiet =
      run_program({"figure", "--recreate", path("map.png"), "--quiet", "--out", path("g.png")});
  EXPECT_EQ(quiet.err, "");
  // A map that was named anew is no change.
  const auto named = run_program(
      {"figure", "--recreate", path("map.png"), "--map", path("map"), "--out", path("g.png")});
  EXPECT_EQ(named.status, 0);
  EXPECT_EQ(named.err, "");
}

TEST_F(FigureCommand, TakesAnotherRunThanThatOfTheRecipeForNoChange) {
  scratch_.file("r.toml",
                "figure = \"trajectories\"\nruns = [\"run.nadir\"]\n[options]\nsize = 300\n"
                "[inputs]\nruns = [\"00\"]\nmap = \"00\"\npicture = \"00\"\n");
  const auto stored = run_program({"figure", path("r.toml"), "--out", path("g.png")});
  EXPECT_EQ(stored.err, "nadir: " + path("run.nadir") +
                            " has changed since the figure was drawn\n"
                            "nadir: the run's map has changed since the figure was drawn\n");
  write_street(path("other"), false);
  write_drive(path("b.nadir"), path("other"), 9);
  const auto other =
      run_program({"figure", path("r.toml"), "--run", path("b.nadir"), "--out", path("g.png")});
  EXPECT_EQ(other.status, 0) << other.err;
  EXPECT_EQ(other.err, "");
}

TEST_F(FigureCommand, SaysThatThePictureOfTheMapHasChanged) {
  ASSERT_EQ(figure({"trajectories", "--run", path("run.nadir"), "--out", path("f.png")}).status, 0);
  fs::remove(path("map/image.tif"));
  const auto bare = run_program({"figure", "--recreate", path("f.png"), "--out", path("g.png")});
  EXPECT_EQ(bare.status, 0);
  EXPECT_EQ(bare.err,
            "nadir: the picture of the run's map has changed since the figure was drawn\n");
}

TEST_F(FigureCommand, SaysWhereAStoredPathStartsIfItLeadsNowhere) {
  ASSERT_EQ(figure({"cdf", "--run", path("run.nadir"), "--out", path("f.png")}).status, 0);
  fs::remove(path("run.nadir"));
  const auto lost = run_program({"figure", "--recreate", path("f.png"), "--out", path("g.png")});
  EXPECT_EQ(lost.status, 1);
  EXPECT_THAT(lost.err, AllOf(HasSubstr("f.png: its paths start at the folder that it was drawn "
                                        "in: "),
                              HasSubstr("run.nadir")));
}

TEST_F(FigureCommand, DrawsARecipeFileFromAnywhere) {
  scratch_.file("recipes/r.toml",
                "figure = \"cdf\"\nruns = [\"../run.nadir\"]\n[options]\nsize = 300\n");
  const auto drawn = run_program({"figure", path("recipes/r.toml"), "--out", path("f.png")});
  EXPECT_EQ(drawn.status, 0) << drawn.err;
  ASSERT_EQ(figure({"cdf", "--run", path("run.nadir"), "--out", path("g.png")}).status, 0);
  EXPECT_EQ(bytes("f.png"), bytes("g.png"));
}

TEST_F(FigureCommand, IsRefusedByOneSentenceBeforeAnyWork) {
  const std::string out = path("f.png");
  expect_refused({"cdf", "--run", "none.nadir", "--out", path("no/folder/f.png")},
                 "no/folder does not exist");
  expect_refused({"cdf", "--run", "none.nadir", "--out", path("f.gif")},
                 "does not end in .png, .svg, .pdf or .mp4");
  expect_refused({"cdf", "--run", path("run.nadir"), "--out", out, "--size", "0"},
                 "--size: a width of 0 is not in [200, 16000]; see 'nadir figure --help'");
  expect_refused({"cdf", "--run", path("run.nadir"), "--out", out, "--size", "100000"},
                 "--size: a width of 100000 is not in [200, 16000]");
  expect_refused({"cdf", "--run", path("run.nadir"), "--out", out, "--layers", "truht"},
                 "--layers: 'truht' is no layer (did you mean truth?)");
  expect_refused({"cdf", "--run", path("run.nadir"), "--out", out, "--width", "300"},
                 "--width: no such flag", 2);
  expect_refused({"cdf", "--out", out}, "figure 'cdf' needs a run (--run FILE)", 2);
  expect_refused({"compare", "--run", path("run.nadir"), "--out", out},
                 "figure 'compare' needs at least 2 runs", 2);
  expect_refused({"cdf", "--run", path("run.nadir"), "--out", out, "--from", "5", "--to", "2"},
                 "--from: 5 s is after --to 2 s");
  expect_refused({"--recreate", path("no.png"), "--out", out}, "no.png: does not exist");
  expect_refused({"--recreate", path("no.pdf"), "--out", out},
                 "no.pdf: only PNG and SVG figures carry their recipe");
  expect_refused({"--out", out}, "FIGURE is missing", 2);
  expect_refused({"--recreate", path("run.nadir"), "--run", "r", "--out", out},
                 "exclude each other", 2);
  scratch_.file("r.toml", "figure = \"cdf\"\n[options]\nsise = 3\n");
  expect_refused({path("r.toml"), "--out", out},
                 "r.toml: options: sise: no such option (did you mean size?)");
  write_drive(path("far.nadir"), path("map"), 5, {.plane_latitude_deg = 10.0});
  expect_refused({"trajectories", "--run", path("far.nadir"), "--out", out},
                 "far.nadir: was localised on another plane than");
}

TEST_F(FigureCommand, ExplainsItsOptionsOnTheHelpPage) {
  const auto help = run_program({"figure", "--help"});
  EXPECT_THAT(help.out, AllOf(HasSubstr("--size WIDTH[xHEIGHT]"), HasSubstr("--transparent "),
                              HasSubstr("--layers NAME[,NAME...]"),
                              HasSubstr("paths start at the current folder")));
  EXPECT_THAT(help.out, Not(HasSubstr("--width")));
  EXPECT_THAT(help.out, Not(HasSubstr("{true|false}")));
}

}  // namespace figure_command_test
}  // namespace nadir
