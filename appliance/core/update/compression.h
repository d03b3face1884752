// Packs and unpacks the parts of an update, piece by piece, by zstd.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "drivers/base/result.h"

namespace kaori::update {

// The window of a frame, by which its reader's memory is bounded: 8 MiB.
inline constexpr int kWindow_log2 = 23;

// A frame is asked for content a piece at a time, and nothing of it is kept but the window: a box of 512 MiB unpacks what is
// larger than its memory. What is behind the frame's end is not looked at.
//
// Unpacks one frame. One thread.
class Unpacker {
 public:
  Unpacker();
  ~Unpacker();
  Unpacker(Unpacker&&) noexcept;
  Unpacker& operator=(Unpacker&&) noexcept;

  // Unpacks from the front of `packed`, which becomes shorter, until `into` is full or more is needed; gives
  // how far `into` was filled. Behind the frame's end nothing comes. Errors: invalid_argument (no such frame,
  // or one that wants more memory).
  Result<std::size_t> Unpack(std::span<const std::uint8_t>& packed, std::span<std::uint8_t> into);

  // Whether the frame has ended and all of it was given.
  bool ended() const { return ended_; }

 private:
  struct Context;
  std::unique_ptr<Context> context_;
  bool ended_ = false;
};

// How small a part is packed: quickly takes seconds for each 100 MB, the other fourteen times as long for a tenth less.
enum class Packing : std::uint8_t { kQuick, kSmallest };

// One frame of all of `content`; what unpacks it needs the same memory either way. The same content gives the same bytes with
// the same version of the library. Errors: not_enough_memory.
Result<std::vector<std::uint8_t>> Pack(std::span<const std::uint8_t> content,
                                       Packing packing = Packing::kQuick);

}  // namespace kaori::update
