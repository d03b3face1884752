// Vertices in buffers, their layout, and the indices that join them.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <span>

#include "render/gl/buffer.h"
#include "render/gl/handle.h"

namespace kaori::gl {

// What one component is in memory: a float, or a 32-bit integer that stays one in the shader.
enum class Scalar : std::uint8_t { kFloat, kUInt };

// Where a shader's `layout(location = ...)` input lies in each vertex of a buffer. Locations that a program
// does not use cost nothing.
struct Attribute {
  unsigned location = 0;
  // 1 to 4.
  int components = 0;
  Scalar scalar = Scalar::kFloat;
  int offset_bytes = 0;
};

// One buffer of a mesh: vertex n begins at n * stride_bytes.
struct VertexStream {
  // Borrowed; it lives as long as the mesh.
  const Buffer& buffer;
  int stride_bytes = 0;
  std::initializer_list<Attribute> attributes;
};

// Borrows the buffers of its streams: they live as long as the mesh; their content may change. A vertex array
// object with its own index buffer. On the thread of its context. Without vertices (or default-constructed)
// drawing does nothing.
class Mesh {
 public:
  Mesh() = default;
  // `indices`: three for each triangle, each the number of a vertex in all streams; not checked here.
  Mesh(std::initializer_list<VertexStream> streams, std::span<const std::uint32_t> indices);
  // Without indices: triangles of consecutive vertices.
  Mesh(std::initializer_list<VertexStream> streams, int vertex_count);

  // All of it, as triangles, with the program and the state that are set. Leaves its vertex array bound.
  void Draw() const;
  // So many times over; shaders know which by gl_InstanceID.
  void DrawInstances(int instances) const;

 private:
  // The vertex array object; element_count_ are indices, or vertices where there are none.
  Handle array_;
  Buffer indices_;
  int element_count_ = 0;
};

}  // namespace kaori::gl
