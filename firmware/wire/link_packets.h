// The local link's packets as structs, encoded and decoded. The byte tables are in link.h. No operating
// system.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/wire/bytes.h"
#include "firmware/wire/link.h"

namespace kaori::wire {

// Decoding checks the length and the first word of a hello. Whether the numbers make sense (sizes,
// slots, formats) is for the caller to check: a peer is trusted to be ours, but not to be well, and a
// slot is an index into memory. The lengths are those of the tables in link.h.
inline constexpr std::size_t kHidHelloBytes = 12;  // The name and the descriptor follow.
inline constexpr std::size_t kHidStampBytes = 8;   // Before each input report.
inline constexpr std::size_t kCameraHelloBytes = 12;
inline constexpr std::size_t kCameraFrameBytes = 36;
inline constexpr std::size_t kCameraReturnBytes = 4;
inline constexpr std::size_t kScreenHelloBytes = 24;
inline constexpr std::size_t kScreenFlipBytes = 20;
inline constexpr std::size_t kScreenPresentBytes = 12;

// The first packet of a HID device. `name_bytes` of UTF-8 and `descriptor_bytes` follow it.
struct HidHello {
  // USB ids, as a real device of its kind has them.
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  // Lengths of what follows, in bytes; both may be 0.
  std::uint16_t name_bytes = 0;
  std::uint16_t descriptor_bytes = 0;
};
// The first packet of a camera. Slot n begins at n * slot_bytes of the memory whose descriptor comes
// beside it. A slot belongs to the driver from the frame packet until it is returned.
struct CameraHello {
  // How many frames the memory holds, and how long each slot is; 64 slots and 64 MiB at most.
  std::uint32_t slots = 0;
  std::uint32_t slot_bytes = 0;
};
// A frame lies in a slot. Sizes are in pixels of Y; `bytes` is how much of the slot is used.
struct CameraFrameNote {
  // When the frame was read out, on CLOCK_MONOTONIC.
  std::int64_t at_ns = 0;
  // Counts frames, those that were not sent included.
  std::uint32_t sequence = 0;
  std::uint32_t slot = 0;
  // Of the picture; even where the format shares colours.
  std::uint32_t width_px = 0;
  std::uint32_t height_px = 0;
  // From row to row of Y, or of YUYV; 0 for JPEG.
  std::uint32_t stride_bytes = 0;
  std::uint32_t pixels = 0;  // ports::PixelFormat.
  std::uint32_t bytes = 0;
};
// The first packet of a screen. A slot belongs to the screen from
// its Present until the flip of a later one.
struct ScreenHello {
  // 2 to 8.
  std::uint32_t slots = 0;
  // Of the picture; a slot is width_px * height_px * 4 bytes.
  std::uint32_t width_px = 0;
  std::uint32_t height_px = 0;
  // From one vertical blank to the next.
  std::int64_t period_ns = 0;
};
// `slot` is scanned out from `at_ns` on (CLOCK_MONOTONIC). What was scanned out before it is free again.
struct ScreenFlip {
  // The vertical blank, on CLOCK_MONOTONIC.
  std::int64_t at_ns = 0;
  // The number that ScreenPresent gave.
  std::uint64_t frame = 0;
  std::uint32_t slot = 0;
};
// Asks for a slot to be scanned out from the next vertical blank on. `frame` comes back with the flip.
struct ScreenPresent {
  // The driver's own number of the frame.
  std::uint64_t frame = 0;
  std::uint32_t slot = 0;
};

// A time: two's complement of 64 bits.
constexpr std::int64_t GetI64(std::span<const std::uint8_t> from, std::size_t at) {
  return static_cast<std::int64_t>(GetU64(from, at));
}

// The caller appends the name and the descriptor.
constexpr std::array<std::uint8_t, kHidHelloBytes> Encode(const HidHello& hello) {
  std::array<std::uint8_t, kHidHelloBytes> bytes{};
  PutU32(bytes, 0, kHidHello);
  PutU16(bytes, 4, hello.vendor);
  PutU16(bytes, 6, hello.product);
  PutU16(bytes, 8, hello.name_bytes);
  PutU16(bytes, 10, hello.descriptor_bytes);
  return bytes;
}

// None unless the name and the descriptor fill the rest exactly. They
// begin at kHidHelloBytes of the same packet.
constexpr std::optional<HidHello> DecodeHidHello(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kHidHelloBytes || GetU32(bytes, 0) != kHidHello) return std::nullopt;
  const HidHello hello{GetU16(bytes, 4), GetU16(bytes, 6), GetU16(bytes, 8), GetU16(bytes, 10)};
  const std::size_t rest = std::size_t{hello.name_bytes} + hello.descriptor_bytes;
  if (bytes.size() - kHidHelloBytes != rest) return std::nullopt;
  return hello;
}

