// SPDX-License-Identifier: Apache-2.0
#include "widgets/gl/offscreen_context.h"

#define EGL_NO_X11  // EGL's headers include Xlib otherwise, whose macros are called None and Status
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <array>
#include <vector>

#include "core/base/require.h"

namespace nadir {

struct OffscreenContext::Implementation {
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
  std::string kind;

  Implementation() = default;
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;
  ~Implementation() {
    // The display stays initialised: EGL hands the same one to whoever asks for it again.
    if (context == EGL_NO_CONTEXT) return;
    if (eglGetCurrentContext() == context) {
      eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    }
    eglDestroyContext(display, context);
  }
};

namespace {

template <class Function>
Function extension(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// A context on the display, current; else an empty string's opposite: what went wrong.
std::string start(EGLDisplay display, EGLContext& context) {
  if (display == EGL_NO_DISPLAY) return "no such display";
  EGLint major = 0;
  EGLint minor = 0;
  if (eglInitialize(display, &major, &minor) != EGL_TRUE) return "cannot be initialised";
  if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) return "has no OpenGL";
  constexpr std::array<EGLint, 5> kConfig = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE,
                                             EGL_OPENGL_BIT, EGL_NONE};
  constexpr std::array<EGLint, 7> kVersion = {EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglChooseConfig(display, kConfig.data(), &config, 1, &count) != EGL_TRUE || count == 0) {
    return "has no fitting configuration";
  }
  context = eglCreateContext(display, config, EGL_NO_CONTEXT, kVersion.data());
  if (context == EGL_NO_CONTEXT) return "has no OpenGL 3.3";
  if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context) != EGL_TRUE) {
    eglDestroyContext(display, context);
    context = EGL_NO_CONTEXT;
    return "needs a surface";
  }
  return {};
}

struct Candidate {
  std::string name;
  EGLDisplay display = EGL_NO_DISPLAY;
};

std::vector<Candidate> candidates() {
  std::vector<Candidate> found;
  const auto display_of = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  if (display_of == nullptr) return found;
  const auto query_devices = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto query_name = extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  std::array<EGLDeviceEXT, 16> devices{};
  EGLint count = 0;
  if (query_devices != nullptr && query_name != nullptr &&
      query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count) == EGL_TRUE) {
    for (EGLint i = 0; i < count; ++i) {
      EGLDeviceEXT const device = devices.at(static_cast<std::size_t>(i));
      // Mesa lists its software renderer as a device too; the surfaceless platform is the same with less ado.
      const char* extensions = query_name(device, EGL_EXTENSIONS);
      if (extensions != nullptr &&
          std::string(extensions).find("EGL_MESA_device_software") != std::string::npos) {
        continue;
      }
      found.push_back(
          {fmt::format("EGL device {}", i), display_of(EGL_PLATFORM_DEVICE_EXT, device, nullptr)});
    }
  }
  found.push_back(
      {"EGL surfaceless", display_of(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)});
  return found;
}

}  // namespace

Result<std::unique_ptr<OffscreenContext>> OffscreenContext::create() {
  std::string complaints;
  for (const Candidate& candidate : candidates()) {
    auto made = std::make_unique<Implementation>();
    made->display = candidate.display;
    made->kind = candidate.name;
    const std::string complaint = start(candidate.display, made->context);
    if (complaint.empty()) {
      return std::unique_ptr<OffscreenContext>(new OffscreenContext(std::move(made)));
    }
    complaints += fmt::format("{}{} {}", complaints.empty() ? "" : ", ", candidate.name, complaint);
  }
  return fail(ErrorCode::kUnsupported,
              "OpenGL without a display is not to be had here ({}); Mesa's EGL driver draws "
              "without a graphics card",
              complaints.empty() ? "this EGL knows no platforms" : complaints);
}

OffscreenContext::OffscreenContext(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

OffscreenContext::~OffscreenContext() = default;

void OffscreenContext::make_current() {
  const bool is_current = eglMakeCurrent(implementation_->display, EGL_NO_SURFACE, EGL_NO_SURFACE,
                                         implementation_->context) == EGL_TRUE;
  NADIR_REQUIRE(is_current);
}

const std::string& OffscreenContext::kind() const { return implementation_->kind; }

}  // namespace nadir
