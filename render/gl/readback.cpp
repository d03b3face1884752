#include "render/gl/readback.h"

#include <GLES3/gl31.h>

#include <cassert>
#include <cstring>
#include <utility>

namespace kaori::gl {
namespace {

void DeleteReadbackBuffer(unsigned id) {
  glDeleteBuffers(1, &id);
}

}  // namespace

// The flush sets the card to work on it now; without it the copy might begin with the next frame only.
void Readback::Ask(const Target& target) {
  Forget();
  const std::size_t size_bytes =
      static_cast<std::size_t>(target.width_px()) * static_cast<std::size_t>(target.height_px()) * 4;
  GLuint id = buffer_.id();
  if (id == 0) {
    glGenBuffers(1, &id);
    buffer_ = Handle(id, DeleteReadbackBuffer);
  }
  glBindBuffer(GL_PIXEL_PACK_BUFFER, id);
  if (size_bytes != size_bytes_)
    glBufferData(GL_PIXEL_PACK_BUFFER, static_cast<GLsizeiptr>(size_bytes), nullptr, GL_STREAM_READ);
  size_bytes_ = size_bytes;
  glBindFramebuffer(GL_FRAMEBUFFER, target.id());
  glPixelStorei(GL_PACK_ALIGNMENT, 4);  // Rows of four-byte pixels are always aligned.
  glReadPixels(0, 0, target.width_px(), target.height_px(), GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  fence_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
  glFlush();
}

// A time of 0 asks, and waits for nothing. A fence that fails gives up the copy.
bool Readback::Fetch(std::span<std::uint8_t> bytes) {
  assert(bytes.size() >= size_bytes_);
  if (fence_ == nullptr) return false;
  const GLenum done = glClientWaitSync(static_cast<GLsync>(fence_), 0, 0);
  if (done == GL_TIMEOUT_EXPIRED) return false;
  Forget();
  if (done == GL_WAIT_FAILED) return false;
  glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer_.id());
  const void* const from =
      glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, static_cast<GLsizeiptr>(size_bytes_), GL_MAP_READ_BIT);
  if (from != nullptr) std::memcpy(bytes.data(), from, size_bytes_);
  const bool whole = from != nullptr && glUnmapBuffer(GL_PIXEL_PACK_BUFFER) == GL_TRUE;
  glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
  return whole;
}

void Readback::Forget() {
  if (fence_ != nullptr) glDeleteSync(static_cast<GLsync>(std::exchange(fence_, nullptr)));
}

}  // namespace kaori::gl
