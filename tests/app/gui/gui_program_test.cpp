// SPDX-License-Identifier: Apache-2.0
// The program's window as a whole, in a process of its own: what a user does, written as scripts.
#include "tests/app/gui/gui_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>
#include <opencv2/imgcodecs.hpp>
#include <thread>

#include "core/run/run_file.h"
#include "tests/support/error_text.h"

namespace nadir {
namespace gui_program_test {

using ::testing::HasSubstr;

TEST_F(GuiProgram, ShowsItsWelcomeWithoutADisplay) {
  const Ending ended = gui({"--fresh", "--size", "960x600", "--screenshot", path("welcome.png")});
  ASSERT_EQ(ended.status, 0) << ended.words;
  const cv::Mat picture = cv::imread(path("welcome.png"));
  EXPECT_EQ(picture.cols, 960);
  EXPECT_EQ(picture.rows, 600);
  cv::Scalar mean, deviation;
  cv::meanStdDev(picture, mean, deviation);
  EXPECT_GT(deviation[0], 5.0);  // there is something on it
}

TEST_F(GuiProgram, DrawsTheSamePictureTwice) {
  for (const char* const name : {"a.png", "b.png"}) {
    std::filesystem::remove_all(path("config"));
    const Ending ended = gui({path("demo/run.nadir"), "--screenshot", path(name)});
    ASSERT_EQ(ended.status, 0) << ended.words;
  }
  const cv::Mat first = cv::imread(path("a.png"));
  const cv::Mat second = cv::imread(path("b.png"));
  ASSERT_EQ(first.size(), second.size());
  cv::Mat differing;
  cv::absdiff(first, second, differing);
  // The memory that is used may be another by a megabyte.
  EXPECT_LT(cv::countNonZero(differing.reshape(1) > 8), 600);
}

// Open the run, see why its worst moment is bad, change an option, run again from before, compare, export, leave, come back.
TEST_F(GuiProgram, DebugsAFlight) {
  const Ending first = script(
      "wait\n"
      "go worst\n"
      "panel why on\n"
      "wait\n"
      "expect-words \"mean cost\"\n"
      "option position-noise 1.5\n"
      "step -40\n"
      "rerun cursor\n"
      "wait\n"
      "panel runs on\n"
      "wait\n"
      "expect-words run-2\n"
      "expect-words \"Settings that differ\"\n"
      "go worst\n"
      "export " +
          path("moment.svg") +
          "\n"
          "wait\n"
          "theme light\n"
          "quit\n",
      {path("demo/run.nadir")});
  ASSERT_EQ(first.status, 0) << first.words;
  EXPECT_THAT(bytes("moment.svg"), HasSubstr("<svg"));
  const auto again = RunReader::open(path("demo/run-2.nadir"));
  ASSERT_TRUE(again) << error_text(again);
  EXPECT_TRUE(again->is_complete());
  EXPECT_EQ(again->header().options.at("position-noise"), "1.5");
  EXPECT_EQ(again->step_count(), RunReader::open(path("demo/run.nadir"))->step_count());

  const Ending second = script("wait\nexpect-words run-2\nscreenshot " + path("again.png") + "\n");
  ASSERT_EQ(second.status, 0) << second.words;
  const cv::Mat picture = cv::imread(path("again.png"));
  ASSERT_FALSE(picture.empty());
  EXPECT_GT(cv::mean(picture)[0], 120.0);  // still in the light theme
}

TEST_F(GuiProgram, TakesBackAndDoesAgain) {
  const Ending ended = script(
      "wait\n"
      "layer particles off\n"
      "expect Left/Layers/particles/visible off\n"
      "undo\n"
      "expect Left/Layers/particles/visible on\n"
      "redo\n"
      "expect Left/Layers/particles/visible off\n"
      "click Left/Layers/particles/visible\n"
      "expect Left/Layers/particles/visible on\n",
      {path("demo/run.nadir")});
  EXPECT_EQ(ended.status, 0) << ended.words;
}

TEST_F(GuiProgram, LosesNothingWhenItIsKilledWhileItLocalises) {
  auto process = ChildProcess::start(
      NADIR_PROGRAM, {"gui", "--config", path("config"), path("demo/run.nadir"), "--script",
                      scratch_.file("kill.txt", "wait\nrerun start\nwait\n").string()});
  ASSERT_TRUE(process) << error_text(process);
  const std::string made = path("demo/run-2.nadir");
  int steps = 0;
  for (int i = 0; i < 6'000 && steps < 20 && !process->poll(); ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (!std::filesystem::exists(made)) continue;
    if (const auto run = RunReader::open(made)) steps = run->step_count();
  }
  ASSERT_GE(steps, 20);
  ASSERT_EQ(::kill(process->id(), SIGKILL), 0);
  while (!process->poll()) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  const auto left = RunReader::open(made);
  ASSERT_TRUE(left) << error_text(left);
  EXPECT_GE(left->step_count(), steps);
  EXPECT_FALSE(left->is_complete());
  const Ending next = script("wait\nexpect-words run-2\n");
  EXPECT_EQ(next.status, 0) << next.words;
}

TEST_F(GuiProgram, LeavesWhatWasOpenLastToTheNextStartThatIsNotFresh) {
  ASSERT_EQ(script("wait\npanel runs on\n", {path("demo/run.nadir")}).status, 0);
  std::filesystem::copy_file(path("demo/run.nadir"), path("demo/another.nadir"));
  for (int i = 0; i < 2; ++i) {
    const Ending fresh = script("wait\nexpect-not Left/Runs/1/Close\nopen " +
                                    path("demo/another.nadir") + "\nwait\ntheme light\nquit\n",
                                {"--fresh"});
    ASSERT_EQ(fresh.status, 0) << fresh.words;
  }
  const Ending next =
      script("wait\nexpect Left/Runs/1/Close\nexpect-not Left/Runs/2/Close\ncontrols " +
             path("controls.txt") + "\n");
  ASSERT_EQ(next.status, 0) << next.words;
  EXPECT_THAT(bytes("controls.txt"), testing::Not(HasSubstr("another")));
}

TEST_F(GuiProgram, OpensARunWhoseNameIsNoTextAgain) {
  const std::string run = path("demo/caf\xE9.nadir");
  std::filesystem::rename(path("demo/run.nadir"), run);
  const Ending first = script("wait\nbookmark here\npanel runs on\nwait\nscreenshot " +
                                  path("name.png") + "\nexport " + path("moment.svg") + "\nwait\n",
                              {run});
  ASSERT_EQ(first.status, 0) << first.words;
  EXPECT_THAT(bytes("moment.svg"), HasSubstr("<svg")) << "another process has drawn it";
  const Ending second = script("wait\nexpect Left/Runs/1/Close\n");
  EXPECT_EQ(second.status, 0) << second.words;
  const Ending figure = script("wait\npanel runs on\nwait\nexpect Left/Runs/1/Close\n",
                               {"--fresh", path("moment.svg")});
  EXPECT_EQ(figure.status, 0) << figure.words;
}

TEST_F(GuiProgram, LeavesTheUsersFolderAloneWhereNobodySeesIt) {
  const std::filesystem::path config = path("home");
  auto process = ChildProcess::start(
      NADIR_PROGRAM, {"gui", path("demo/run.nadir"), "--screenshot", path("unseen.png")},
      {{"XDG_CONFIG_HOME", config.string()}});
  ASSERT_TRUE(process) << error_text(process);
  std::optional<int> status;
  while (!(status = process->poll())) std::this_thread::sleep_for(std::chrono::milliseconds(5));
  EXPECT_EQ(status, 0);
  EXPECT_TRUE(std::filesystem::exists(path("unseen.png")));
  EXPECT_FALSE(std::filesystem::exists(config)) << "no session, no recents, no preferences";
}

TEST_F(GuiProgram, TellsFaultsOfScriptsAndArgumentsInOneSentence) {
  Ending ended = script("play sideways\n");
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.words, HasSubstr("script.txt:1: "));
  ended = gui({"--size", "10x10", "--screenshot", path("x.png")});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.words, HasSubstr("--size: 10 is not in [320, 8192]"));
  ended = gui({"--script", path("nowhere.txt")});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.words, HasSubstr("nowhere.txt: cannot be read"));
}

