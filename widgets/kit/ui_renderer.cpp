// SPDX-License-Identifier: Apache-2.0
#include "widgets/kit/ui_renderer.h"

#include <backends/imgui_impl_opengl3.h>

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include "core/base/require.h"
#include "widgets/kit/ui_canvas.h"
#include "widgets/kit/ui_frame.h"

namespace nadir::kit {
namespace {

constexpr std::uint64_t kFontPicture = 1;

/// A frame buffer with one colour texture.
class Target {
 public:
  Target(int width, int height) {
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    glGenFramebuffers(1, &buffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, buffer_);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  }
  ~Target() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glBindTexture(GL_TEXTURE_2D, 0);
    glDeleteFramebuffers(1, &buffer_);
    glDeleteTextures(1, &texture_);
  }
  Target(const Target&) = delete;
  Target& operator=(const Target&) = delete;
  [[nodiscard]] bool is_complete() const {
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }

 private:
  GLuint texture_ = 0, buffer_ = 0;
};

}  // namespace

UiRenderer::UiRenderer(UiContext& context) : context_(context) {}

Result<std::unique_ptr<UiRenderer>> UiRenderer::create(UiContext& context) {
  std::unique_ptr<UiRenderer> made(new UiRenderer(context));
  ImGui::SetCurrentContext(context.state().imgui);
  if (!ImGui_ImplOpenGL3_Init("#version 330 core") || !ImGui_ImplOpenGL3_CreateDeviceObjects()) {
    return fail(ErrorCode::kUnsupported,
                "the interface cannot be drawn: OpenGL 3.3 refuses its shaders");
  }
  // Dear ImGui's own texture of the fonts is not used: fonts change with the scale and are shared between contexts.
  ImGui_ImplOpenGL3_DestroyFontsTexture();
  context.state().fonts->atlas().SetTexID(UiPictures::font_id());
  return made;
}

UiRenderer::~UiRenderer() {
  ImGui::SetCurrentContext(context_.state().imgui);
  if (ImGui::GetIO().BackendRendererUserData != nullptr) ImGui_ImplOpenGL3_Shutdown();
  context_.state().fonts->atlas().SetTexID(UiPictures::font_id());
  ImGui::GetIO().BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
}

std::uint32_t UiRenderer::texture_of(std::uint64_t picture) {
  const UiContext::State& state = context_.state();
  if (picture == kFontPicture && fonts_ != state.fonts.get()) {
    textures_.erase(picture);
    fonts_ = state.fonts.get();
  }
  if (const auto there = textures_.find(picture); there != textures_.end()) {
    return there->second.texture();
  }
  if (picture == kFontPicture) return textures_[picture].show(state.fonts->pixels(), true);
  const auto& pictures = state.pictures.all();
  const auto found = pictures.find(picture);
  return found == pictures.end() ? 0 : textures_[picture].show(found->second.pixels, false);
}

void UiRenderer::forget_unused() {
  const auto& pictures = context_.state().pictures.all();
  std::erase_if(textures_, [&pictures](const auto& entry) {
    return entry.first != kFontPicture && !pictures.contains(entry.first);
  });
}

void UiRenderer::draw() {
  UiContext::State& state = context_.state();
  NADIR_REQUIRE(!state.is_in_frame);
  ImGui::SetCurrentContext(state.imgui);
  ImDrawData* const data = ImGui::GetDrawData();
  NADIR_REQUIRE(data != nullptr);
  forget_unused();
  for (int i = 0; i < data->CmdListsCount; ++i) {
    for (ImDrawCmd& command : data->CmdLists[i]->CmdBuffer) {
      if (const std::uint64_t picture = UiPictures::picture_of(command.TextureId); picture != 0) {
        command.TextureId = UiPictures::texture_id(texture_of(picture));
      }
    }
  }
  ImGui_ImplOpenGL3_RenderDrawData(data);
}

Result<Raster<Rgba>> UiRenderer::draw_to_pixels() {
  const UiContext::State& state = context_.state();
  const auto width =
      static_cast<int>(std::lround(state.input.size_px.x() * state.input.framebuffer_scale));
  const auto height =
      static_cast<int>(std::lround(state.input.size_px.y() * state.input.framebuffer_scale));
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_SIZE, &most);
  if (width > most || height > most)
    return fail(ErrorCode::kUnsupported,
                "a picture of {} x {} pixels is larger than OpenGL can draw ({})", width, height,
                most);
  const Target target(width, height);
  if (!target.is_complete())
    return fail(ErrorCode::kUnsupported, "OpenGL gives no frame buffer of {} x {} pixels", width,
                height);
  const Rgba background = nadir::theme(state.theme).window;
  glViewport(0, 0, width, height);
  glDisable(GL_SCISSOR_TEST);
  glClearColor(static_cast<float>(background.red) / 255.0F,
               static_cast<float>(background.green) / 255.0F,
               static_cast<float>(background.blue) / 255.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT);
  draw();
  Raster<Rgba> upside_down(width, height);
  glPixelStorei(GL_PACK_ALIGNMENT, 4);
  glPixelStorei(GL_PACK_ROW_LENGTH, 0);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, upside_down.data());
  Raster<Rgba> pixels(width, height);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      Rgba colour = upside_down.at(column, height - 1 - row);
      colour.alpha = 255;  // blending leaves less where something shone through
      pixels.at(column, row) = colour;
    }
  }
  return pixels;
}

}  // namespace nadir::kit
