// SPDX-License-Identifier: Apache-2.0
// The whole window in the hands of somebody without a plan: nothing breaks, nothing hangs, nothing is left behind.
#include <gmock/gmock.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <set>

#include "core/base/staged_output.h"
#include "tests/app/gui/fuzzed_window.h"
#include "tests/app/gui/session_truths.h"
#include "tests/app/gui/sure_actions.h"
#include "tests/core/session/session_fixture.h"
#include "tests/support/gl_objects.h"
#include "widgets/gl/offscreen_context.h"

namespace nadir {
namespace gui_fuzz_test {

namespace fs = std::filesystem;

constexpr double kMostFrameS = 1.0;  // sanitized as well, where the longest takes a third of it
constexpr int kRounds = 10;
constexpr int kActions = 300;

/// A user's files: a map, a flight and runs of it, and some that nothing can be done with.
class UserFiles {
 public:
  UserFiles() {
    const SmallWorld& world = SmallWorld::get();
    for (const char* const folder : {"work", "config", "data", "home", "tmp"}) {
      fs::create_directory(path(folder));
    }
    fs::copy(world.map, path("street"), fs::copy_options::recursive);
    fs::copy(world.map, path("labelled"), fs::copy_options::recursive);
    fs::copy(world.flight, path("flight"), fs::copy_options::recursive);
    fs::copy_file(world.run, path("loop.nadir"));
    fs::copy_file(world.run, path("other.nadir"));
    fs::copy_file(astray_run(), path("astray.nadir"));
    const std::string bytes = read_text_file(world.run).value();
    scratch_.file("cut.nadir", std::string_view(bytes).substr(0, bytes.size() / 2));
    std::string damaged = bytes;
    for (std::size_t i = damaged.size() / 3; i < damaged.size(); i += 997) {
      damaged[i] = static_cast<char>(damaged[i] ^ 0x55);
    }
    scratch_.file("damaged.nadir", damaged);
    scratch_.file("empty.nadir", "");
    scratch_.file("notes.txt", "nothing of ours\n");
    scratch_.file("few.toml", "preset = \"default\"\nparticles = 300\n");
    scratch_.file("wrong.toml", "preset = [\n");
    // Figures and reports are not drawn here; the demo is there at once.
    const fs::path program =
        scratch_.file("program", "#!/bin/sh\n[ \"$1\" = demo ] || exit 0\nmkdir -p \"$3\"\ncp '" +
                                     path("loop.nadir").string() + "' \"$3/run.nadir\"\n");
    fs::permissions(program, fs::perms::owner_all);
  }

  [[nodiscard]] fs::path path(const std::string& name) const { return scratch_.path() / name; }
  /// What may be opened, and what cannot.
  [[nodiscard]] std::vector<std::string> to_open() const {
    std::vector<std::string> paths;
    for (const char* const name :
         {"loop.nadir", "loop.nadir", "other.nadir", "other.nadir", "cut.nadir", "damaged.nadir",
          "empty.nadir", "missing.nadir", "street", "labelled", "flight", "flight/flight.toml",
          "notes.txt", "few.toml", "wrong.toml", "home", "work/made-3.toml"}) {
      paths.push_back(path(name).string());
    }
    return paths;
  }
  [[nodiscard]] GuiRequest request() const {
    GuiRequest request;
    request.files = {path("loop.nadir").string()};
    request.places = {path("config"),
                      path("data"),
                      path("street"),
                      {},
                      "ada",
                      [](const fs::path& figure) -> Result<std::string> {
                        return fail(ErrorCode::kMalformed, "{}: carries no recipe",
                                    figure.string());
                      }};
    request.places.resources = fs::path(NADIR_SOURCE_DIR) / "resources";
    request.program = path("program");
    request.width = 800;
    request.height = 500;
    return request;
  }
  /// Names of what lies in a folder, but for what fonts and graphics keep for the next program.
  [[nodiscard]] std::set<std::string> in(const std::string& folder) const {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(path(folder))) {
      names.insert(entry.path().filename().string());
    }
    names.erase(".cache");
    return names;
  }

