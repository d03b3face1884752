// A picture on its way from the graphics card to the processor, for which nobody waits.
#pragma once

#include <cstdint>
#include <span>

#include "render/gl/handle.h"
#include "render/gl/target.h"

namespace kaori::gl {

// One picture at a time, in a buffer of the card's (GL_PIXEL_PACK_BUFFER) behind a fence. On the thread of
// its context, which is current when it ends.
class Readback {
 public:
  Readback() = default;
  Readback(const Readback&) = delete;
  Readback& operator=(const Readback&) = delete;
  ~Readback() { Forget(); }

  // Asks for a copy of the target as it is once all that was asked of the card before is done, and returns at
  // once. A copy that is on its way is given up. Makes a buffer where the size is another one.
  void Ask(const Target& target);

  // A copy was asked for, and Fetch has not given it.
  bool pending() const { return fence_ != nullptr; }

  // Copies the picture out where it is there, as Target::ReadPixels does; false: not yet. `bytes` holds width
  // * height * 4 of the target.
  bool Fetch(std::span<std::uint8_t> bytes);

 private:
  void Forget();

  Handle buffer_;
  std::size_t size_bytes_ = 0;
  void* fence_ = nullptr;  // A GLsync.
};

}  // namespace kaori::gl
