// SPDX-License-Identifier: Apache-2.0
#include "app/gui/gui_shell.h"

#include <algorithm>
#include <mutex>
#include <utility>

#include "core/base/log.h"

namespace nadir {

/// Collects what libraries write to the log, from any thread, until the next frame tells the session.
class GuiShell::LogTap {
 public:
  LogTap() : lines_(std::make_shared<Lines>()) {
    before_ = set_log_sink([lines = lines_](LogLevel level, const std::string& line) {
      const std::lock_guard lock(lines->mutex);
      lines->said.emplace_back(level, line);
    });
  }
  ~LogTap() { set_log_sink(before_); }
  LogTap(const LogTap&) = delete;
  LogTap& operator=(const LogTap&) = delete;

  /// @param told  Takes the numbers of the notices that come of it.
  void tell(Session& session, std::set<int>& told) {
    std::vector<std::pair<LogLevel, std::string>> said;
    {
      const std::lock_guard lock(lines_->mutex);
      said.swap(lines_->said);
    }
    for (const auto& [level, line] : said) {
      session.notify(level == LogLevel::kError ? Notice::Kind::kError : Notice::Kind::kWarning,
                     line);
      if (!session.notices().empty()) told.insert(session.notices().back().number);
    }
  }

 private:
  struct Lines {
    std::mutex mutex;
    std::vector<std::pair<LogLevel, std::string>> said;
  };
  std::shared_ptr<Lines> lines_;
  LogSink before_;
};

GuiShell::GuiShell(const GuiRequest& request, std::function<void(const std::string&)> clipboard)
    : asked_scale_(request.scale),
      session_(request.places),
      effects_(request.program, std::move(clipboard)),
      window_(session_),
      log_(std::make_unique<LogTap>()) {
  if (request.restores && request.files.empty() && request.labels.empty()) session_.restore();
  for (const std::string& file : request.files) session_.apply(actions::OpenFile{file});
  if (!request.labels.empty()) session_.apply(actions::OpenLabels{request.labels});
}

GuiShell::~GuiShell() = default;

std::vector<Error> GuiShell::failures() const {
  std::vector<Error> failures;
  for (const Notice& notice : session_.notices()) {
    if (notice.kind != Notice::Kind::kError || said_by_libraries_.contains(notice.number)) continue;
    failures.push_back({ErrorCode::kIo, notice.text});
  }
  return failures;
}

void GuiShell::poll(double elapsed_s) {
  constexpr double kLongestS = 1.0;  // of a machine that slept playback does not make up for
  log_->tell(session_, said_by_libraries_);
  effects_.poll(session_);
  session_.poll(std::min(elapsed_s, kLongestS));
}

void GuiShell::frame(kit::Ui& ui, double elapsed_s) {
  poll(elapsed_s);
  if (is_first_frame_) ui.set_turned_sections(session_.turned_sections());
  is_first_frame_ = false;
  window_.frame(ui, elapsed_s);
  session_.keep_turned_sections(ui.turned_sections());
}

bool GuiShell::is_busy() const {
  return session_.is_busy() || effects_.is_busy() || window_.is_working() || window_.wants_more();
}

bool GuiShell::is_moving() const { return session_.playback().is_playing || window_.wants_more(); }

ThemeName GuiShell::theme_name() const {
  return session_.view().appearance.theme == LightOrDark::kLight ? ThemeName::kLight
                                                                 : ThemeName::kDark;
}

double GuiShell::scale(double screen_scale) const {
  if (asked_scale_ > 0.0) return asked_scale_;
  const double chosen = session_.view().appearance.scale;
  return chosen > 0.0 ? chosen : screen_scale;
}

}  // namespace nadir