 private:
  /// A run of the same flight that was told to start in another place; made once.
  static fs::path astray_run() {
    static const ScratchFolder folder;
    RerunTask task = SmallWorld::get().task(folder.path() / "astray.nadir");
    task.prior = GaussianPrior{{60.0, 50.0, 2.0}, 0.2, 0.05};
    const bool is_made = fs::exists(task.run) || rerun(task, {}, [](RerunProgress) {}).has_value();
    if (!is_made) throw std::runtime_error("no run could be made");
    return task.run;
  }

  ScratchFolder scratch_;
};

/// Makes a folder the one that relative names mean, and others the user's own, as long as it lives.
class AtHome {
 public:
  explicit AtHome(const UserFiles& files) : before_(fs::current_path()) {
    fs::current_path(files.path("work"));
    set("HOME", files.path("home"));
    set("TMPDIR", files.path("tmp"));
  }
  ~AtHome() {
    std::error_code error;
    fs::current_path(before_, error);
    for (const auto& [name, value] : variables_) {
      if (value) {
        ::setenv(name.c_str(), value->c_str(), 1);
      } else {
        ::unsetenv(name.c_str());
      }
    }
  }
  AtHome(const AtHome&) = delete;
  AtHome& operator=(const AtHome&) = delete;

 private:
  void set(const std::string& name, const fs::path& value) {
    const char* const before = std::getenv(name.c_str());
    variables_.emplace_back(name,
                            before != nullptr ? std::optional<std::string>(before) : std::nullopt);
    ::setenv(name.c_str(), value.c_str(), 1);
  }
  fs::path before_;
  std::vector<std::pair<std::string, std::optional<std::string>>> variables_;
};

class GuiFuzz : public testing::TestWithParam<int> {
 protected:
  static void SetUpTestSuite() {
    const UserFiles
        files;  // what they share is made before the folder for temporary files is another one
  }
  void SetUp() override {
    auto context = OffscreenContext::create();
    if (!context) GTEST_SKIP() << context.error().message;
    context_ = std::move(*context);
  }
  /// Whether what is done at random succeeds depends on how far the work in the background has come. So each round ends with
  /// a part of all actions, asked for where they must succeed: all rounds together have then done everything.
  static void do_surely(FuzzedWindow& window, const UserFiles& files, int round) {
    const auto all =
        sure_actions(files.path("loop.nadir").string(), files.path("astray.nadir").string(),
                     files.path("labelled").string());
    window.act("play off");  // a loop has no end
    ASSERT_TRUE(window.settle(60.0));
    for (std::size_t i = static_cast<std::size_t>(round); i < all.size(); i += kRounds) {
      for (const std::string& line : all[i].before) {
        const std::size_t done = window.done().size();
        window.act(line);
        ASSERT_EQ(window.done().size(), done + 1) << all[i].name << ": " << window.last_refusal();
        ASSERT_TRUE(window.settle(60.0)) << all[i].name << ", after " << line;
      }
      const std::size_t done = window.done().size();
      window.act_at_once(all[i].then);
      ASSERT_EQ(window.done().size(), done + all[i].then.size()) << window.last_refusal();
      EXPECT_EQ(window.done().back(), all[i].name);
      window.act("play off");
      ASSERT_TRUE(window.settle(60.0)) << all[i].name;
      EXPECT_EQ(fault_of(window.session()), "") << all[i].name;
    }
  }
  static inline std::set<std::string> done_;
  static inline int rounds_done_ = 0;
  std::unique_ptr<OffscreenContext> context_;
};

TEST_P(GuiFuzz, NothingBreaksHangsOrIsLeftBehind) {
  const UserFiles files;
  const AtHome at_home(files);
  const int seed = GetParam();
  const fs::path trail = fs::path(NADIR_TRAILS) / ("gui-fuzz-" + std::to_string(seed) + ".txt");
  fs::create_directories(trail.parent_path());
  const std::string told = "round " + std::to_string(seed) + ", see " + trail.string();
  FuzzWords words(1000U + static_cast<unsigned>(seed), files.to_open());
  const GlObjects before = count_gl_objects();
  {
    FuzzedWindow window(files.request(), trail);
    ASSERT_TRUE(window.settle(60.0)) << told;
    window.act("option particles 300");
    for (int i = 0; i < kActions; ++i) {
      std::string fault;
      try {
        fault = window.do_something(words);
      } catch (const std::exception& error) {
        fault = std::string("thrown: ") + error.what();
      }
      ASSERT_EQ(fault, "") << told << ", action " << i;
      ASSERT_LE(window.longest_frame_s(), kMostFrameS) << told << ", action " << i;
    }
    do_surely(window, files, seed);
    if (HasFatalFailure()) return;
    ASSERT_LE(window.longest_frame_s(), kMostFrameS) << told;
    done_.insert(window.done().begin(), window.done().end());
    RecordProperty("longest_frame_ms", static_cast<int>(1000.0 * window.longest_frame_s()));
  }
  EXPECT_EQ(count_gl_objects(), before) << told;
  EXPECT_THAT(files.in("home"), testing::IsEmpty()) << told;
  EXPECT_THAT(files.in("tmp"), testing::IsEmpty()) << told;
  if (!HasFailure()) fs::remove(trail);
  if (++rounds_done_ < kRounds) return;
  for (const ActionHelp& help : action_helps()) {
    EXPECT_TRUE(done_.count(std::string(help.name))) << help.name << " was never done";
  }
}

INSTANTIATE_TEST_SUITE_P(Rounds, GuiFuzz, testing::Range(0, kRounds));

TEST(GuiGraphics, OpeningAndClosingAgainAndAgainKeepsNothing) {
  auto context = OffscreenContext::create();
  if (!context) GTEST_SKIP() << context.error().message;
  const UserFiles files;
  GuiRequest request = files.request();
  request.files.clear();
  FuzzedWindow window(std::move(request), files.path("trail.txt"));
  const auto look_at_everything = [&] {
    for (const char* const run : {"loop.nadir", "other.nadir"}) {
      window.act("open " + files.path(run).string());
      ASSERT_TRUE(window.settle(60.0));
      for (const std::string_view panel : EnumNames<Panel>::kNames) {
        window.act("panel " + std::string(panel) + " on");
        ASSERT_TRUE(window.settle(60.0));
      }
    }
    window.act("split-view on");
    ASSERT_TRUE(window.settle(60.0));
    window.act("close-run 2");
    window.act("close-run 1");
    window.draw(60);
  };
  look_at_everything();
  const GlObjects once = count_gl_objects();
  for (int i = 0; i < 3; ++i) look_at_everything();
  EXPECT_EQ(count_gl_objects(), once);
}

TEST(SureActions, AreAllThatThereAre) {
  std::vector<std::string_view> names, sure;
  for (const ActionHelp& help : action_helps()) names.push_back(help.name);
  for (const SureAction& action : sure_actions("/a.nadir", "/b.nadir", "/map")) {
    sure.push_back(action.name);
    const auto parsed = parse_action(action.then.back());
    ASSERT_TRUE(parsed) << action.name;
    EXPECT_EQ(action_name(*parsed), action.name);
  }
  EXPECT_EQ(sure, names);
}

TEST(FuzzWords, SpeakOfEveryActionInWordsThatCanBeDone) {
  FuzzWords words(7, {"/a.nadir"});
  for (const ActionHelp& help : action_helps()) {
    int parsed = 0;
    for (int i = 0; i < 200; ++i) parsed += parse_action(words.action_of(help)).has_value();
    EXPECT_GE(parsed, 60) << help.name;
  }
}

TEST(FuzzWords, AreTheSameForTheSameSeed) {
  FuzzWords some(7, {"/a.nadir"}), same(7, {"/a.nadir"}), others(8, {"/a.nadir"});
  std::string of_some, of_same, of_others;
  for (int i = 0; i < 50; ++i) {
    of_some += some.action() + some.text();
    of_same += same.action() + same.text();
    of_others += others.action() + others.text();
  }
  EXPECT_EQ(of_some, of_same);
  EXPECT_NE(of_some, of_others);
}

}  // namespace gui_fuzz_test
}  // namespace nadir
