// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/settings.h"
#include "core/map/overhead_map_file.h"
#include "core/run/localise_flight.h"
#include "core/session/rerun.h"
#include "core/session/session.h"
#include "core/sim/route.h"
#include "core/sim/simulated_flight.h"
#include "tests/core/sim/street_map.h"
#include "tests/support/error_text.h"
#include "tests/support/scratch_folder.h"

namespace nadir {

/// Options with which a test's run is made in a moment.
[[nodiscard]] inline RunOptions few_particles() {
  RunOptions options;
  options.localiser.particle_count = 300;
  options.localiser.min_particle_count = 300;
  options.localiser.max_cells_per_class = 50;
  return options;
}

/// A street, a flight along it and a run of that flight, made once for all tests of a program.
struct SmallWorld {
  ScratchFolder folder;
  std::filesystem::path map = folder.path() / "street", flight = folder.path() / "flight",
                        run = folder.path() / "loop.nadir";
  std::shared_ptr<const FlightRecording> recording;
  std::shared_ptr<const MapIndex> index;

  [[nodiscard]] static const SmallWorld& get() {
    static const SmallWorld world;
    return world;
  }

  /// A task that makes a run of the flight.
  [[nodiscard]] RerunTask task(const std::filesystem::path& file) const {
    RerunTask task;
    task.flight = recording;
    task.map = index;
    task.map_path = map.string();
    task.preset = "default";
    task.options = few_particles();
    task.run = file;
    task.threads = 1;
    return task;
  }

 private:
  SmallWorld() {
    const auto demand = [](const auto& outcome) {
      if (!outcome) throw std::runtime_error(outcome.error().message);
    };
    const OverheadMap street = street_map(0.2);
    demand(write_overhead_map(street, {"street", "made for a test", "CC0-1.0", ""}, std::nullopt,
                              map));
    SimulationOptions options;
    options.image_width_px = 64;
    options.image_height_px = 48;
    options.has_colour = false;
    const Route route{.name = "short",
                      .waypoints_in_enu_m = {{15.0, 28.0}, {42.0, 28.0}, {42.0, 40.0}}};
    const FlownPath path{"short", plan_flight(route, 1).value(), std::nullopt, 4.0};
    {
      const ThreadLimit one_thread(1);  // ThreadSanitizer takes OpenCV's own statics for races
      demand(simulate_flight(street, path, options, flight, {}));
    }
    recording = open_flight(flight).value();
    index = std::make_shared<const MapIndex>(std::make_shared<const OverheadMap>(street));
    demand(rerun(task(run), {}, [](RerunProgress) {}));
  }
};

/// Runs a disabled test of this program in a process of its own, for what ends by SIGKILL. That process finds the folder in
/// its environment; a fork alone would not do, for threads do not come along.
/// @returns the signal that ended it; 0: it ended by itself.
inline int killed_by_running(const std::string& test, const std::filesystem::path& folder) {
  const std::string filter = "--gtest_filter=" + test,
                    place = "NADIR_TEST_FOLDER=" + folder.string();
  const pid_t child = ::fork();
  if (child == 0) {
    std::vector<std::string> words = {"test", filter, "--gtest_also_run_disabled_tests"};
    std::vector<std::string> settings = {place};
    for (char** variable = environ; *variable != nullptr; ++variable)
      settings.emplace_back(*variable);
    const auto pointers = [](std::vector<std::string>& texts) {
      std::vector<char*> list;
      for (std::string& text : texts) list.push_back(text.data());
      list.push_back(nullptr);
      return list;
    };
    ::execve("/proc/self/exe", pointers(words).data(), pointers(settings).data());
    ::_exit(99);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? WTERMSIG(status) : 0;
}

/// The folder of a test that is run in a process of its own; empty: it is not.
inline std::filesystem::path folder_of_this_process() {
  const char* folder =
      std::getenv("NADIR_TEST_FOLDER");  // NOLINT(concurrency-mt-unsafe): tests set no variables
  return folder == nullptr ? std::filesystem::path() : std::filesystem::path(folder);
}

/// Where a session keeps its things in a folder.
[[nodiscard]] inline SessionPlaces places_in(const std::filesystem::path& folder) {
  return {folder / "config", folder / "data", SmallWorld::get().map, {}};
}

/// Polls until something is so.
template <typename Condition>
void poll_until(Session& session, const Condition& is_so) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
  while (!is_so() && std::chrono::steady_clock::now() < end) {
    session.poll(0.05);
    std::this_thread::yield();
  }
  EXPECT_TRUE(is_so()) << "it takes for ever";
}

/// A run that takes so long that it can be watched.
inline void ask_for_a_slow_run(Session& session) {
  for (const char* words : {"option particles 200000", "option global-particles 200000",
                            "option min-particles 200000", "option adapt-particles false"}) {
    const auto done = session.apply(*parse_action(words));
    ASSERT_TRUE(done) << words << ": " << error_text(done);
  }
}

/// A session in folders of its own.
class SessionTest : public testing::Test {
 protected:
  using fs_path = std::filesystem::path;

