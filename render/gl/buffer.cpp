#include "render/gl/buffer.h"

#include <GLES3/gl3.h>

#include <cassert>
#include <cstring>

namespace kaori::gl {
namespace {

void DeleteBuffer(unsigned id) {
  glDeleteBuffers(1, &id);
}

// Vertex array objects remember the index binding, so buffers are filled through a target that none uses.
constexpr GLenum kFillTarget = GL_COPY_WRITE_BUFFER;

}  // namespace

// Storage without content: Write maps it.
Buffer::Buffer(BufferUse use, std::size_t size_bytes) : size_bytes_(size_bytes) {
  GLuint id = 0;
  glGenBuffers(1, &id);
  handle_ = Handle(id, DeleteBuffer);
  glBindBuffer(kFillTarget, id);
  glBufferData(kFillTarget, static_cast<GLsizeiptr>(size_bytes), nullptr,
               use == BufferUse::kStatic ? GL_STATIC_DRAW : GL_STREAM_DRAW);
}

// Mapped, so that no copy of ours is made.
void Buffer::Write(std::span<const std::byte> bytes) {
  assert(bytes.size() <= size_bytes_);
  if (bytes.empty()) return;
  glBindBuffer(kFillTarget, handle_.id());
  // Invalidated as a whole, so that the driver may give fresh memory instead of waiting for a draw that still
  // reads the old one.
  void* target = glMapBufferRange(kFillTarget, 0, static_cast<GLsizeiptr>(bytes.size()),
                                  GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  // Out of memory; the last content stays.
  if (target == nullptr) return;
  std::memcpy(target, bytes.data(), bytes.size());
  glUnmapBuffer(kFillTarget);
}

void Buffer::BindUniforms(unsigned binding) const {
  glBindBufferBase(GL_UNIFORM_BUFFER, binding, handle_.id());
}

}  // namespace kaori::gl
