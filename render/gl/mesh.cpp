#include "render/gl/mesh.h"

#include <GLES3/gl3.h>

namespace kaori::gl {
namespace {

void DeleteMesh(unsigned id) {
  glDeleteVertexArrays(1, &id);
}

// An attribute of the buffer and the vertex array that are bound.
void Describe(const Attribute& a, int stride_bytes) {
  // GL takes the offset as a pointer. NOLINTNEXTLINE(performance-no-int-to-ptr)
  const auto* offset = reinterpret_cast<const void*>(static_cast<std::intptr_t>(a.offset_bytes));
  glEnableVertexAttribArray(a.location);
  // GLES has a function of its own for integers that are not to become floats.
  if (a.scalar == Scalar::kUInt) {
    glVertexAttribIPointer(a.location, a.components, GL_UNSIGNED_INT, stride_bytes, offset);
  } else {
    glVertexAttribPointer(a.location, a.components, GL_FLOAT, GL_FALSE, stride_bytes, offset);
  }
}

// Leaves the new array bound.
Handle NewArray(std::initializer_list<VertexStream> streams) {
  GLuint id = 0;
  glGenVertexArrays(1, &id);
  glBindVertexArray(id);
  for (const VertexStream& stream : streams) {
    glBindBuffer(GL_ARRAY_BUFFER, stream.buffer.id());
    for (const Attribute& attribute : stream.attributes) Describe(attribute, stream.stride_bytes);
  }
  return Handle(id, DeleteMesh);
}

}  // namespace

Mesh::Mesh(std::initializer_list<VertexStream> streams, std::span<const std::uint32_t> indices)
    : array_(NewArray(streams)),
      indices_(Buffer::Of(indices)),
      element_count_(static_cast<int>(indices.size())) {
  // The vertex array, which NewArray left bound, remembers these as its indices. Unbound, it keeps them.
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
  glBindVertexArray(0);
}

Mesh::Mesh(std::initializer_list<VertexStream> streams, int vertex_count)
    : array_(NewArray(streams)), element_count_(vertex_count) {
  glBindVertexArray(0);
}

// Vertex arrays remember buffers and indices; nothing else is bound.
void Mesh::Draw() const {
  if (element_count_ == 0) return;
  glBindVertexArray(array_.id());
  if (indices_.id() != 0) {
    glDrawElements(GL_TRIANGLES, element_count_, GL_UNSIGNED_INT, nullptr);
  } else {
    glDrawArrays(GL_TRIANGLES, 0, element_count_);
  }
}

void Mesh::DrawInstances(int instances) const {
  if (element_count_ == 0 || instances <= 0) return;
  glBindVertexArray(array_.id());
  if (indices_.id() != 0) {
    glDrawElementsInstanced(GL_TRIANGLES, element_count_, GL_UNSIGNED_INT, nullptr, instances);
  } else {
    glDrawArraysInstanced(GL_TRIANGLES, 0, element_count_, instances);
  }
}

}  // namespace kaori::gl
