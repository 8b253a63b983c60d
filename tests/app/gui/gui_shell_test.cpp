// SPDX-License-Identifier: Apache-2.0
#include "app/gui/gui_shell.h"

#include <gmock/gmock.h>

#include "tests/core/session/session_fixture.h"

namespace nadir {
namespace gui_shell_test {

/// A shell with the small world's run, of which no frame is drawn.
struct UnseenShell {
  UnseenShell() {
    GuiRequest request;
    request.files = {SmallWorld::get().run.string()};
    request.places = places_in(folder.path());
    request.restores = false;
    shell = std::make_unique<GuiShell>(request, [](const std::string&) {});
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(120);
    while (!is_read() && std::chrono::steady_clock::now() < end) {
      shell->poll(0.0);
      std::this_thread::yield();
    }
    EXPECT_TRUE(is_read());
  }
  [[nodiscard]] bool is_read() const {
    const OpenRun* const run = shell->session().active_run();
    return run != nullptr && run->document != nullptr;
  }
  ScratchFolder folder;
  std::unique_ptr<GuiShell> shell;
};

TEST(GuiShell, GoesOnPlayingWhileNobodySeesItButMakesUpForNoSleep) {
  const UnseenShell unseen;
  Session& session = unseen.shell->session();
  ASSERT_TRUE(session.apply(actions::Seek{0.0}));
  ASSERT_TRUE(session.apply(actions::SetSpeed{1.0}));
  ASSERT_TRUE(session.apply(actions::Play{Switch::kOn}));
  EXPECT_TRUE(unseen.shell->is_moving());
  unseen.shell->poll(0.25);
  EXPECT_NEAR(session.playback().time_s, 0.25, 1e-9);
  unseen.shell->poll(3600.0);  // the machine slept
  EXPECT_NEAR(session.playback().time_s, 1.25, 1e-9);
}

TEST(GuiShell, IsClosedWhileNobodySeesIt) {
  const UnseenShell unseen;
  EXPECT_FALSE(unseen.shell->wants_to_quit());
  ASSERT_TRUE(unseen.shell->session().apply(actions::Quit{}));
  for (int i = 0; i < 3; ++i) unseen.shell->poll(0.1);
  EXPECT_TRUE(unseen.shell->wants_to_quit());
}

TEST(GuiShell, RestsWhereNothingMoves) {
  const UnseenShell unseen;
  EXPECT_FALSE(unseen.shell->is_moving()) << "only work in the background may go on";
}

}  // namespace gui_shell_test
}  // namespace nadir
