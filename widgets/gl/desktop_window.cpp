// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/desktop_window.h"

#include <vtk_glew.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <cstdlib>
#include <utility>

#include "core/base/log.h"
#include "core/base/require.h"
#include "widgets/gl/vtk_messages.h"

namespace nadir {
namespace {

bool is_named(const char* variable) {
  const char* value = std::getenv(variable);  // NOLINT(concurrency-mt-unsafe): nobody sets any
  return value != nullptr && *value != '\0';
}

/// What GLFW says of the last failure, and forgets by that.
std::string complaint() {
  const char* text = nullptr;
  if (glfwGetError(&text) == GLFW_NO_ERROR || text == nullptr) return "no reason given";
  return text;
}

void tell(int /*code*/, const char* text) {
  write_log(LogLevel::kWarning, std::string("GLFW: ") + text);
}

}  // namespace

/// GLFW itself, one for all windows. It is ended with the last of them.
class DesktopWindow::Library {
 public:
  Library() = default;
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() { glfwTerminate(); }

  /// @errors kUnsupported.
  static Result<std::shared_ptr<Library>> get() {
    // GLFW knows only one of itself a process, so this is remembered by the process too.
    static std::weak_ptr<Library> shared;
    if (auto there = shared.lock()) return there;
    if (!is_named("WAYLAND_DISPLAY") && !is_named("DISPLAY")) {
      return fail(
          ErrorCode::kUnsupported,
          "no display: neither WAYLAND_DISPLAY nor DISPLAY is set; figures and reports need none");
    }
    if (glfwInit() != GLFW_TRUE) {
      return fail(ErrorCode::kUnsupported,
                  "no display: none can be opened ({}); figures and reports need none",
                  complaint());
    }
    auto made = std::make_shared<Library>();
    shared = made;
    return made;
  }
};

Result<std::unique_ptr<DesktopWindow>> DesktopWindow::create(const std::string& title,
                                                             int width,
                                                             int height) {
  NADIR_REQUIRE(width > 0 && height > 0);
  send_vtk_messages_to_log();
  auto library = Library::get();
  if (!library) return forward_error(library);
  glfwDefaultWindowHints();
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
  // VTK and the widgets draw into frame buffers of their own: the window needs colours only.
  glfwWindowHint(GLFW_DEPTH_BITS, 0);
  glfwWindowHint(GLFW_STENCIL_BITS, 0);
  glfwSetErrorCallback(nullptr);  // what fails here is returned
  GLFWwindow* const window = glfwCreateWindow(width, height, title.c_str(), nullptr, nullptr);
  const std::string said = window == nullptr ? complaint() : std::string();
  glfwSetErrorCallback(tell);
  if (window == nullptr) {
    return fail(ErrorCode::kUnsupported, "the display gives no window with OpenGL 3.3 ({})", said);
  }
  std::unique_ptr<DesktopWindow> made(new DesktopWindow(std::move(*library), window));
  made->make_current();
  // Where there is no GLX it complains after having loaded the entry points.
  const GLenum loaded = glewInit();
  if (loaded != GLEW_OK && loaded != GLEW_ERROR_NO_GLX_DISPLAY) {
    return fail(ErrorCode::kUnsupported, "the display gives no window with OpenGL 3.3 ({})",
                reinterpret_cast<const char*>(glewGetErrorString(loaded)));
  }
  glfwSwapInterval(1);
  return made;
}

DesktopWindow::DesktopWindow(std::shared_ptr<Library> library, GLFWwindow* window)
    : library_(std::move(library)), window_(window) {
  glfwSetWindowUserPointer(window_, this);
  listen();
}

/// GLFW calls back while events are polled, which is when they are told in their order; later it knows only how things stand.
void DesktopWindow::listen() {
  using Kind = WindowEvent::Kind;
  glfwSetCursorPosCallback(window_, [](GLFWwindow* target, double x, double y) {
    of(target).events_.push_back({Kind::kMouse, 0, true, {x, y}});
  });
  glfwSetCursorEnterCallback(window_, [](GLFWwindow* target, int is_inside) {
    if (is_inside == GLFW_FALSE) of(target).events_.push_back({Kind::kMouse, 0, false, {0.0, 0.0}});
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* target, int button, int action, int) {
    of(target).events_.push_back({Kind::kButton, button, action == GLFW_PRESS, {0.0, 0.0}});
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* target, double right, double away) {
    of(target).events_.push_back({Kind::kWheel, 0, false, {right, away}});
  });
  glfwSetKeyCallback(window_, [](GLFWwindow* target, int key, int, int action, int) {
    if (key == GLFW_KEY_UNKNOWN || action == GLFW_REPEAT) return;
    of(target).events_.push_back({Kind::kKey, key, action == GLFW_PRESS, {0.0, 0.0}});
  });
  glfwSetCharCallback(window_, [](GLFWwindow* target, unsigned int character) {
    of(target).events_.push_back({Kind::kCharacter, static_cast<int>(character), true, {0.0, 0.0}});
  });
  glfwSetDropCallback(window_, [](GLFWwindow* target, int count, const char** paths) {
    auto& dropped = of(target).dropped_;
    dropped.insert(dropped.end(), paths, paths + count);
  });
}

DesktopWindow& DesktopWindow::of(GLFWwindow* window) {
  return *static_cast<DesktopWindow*>(glfwGetWindowUserPointer(window));
}

DesktopWindow::~DesktopWindow() { glfwDestroyWindow(window_); }

GLFWwindow* DesktopWindow::handle() const { return window_; }
void DesktopWindow::make_current() { glfwMakeContextCurrent(window_); }
void DesktopWindow::clear(Rgba ground) {
  constexpr float kFull = 255.0F;
  const Eigen::Vector2i size = framebuffer_size();
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, size.x(), size.y());
  glDisable(GL_SCISSOR_TEST);
  glClearColor(static_cast<float>(ground.red) / kFull, static_cast<float>(ground.green) / kFull,
               static_cast<float>(ground.blue) / kFull, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
}
void DesktopWindow::swap() { glfwSwapBuffers(window_); }
void DesktopWindow::poll_events() { glfwPollEvents(); }
void DesktopWindow::wait_events(double at_most_s) { glfwWaitEventsTimeout(at_most_s); }
void DesktopWindow::set_title(const std::string& title) {
  glfwSetWindowTitle(window_, title.c_str());
}
bool DesktopWindow::should_close() const { return glfwWindowShouldClose(window_) == GLFW_TRUE; }

void DesktopWindow::set_should_close(bool should_close) {
  glfwSetWindowShouldClose(window_, should_close ? GLFW_TRUE : GLFW_FALSE);
}

bool DesktopWindow::is_minimised() const {
  // Some desktops make it empty, others only say so.
  return glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE ||
         framebuffer_size().minCoeff() <= 0;
}

Eigen::Vector2i DesktopWindow::framebuffer_size() const {
  Eigen::Vector2i size = Eigen::Vector2i::Zero();
  glfwGetFramebufferSize(window_, &size.x(), &size.y());
  return size;
}

std::vector<WindowEvent> DesktopWindow::take_events() { return std::exchange(events_, {}); }

std::vector<std::filesystem::path> DesktopWindow::take_dropped_files() {
  return std::exchange(dropped_, {});
}

double DesktopWindow::content_scale() const {
  float across = 1.0F;
  glfwGetWindowContentScale(window_, &across, nullptr);
  return across;
}

}  // namespace nadir
