// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/vtk_messages.h"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <mutex>
#include <regex>

#include "core/base/log.h"

namespace nadir {
namespace {

/// VTK's door for messages. The text goes to the log; nothing is shown.
class LogOutputWindow : public vtkOutputWindow {
 public:
  static LogOutputWindow* New() { VTK_STANDARD_NEW_BODY(LogOutputWindow); }

  void DisplayErrorText(const char* text) override { tell(LogLevel::kError, text); }
  void DisplayWarningText(const char* text) override { tell(LogLevel::kWarning, text); }
  void DisplayGenericWarningText(const char* text) override { tell(LogLevel::kWarning, text); }
  void DisplayText(const char* text) override { tell(LogLevel::kWarning, text); }
  // Only who debugs VTK turns these on.
  void DisplayDebugText(const char* text) override { tell(LogLevel::kWarning, text); }

 protected:
  LogOutputWindow() = default;

 private:
  static void tell(LogLevel level, const char* text) {
    if (text != nullptr) write_log(level, "VTK: " + plain_vtk_message(text));
  }
};

}  // namespace

std::string plain_vtk_message(const std::string& message) {
  // Shaders of hundreds of lines come along with some messages; the beginning tells, and std::regex is slow.
  constexpr std::size_t kEnough = 2'000;
  static const std::regex place(R"(^\s*[A-Za-z ]*: In [^\n]*, line \d+\s*)");
  static const std::regex address(R"( ?\(?0x[0-9a-fA-F]+\)?)");
  const std::string without_place = std::regex_replace(message.substr(0, kEnough), place, "",
                                                       std::regex_constants::format_first_only);
  std::string plain = std::regex_replace(without_place, address, "");
  plain.erase(plain.find_last_not_of(" \n\r\t") + 1);
  return plain;
}

void send_vtk_messages_to_log() {
  static std::once_flag done;
  std::call_once(done, [] {
    // VTK writes each message a second time, by its logger.
    vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
    const vtkNew<LogOutputWindow> window;
    vtkOutputWindow::SetInstance(window);
  });
}

}  // namespace nadir
