// SPDX-License-Identifier: Apache-2.0
#include "app/cli/console.h"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdlib>
#include <ctime>
#include <string_view>
#include <thread>

namespace nadir::cli {
namespace {

bool are_lines_wanted() {
  const char* const wanted =
      std::getenv("NADIR_PROGRESS");  // NOLINT(concurrency-mt-unsafe): nobody sets any
  return wanted != nullptr && std::string_view(wanted) == "lines";
}

}  // namespace

std::string progress_line(const ProgressShare& share,
                          double fraction,
                          const std::string& activity) {
  return fmt::format("progress {:.4f} {}", share.from + (share.to - share.from) * fraction,
                     activity);
}

ProgressBar::ProgressBar(std::ostream& err, bool is_quiet, const ProgressShare& share)
    : err_(err),
      is_shown_(!is_quiet && ::isatty(STDERR_FILENO) == 1),
      writes_lines_(!is_quiet && are_lines_wanted()),
      share_(share),
      began_(std::chrono::steady_clock::now()) {}

ProgressBar::~ProgressBar() {
  if (is_shown_ && !writes_lines_) err_ << "\r\x1b[K" << std::flush;
}

void ProgressBar::show(double fraction, const std::string& activity) {
  using std::chrono::duration;
  constexpr int kWidth = 30;
  constexpr double kRedrawAfterS = 0.1;
  if (!is_shown_ && !writes_lines_) return;
  const auto now = std::chrono::steady_clock::now();
  if (activity != activity_) {
    activity_ = activity;
    began_ = now;
  } else if (duration<double>(now - drawn_).count() < kRedrawAfterS && fraction < 1.0) {
    return;
  }
  drawn_ = now;
  if (writes_lines_) {
    err_ << progress_line(share_, fraction, activity) << '\n' << std::flush;
    return;
  }
  const auto filled = static_cast<std::size_t>(fraction * kWidth);
  const double elapsed_s = duration<double>(now - began_).count();
  const std::string left =
      fraction > 0.01 ? fmt::format(", {:.0f} s left", elapsed_s * (1.0 - fraction) / fraction)
                      : "";
  err_ << fmt::format("\r\x1b[K{} [{}{}] {:3.0f} %{}", activity, std::string(filled, '='),
                      std::string(kWidth - filled, ' '), 100.0 * fraction, left)
       << std::flush;
}

namespace {

sigset_t interrupting_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  return signals;
}

/// Waits for the signals, which every other thread blocks, so that no handler runs inside arbitrary
/// code.
void wait_for_signals(const std::stop_token& end, const std::stop_source& work) {
  constexpr timespec kPoll = {0, 100'000'000};
  const sigset_t signals = interrupting_signals();
  while (!end.stop_requested()) {
    const int signal = sigtimedwait(&signals, nullptr, &kPoll);
    if (signal <= 0) continue;
    if (work.stop_requested()) ::_exit(128 + signal);
    work.request_stop();
  }
}

}  // namespace

struct Interrupt::Implementation {
  sigset_t mask_before{};
  std::stop_source work;
  std::jthread watcher;
};

Interrupt::Interrupt() : implementation_(std::make_unique<Implementation>()) {
  const sigset_t signals = interrupting_signals();
  pthread_sigmask(SIG_BLOCK, &signals, &implementation_->mask_before);
  implementation_->watcher = std::jthread(
      [work = implementation_->work](const std::stop_token& end) { wait_for_signals(end, work); });
}

Interrupt::~Interrupt() {
  implementation_->watcher.request_stop();
  implementation_->watcher.join();
  pthread_sigmask(SIG_SETMASK, &implementation_->mask_before, nullptr);
}

std::stop_token Interrupt::token() const { return implementation_->work.get_token(); }

}  // namespace nadir::cli
