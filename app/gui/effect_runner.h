// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/gui/child_process.h"
#include "core/session/session.h"

namespace nadir {

/// Does for a session what only a shell can do. Figures, reports and the demo are made by this program's own commands in
/// processes of their own: the window goes on drawing, and a fault there costs nothing here.
class EffectRunner {
 public:
  /// @param program   The program whose commands are run: own_program(), but in tests.
  /// @param clipboard Takes a text.
  EffectRunner(std::filesystem::path program, std::function<void(const std::string&)> clipboard);
  ~EffectRunner();  ///< Stops what still runs.
  EffectRunner(const EffectRunner&) = delete;
  EffectRunner& operator=(const EffectRunner&) = delete;

  /// Once a frame: begins what the session has asked for, tells it what is done and how far the rest is.
  void poll(Session& session);
  [[nodiscard]] bool is_busy() const { return !works_.empty(); }
  /// Whether the session has asked to leave.
  [[nodiscard]] bool wants_to_quit() const { return wants_to_quit_; }

 private:
  struct Work {
    int job = 0;
    ChildProcess process;
    std::string made;              ///< What to open or show when it is done.
    std::filesystem::path recipe;  ///< To be taken away afterwards; may be empty.
    std::size_t lines_read = 0;
  };
  void begin(Session& session, const Effect& effect);
  void begin(Session& session,
             int job,
             const std::vector<std::string>& arguments,
             std::string made,
             std::filesystem::path recipe = {});
  /// @returns whether it is over.
  bool follow(Session& session, Work& work);

  std::filesystem::path program_;
  std::function<void(const std::string&)> clipboard_;
  std::vector<Work> works_;
  bool wants_to_quit_ = false;
};

}  // namespace nadir
