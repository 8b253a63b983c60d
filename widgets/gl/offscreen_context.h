// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "core/base/result.h"

namespace nadir {

/// An OpenGL 3.3 core context without a window or a display: drawing goes to frame buffers of one's own. One thread uses
/// it at a time.
class OffscreenContext {
 public:
  /// Asks EGL for a device of the machine first (a graphics card), then for Mesa's surfaceless platform (software); needs
  /// no X server and starts none. The new context is current on this thread.
  /// @errors kUnsupported, with what each way said.
  [[nodiscard]] static Result<std::unique_ptr<OffscreenContext>> create();

  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  void make_current();
  /// How the context was had, for the log: "EGL surfaceless".
  [[nodiscard]] const std::string& kind() const;

 private:
  struct Implementation;
  explicit OffscreenContext(std::unique_ptr<Implementation> implementation);
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace nadir
