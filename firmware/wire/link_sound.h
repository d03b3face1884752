// The local link's packets of sound as structs, encoded and decoded. The byte tables are in link.h.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/wire/bytes.h"
#include "firmware/wire/link.h"
#include "firmware/wire/link_packets.h"

namespace kaori::wire {

// The lengths of the tables in link.h. A block is at most kMaxLinkPacket bytes with its samples.
inline constexpr std::size_t kMicrophoneHelloBytes = 12;
inline constexpr std::size_t kSoundBlockBytes = 12;  // Before the samples of each block.
inline constexpr std::size_t kLoudspeakerHelloBytes = 16;
inline constexpr std::size_t kPlayedBytes = 20;

// The first packet of a microphone. `channels` is 1 or 2.
struct MicrophoneHello {
  // 48000 for the devices of ours; drivers accept others.
  std::uint32_t rate_hz = 0;
  std::uint32_t channels = 0;
};
// Stands before the samples of a block. `at_ns` is when the first of them was heard, on CLOCK_MONOTONIC.
struct SoundBlockNote {
  // When the first frame was heard, on CLOCK_MONOTONIC.
  std::int64_t at_ns = 0;
  std::uint32_t lost = 0;  // 1: frames were lost before this block.
};
// The first packet of a loudspeaker.
struct LoudspeakerHello {
  // Of the device's own crystal, nominally.
  std::uint32_t rate_hz = 0;
  std::uint32_t channels = 0;
  // As many may be queued. The driver keeps count of what it sent and of what PlayedNote told,
  // and never sends more: there is no packet that refuses sound.
  std::uint32_t room_frames = 0;
};
// Sent as the sound plays. The driver derives from it when a frame that it queues now will be heard.
struct PlayedNote {
  // When the last of the frames was over, on CLOCK_MONOTONIC.
  std::int64_t at_ns = 0;
  // Since the hello, without the silence that was played while the queue was dry.
  std::uint64_t frames = 0;
  std::uint32_t dry = 0;  // How often the queue ran dry.
};

constexpr std::array<std::uint8_t, kMicrophoneHelloBytes> Encode(const MicrophoneHello& hello) {
  std::array<std::uint8_t, kMicrophoneHelloBytes> bytes{};
  PutU32(bytes, 0, kMicrophoneHello);
  PutU32(bytes, 4, hello.rate_hz);
  PutU32(bytes, 8, hello.channels);
  return bytes;
}

constexpr std::optional<MicrophoneHello> DecodeMicrophoneHello(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kMicrophoneHelloBytes || GetU32(bytes, 0) != kMicrophoneHello) return std::nullopt;
  return MicrophoneHello{GetU32(bytes, 4), GetU32(bytes, 8)};
}

// The caller appends the samples.
constexpr std::array<std::uint8_t, kSoundBlockBytes> Encode(const SoundBlockNote& note) {
  std::array<std::uint8_t, kSoundBlockBytes> bytes{};
  PutU64(bytes, 0, static_cast<std::uint64_t>(note.at_ns));
  PutU32(bytes, 8, note.lost);
  return bytes;
}

// The samples follow; whether they are whole frames is for the caller to check.
constexpr std::optional<SoundBlockNote> DecodeSoundBlock(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kSoundBlockBytes) return std::nullopt;
  return SoundBlockNote{GetI64(bytes, 0), GetU32(bytes, 8)};
}

constexpr std::array<std::uint8_t, kLoudspeakerHelloBytes> Encode(const LoudspeakerHello& hello) {
  std::array<std::uint8_t, kLoudspeakerHelloBytes> bytes{};
  PutU32(bytes, 0, kLoudspeakerHello);
  PutU32(bytes, 4, hello.rate_hz);
  PutU32(bytes, 8, hello.channels);
  PutU32(bytes, 12, hello.room_frames);
  return bytes;
}

constexpr std::optional<LoudspeakerHello> DecodeLoudspeakerHello(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kLoudspeakerHelloBytes || GetU32(bytes, 0) != kLoudspeakerHello) return std::nullopt;
  return LoudspeakerHello{GetU32(bytes, 4), GetU32(bytes, 8), GetU32(bytes, 12)};
}

constexpr std::array<std::uint8_t, kPlayedBytes> Encode(const PlayedNote& note) {
  std::array<std::uint8_t, kPlayedBytes> bytes{};
  PutU64(bytes, 0, static_cast<std::uint64_t>(note.at_ns));
  PutU64(bytes, 8, note.frames);
  PutU32(bytes, 16, note.dry);
  return bytes;
}

constexpr std::optional<PlayedNote> DecodePlayed(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kPlayedBytes) return std::nullopt;
  return PlayedNote{GetI64(bytes, 0), GetU64(bytes, 8), GetU32(bytes, 16)};
}

}  // namespace kaori::wire
