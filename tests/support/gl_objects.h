// SPDX-License-Identifier: Apache-2.0
#pragma once

#define GL_GLEXT_PROTOTYPES
#include <GL/gl.h>
#include <GL/glext.h>

#include <ostream>

namespace nadir {

/// How many things of a kind the OpenGL context that is current holds.
struct GlObjects {
  int textures = 0, buffers = 0, frame_buffers = 0, render_buffers = 0, vertex_arrays = 0,
      programs = 0, shaders = 0;
  friend bool operator==(const GlObjects&, const GlObjects&) = default;
};

/// Asks OpenGL about every name that a program of this size could have been given: names are numbered from 1, and the
/// lowest free ones are given first.
[[nodiscard]] inline GlObjects count_gl_objects() {
  constexpr GLuint kMostNames = 20'000;
  GlObjects count;
  for (GLuint name = 1; name <= kMostNames; ++name) {
    count.textures += glIsTexture(name) == GL_TRUE;
    count.buffers += glIsBuffer(name) == GL_TRUE;
    count.frame_buffers += glIsFramebuffer(name) == GL_TRUE;
    count.render_buffers += glIsRenderbuffer(name) == GL_TRUE;
    count.vertex_arrays += glIsVertexArray(name) == GL_TRUE;
    count.programs += glIsProgram(name) == GL_TRUE;
    count.shaders += glIsShader(name) == GL_TRUE;
  }
  while (glGetError() != GL_NO_ERROR) {
  }
  return count;
}

/// For GoogleTest's messages.
inline void PrintTo(const GlObjects& count, std::ostream* out) {
  *out << count.textures << " textures, " << count.buffers << " buffers, " << count.frame_buffers
       << " frame buffers, " << count.render_buffers << " render buffers, " << count.vertex_arrays
       << " vertex arrays, " << count.programs << " programs, " << count.shaders << " shaders";
}

}  // namespace nadir
