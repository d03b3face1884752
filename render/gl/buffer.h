// Memory that vertices, indices and uniform blocks are read from.
#pragma once

#include <cstddef>
#include <span>

#include "render/gl/handle.h"

namespace kaori::gl {

// A hint for the driver: written once (GL_STATIC_DRAW), or anew for each frame (GL_STREAM_DRAW).
enum class BufferUse { kStatic, kEachFrame };

// Made for a size; a write may be shorter, never longer: asserted. Of the context that is current when it is
// made, on its thread. Without memory for it the driver notes GL_OUT_OF_MEMORY, and nothing is drawn from it.
// Uses the target GL_COPY_WRITE_BUFFER, so vertex arrays are not disturbed.
class Buffer {
 public:
  Buffer() = default;
  // Storage without content. `size_bytes` may be 0: such a buffer is never read.
  Buffer(BufferUse use, std::size_t size_bytes);

  // Holds a copy of `values`.
  template <class T>
  static Buffer Of(std::span<const T> values) {
    Buffer buffer(BufferUse::kStatic, values.size_bytes());
    buffer.Write(std::as_bytes(values));
    return buffer;
  }

  // Replaces the content from the start; what is not covered is lost. Does not wait for draws that read the
  // last content. Allocates nothing of ours.
  void Write(std::span<const std::byte> bytes);

  // Makes uniform block `binding` of every program read this buffer.
  void BindUniforms(unsigned binding) const;

  // 0: no buffer.
  unsigned id() const { return handle_.id(); }
  // As made.
  std::size_t size_bytes() const { return size_bytes_; }

 private:
  Handle handle_;
  std::size_t size_bytes_ = 0;
};

}  // namespace kaori::gl
