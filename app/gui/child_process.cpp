// SPDX-License-Identifier: Apache-2.0
#include "app/gui/child_process.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <system_error>
#include <thread>

extern char** environ;  // NOLINT(readability-identifier-naming): POSIX names it

namespace nadir {
namespace {

std::string words_of(int error) { return std::generic_category().message(error); }

/// The environment of this process with some variables set.
std::vector<std::string> environment_with(
    const std::vector<std::pair<std::string, std::string>>& variables) {
  std::vector<std::string> lines;
  for (char** line = environ; *line != nullptr; ++line) {
    const std::string text = *line;
    bool is_replaced = false;
    for (const auto& [name, value] : variables)
      is_replaced |= text.rfind(fmt::format("{}=", name), 0) == 0;
    if (!is_replaced) lines.push_back(text);
  }
  for (const auto& [name, value] : variables) lines.push_back(fmt::format("{}={}", name, value));
  return lines;
}

std::vector<char*> pointers_to(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

}  // namespace

Result<ChildProcess> ChildProcess::start(
    const std::filesystem::path& program,
    const std::vector<std::string>& arguments,
    const std::vector<std::pair<std::string, std::string>>& variables) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) {
    return fail(ErrorCode::kIo, "{}: cannot be started: {}", program.string(), words_of(errno));
  }
  ::fcntl(ends[0], F_SETFL, O_NONBLOCK);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&files, ends[1], STDERR_FILENO);
  std::vector<std::string> words = {program.string()};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> environment = environment_with(variables);
  pid_t process = 0;
  const int failed = ::posix_spawn(&process, program.c_str(), &files, nullptr,
                                   pointers_to(words).data(), pointers_to(environment).data());
  posix_spawn_file_actions_destroy(&files);
  ::close(ends[1]);
  if (failed != 0) {
    ::close(ends[0]);
    return fail(ErrorCode::kIo, "{}: cannot be started: {}", program.string(), words_of(failed));
  }
  return ChildProcess(process, ends[0]);
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept
    : process_(std::exchange(other.process_, 0)),
      pipe_(std::exchange(other.pipe_, -1)),
      status_(other.status_),
      was_asked_(other.was_asked_),
      rest_(std::move(other.rest_)),
      lines_(std::move(other.lines_)) {}

ChildProcess::~ChildProcess() {
  using namespace std::chrono_literals;
  if (process_ != 0) {
    ask_to_stop();
    for (const auto until = std::chrono::steady_clock::now() + 2s;
         !poll() && std::chrono::steady_clock::now() < until;) {
      std::this_thread::sleep_for(5ms);
    }
    if (process_ != 0) {
      ::kill(process_, SIGKILL);
      ::waitpid(process_, nullptr, 0);
    }
  }
  if (pipe_ >= 0) ::close(pipe_);
}

void ChildProcess::read() {
  if (pipe_ < 0) return;
  std::array<char, 4096> part{};
  for (ssize_t got = 0; (got = ::read(pipe_, part.data(), part.size())) > 0;) {
    rest_.append(part.data(), static_cast<std::size_t>(got));
  }
  for (std::size_t end = 0; (end = rest_.find('\n')) != std::string::npos;) {
    lines_.push_back(rest_.substr(0, end));
    rest_.erase(0, end + 1);
  }
}

std::optional<int> ChildProcess::poll() {
  read();
  if (process_ == 0) return status_;
  int status = 0;
  const pid_t over = ::waitpid(process_, &status, WNOHANG);
  if (over == 0 || (over < 0 && errno == EINTR)) return std::nullopt;
  read();  // what came between the first look and its end
  if (!rest_.empty()) lines_.push_back(std::exchange(rest_, {}));
  process_ = 0;
  constexpr int kNotOurs = 127;
  if (over < 0) {
    status_ = kNotOurs;
  } else {
    status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  }
  return status_;
}

void ChildProcess::ask_to_stop() {
  if (process_ != 0 && !was_asked_) ::kill(process_, SIGTERM);
  was_asked_ = true;
}

std::filesystem::path own_program() {
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

}  // namespace nadir