// A person sees the notice; whoever drives the window without a display has status and standard error.
TEST_F(GuiProgram, ShowsWhatCannotBeOpenedAsANoticeAndFailsWhereNobodySeesIt) {
  const std::string complaint = "nadir: " + path("missing.nadir") + ": does not exist\n";
  Ending ended = script("wait\nexpect-words missing.nadir\n", {path("missing.nadir")});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.words, HasSubstr(complaint));
  EXPECT_THAT(ended.words, testing::Not(HasSubstr("script.txt"))) << "it went on to its end";
  ended = gui({path("missing.nadir"), "--screenshot", path("missing.png")});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.words, HasSubstr(complaint));
  EXPECT_FALSE(cv::imread(path("missing.png")).empty()) << "the picture was asked for";
}

TEST_F(GuiProgram, SaysAlsoWhatIsFoundOutOnlyWhenAFileIsRead) {
  std::string damaged = bytes("demo/run.nadir");
  damaged.resize(damaged.size() / 2);
  scratch_.file("damaged.nadir", damaged);
  scratch_.file("drive/flight.toml", "[flight\n");
  const Ending ended = gui({path("damaged.nadir"), path("drive"), path("demo/run.nadir"),
                            "--screenshot", path("window.png")});
  EXPECT_EQ(ended.status, 1);
  EXPECT_THAT(ended.words, HasSubstr(path("damaged.nadir")));
  EXPECT_THAT(ended.words, HasSubstr("flight.toml: line 1"));
  EXPECT_THAT(ended.words, testing::Not(HasSubstr("demo/run.nadir")));
  EXPECT_EQ(gui({path("demo/run.nadir"), "--screenshot", path("window.png")}).status, 0);
}

}  // namespace gui_program_test
}  // namespace nadir