// The memory's descriptor goes beside these bytes.
constexpr std::array<std::uint8_t, kCameraHelloBytes> Encode(const CameraHello& hello) {
  std::array<std::uint8_t, kCameraHelloBytes> bytes{};
  PutU32(bytes, 0, kCameraHello);
  PutU32(bytes, 4, hello.slots);
  PutU32(bytes, 8, hello.slot_bytes);
  return bytes;
}

// None for a packet of another length or kind.
constexpr std::optional<CameraHello> DecodeCameraHello(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kCameraHelloBytes || GetU32(bytes, 0) != kCameraHello) return std::nullopt;
  return CameraHello{GetU32(bytes, 4), GetU32(bytes, 8)};
}

// The slot belongs to the driver from this packet on.
constexpr std::array<std::uint8_t, kCameraFrameBytes> Encode(const CameraFrameNote& note) {
  std::array<std::uint8_t, kCameraFrameBytes> bytes{};
  PutU64(bytes, 0, static_cast<std::uint64_t>(note.at_ns));
  PutU32(bytes, 8, note.sequence);
  PutU32(bytes, 12, note.slot);
  PutU32(bytes, 16, note.width_px);
  PutU32(bytes, 20, note.height_px);
  PutU32(bytes, 24, note.stride_bytes);
  PutU32(bytes, 28, note.pixels);
  PutU32(bytes, 32, note.bytes);
  return bytes;
}

// Every combination of 36 bytes decodes. The caller checks that
// slot, size, format and `bytes` fit the memory.
constexpr std::optional<CameraFrameNote> DecodeCameraFrame(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kCameraFrameBytes) return std::nullopt;
  return CameraFrameNote{.at_ns = GetI64(bytes, 0),
                         .sequence = GetU32(bytes, 8),
                         .slot = GetU32(bytes, 12),
                         .width_px = GetU32(bytes, 16),
                         .height_px = GetU32(bytes, 20),
                         .stride_bytes = GetU32(bytes, 24),
                         .pixels = GetU32(bytes, 28),
                         .bytes = GetU32(bytes, 32)};
}

// The memory's descriptor goes beside these bytes.
constexpr std::array<std::uint8_t, kScreenHelloBytes> Encode(const ScreenHello& hello) {
  std::array<std::uint8_t, kScreenHelloBytes> bytes{};
  PutU32(bytes, 0, kScreenHello);
  PutU32(bytes, 4, hello.slots);
  PutU32(bytes, 8, hello.width_px);
  PutU32(bytes, 12, hello.height_px);
  PutU64(bytes, 16, static_cast<std::uint64_t>(hello.period_ns));
  return bytes;
}

// As DecodeCameraHello; the period and the sizes are for the caller to check.
constexpr std::optional<ScreenHello> DecodeScreenHello(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kScreenHelloBytes || GetU32(bytes, 0) != kScreenHello) return std::nullopt;
  return ScreenHello{GetU32(bytes, 4), GetU32(bytes, 8), GetU32(bytes, 12), GetI64(bytes, 16)};
}

// What was scanned out before is free again.
constexpr std::array<std::uint8_t, kScreenFlipBytes> Encode(const ScreenFlip& flip) {
  std::array<std::uint8_t, kScreenFlipBytes> bytes{};
  PutU64(bytes, 0, static_cast<std::uint64_t>(flip.at_ns));
  PutU64(bytes, 8, flip.frame);
  PutU32(bytes, 16, flip.slot);
  return bytes;
}

// None for a packet of another length.
constexpr std::optional<ScreenFlip> DecodeScreenFlip(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kScreenFlipBytes) return std::nullopt;
  return ScreenFlip{GetI64(bytes, 0), GetU64(bytes, 8), GetU32(bytes, 16)};
}

// The slot belongs to the screen from this packet on.
constexpr std::array<std::uint8_t, kScreenPresentBytes> Encode(const ScreenPresent& present) {
  std::array<std::uint8_t, kScreenPresentBytes> bytes{};
  PutU64(bytes, 0, present.frame);
  PutU32(bytes, 8, present.slot);
  return bytes;
}

// Whether there is such a slot, and whose it is, is for the device to check.
constexpr std::optional<ScreenPresent> DecodeScreenPresent(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kScreenPresentBytes) return std::nullopt;
  return ScreenPresent{GetU64(bytes, 0), GetU32(bytes, 8)};
}

}  // namespace kaori::wire