  SessionTest() {
    std::filesystem::copy_file(SmallWorld::get().run, run_);
    start();
  }

  [[nodiscard]] SessionPlaces places() const { return places_in(scratch_.path()); }
  /// Ends the session, as closing the window does, and begins another one.
  void start() {
    session_.reset();
    session_ = std::make_unique<Session>(places());
  }

  /// The same, which opens what was open.
  void restart() {
    start();
    session_->restore();
    settle();
  }
  [[nodiscard]] fs_path session_file() const { return scratch_.path() / "config" / "session.toml"; }
  [[nodiscard]] fs_path preferences_file() const {
    return scratch_.path() / "config" / "preferences.toml";
  }

  /// Does what must work.
  void act(const std::string& words) {
    const auto action = parse_action(words);
    ASSERT_TRUE(action) << action.error().message;
    const auto done = session_->apply(*action);
    ASSERT_TRUE(done) << words << ": " << done.error().message;
  }
  /// Why something does not work; the view is then as it was.
  std::string refused(const std::string& words) {
    const auto action = parse_action(words);
    if (!action) return "(no action) " + action.error().message;
    const ViewState before = session_->view();
    const Playback playback = session_->playback();
    const auto done = session_->apply(*action);
    EXPECT_EQ(session_->view(), before) << words;
    EXPECT_EQ(session_->playback(), playback) << words;
    if (done) return "(no error)";
    EXPECT_FALSE(session_->notices().empty());
    if (!session_->notices().empty()) {
      EXPECT_EQ(session_->notices().back().text, done.error().message);
      EXPECT_EQ(session_->notices().back().kind, Notice::Kind::kError);
    }
    return done.error().message;
  }
  /// The next run is made in a moment.
  void ask_for_a_quick_run() {
    act("option particles 300");
    act("option min-particles 300");
    act("option max-cells 50");
  }
  /// Waits until all that was begun is done.
  void settle() {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    do {
      session_->poll(0.02);
      std::this_thread::yield();
      ASSERT_LT(std::chrono::steady_clock::now(), end) << "it takes for ever";
    } while (session_->is_busy() && !session_->playback().is_playing);
    session_->poll(0.0);
  }
  void open_run() {
    act("open " + run_.string());
    settle();
    ASSERT_NE(session_->active_run(), nullptr);
    ASSERT_NE(session_->active_run()->document, nullptr);
    ASSERT_NE(session_->map(), nullptr);
    ASSERT_NE(session_->map()->index, nullptr);
  }
  /// The words that open a file or folder.
  static std::string open(const fs_path& path) { return "open \"" + path.string() + "\""; }
  [[nodiscard]] std::vector<std::string> run_names() const {
    std::vector<std::string> names;
    for (const OpenRun& run : session_->runs()) names.push_back(run.name);
    return names;
  }
  /// Another copy of the run beside the first.
  fs_path copy_run(const std::string& name) {
    const fs_path copy = scratch_.path() / name;
    std::filesystem::copy_file(run_, copy);
    return copy;
  }
  [[nodiscard]] const RunDocument& document() const { return *session_->active_run()->document; }
  [[nodiscard]] std::vector<std::string> notice_texts() const {
    std::vector<std::string> texts;
    for (const Notice& notice : session_->notices()) texts.push_back(notice.text);
    return texts;
  }

  ScratchFolder scratch_;
  fs_path run_ = scratch_.path() / "loop.nadir";
  std::unique_ptr<Session> session_;
};

}  // namespace nadir
