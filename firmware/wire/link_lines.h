// The local link's packets of GPIO lines as structs, and their bytes: what link.h says in prose.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "firmware/wire/bytes.h"
#include "firmware/wire/link.h"
#include "firmware/wire/link_packets.h"

namespace kaori::wire {

// The lengths of the tables in link.h.
inline constexpr std::size_t kLinesHelloBytes = 16;
inline constexpr std::size_t kLineEdgeBytes = 16;
inline constexpr std::size_t kLineDriveBytes = 8;

// The first packet of the panel. Bit n of `active` is input line n; both counts are 32 at most.
struct LinesHello {
  std::uint32_t inputs = 0;
  std::uint32_t outputs = 0;
  std::uint32_t active = 0;
};
// An input line has changed.
struct LineEdge {
  std::int64_t at_ns = 0;    // CLOCK_MONOTONIC.
  std::uint32_t line = 0;    // Below LinesHello::inputs.
  std::uint32_t active = 0;  // 1 or 0.
};
// The driver drives an output line.
struct LineDrive {
  std::uint32_t line = 0;    // Below LinesHello::outputs.
  std::uint32_t active = 0;  // 1 or 0.
};

// Encode, in this header and its neighbours, is for the side that sends the packet; it checks nothing.
constexpr std::array<std::uint8_t, kLinesHelloBytes> Encode(const LinesHello& hello) {
  std::array<std::uint8_t, kLinesHelloBytes> bytes{};
  PutU32(bytes, 0, kLinesHello);
  PutU32(bytes, 4, hello.inputs);
  PutU32(bytes, 8, hello.outputs);
  PutU32(bytes, 12, hello.active);
  return bytes;
}

// Decode gives none for a packet of another length or kind. Whether
// the counts are 32 at most is for the caller.
constexpr std::optional<LinesHello> DecodeLinesHello(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kLinesHelloBytes || GetU32(bytes, 0) != kLinesHello) return std::nullopt;
  return LinesHello{GetU32(bytes, 4), GetU32(bytes, 8), GetU32(bytes, 12)};
}

// Tells when and how an input line changed.
constexpr std::array<std::uint8_t, kLineEdgeBytes> Encode(const LineEdge& edge) {
  std::array<std::uint8_t, kLineEdgeBytes> bytes{};
  PutU64(bytes, 0, static_cast<std::uint64_t>(edge.at_ns));
  PutU32(bytes, 8, edge.line);
  PutU32(bytes, 12, edge.active);
  return bytes;
}

// None where `active` is neither 0 nor 1: such a packet is not of this kind.
constexpr std::optional<LineEdge> DecodeLineEdge(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kLineEdgeBytes || GetU32(bytes, 12) > 1) return std::nullopt;
  return LineEdge{GetI64(bytes, 0), GetU32(bytes, 8), GetU32(bytes, 12)};
}

// Says what an output line is to be.
constexpr std::array<std::uint8_t, kLineDriveBytes> Encode(const LineDrive& drive) {
  std::array<std::uint8_t, kLineDriveBytes> bytes{};
  PutU32(bytes, 0, drive.line);
  PutU32(bytes, 4, drive.active);
  return bytes;
}

// As DecodeLineEdge. Whether there is such an output is for the caller, who knows the panel.
constexpr std::optional<LineDrive> DecodeLineDrive(std::span<const std::uint8_t> bytes) {
  if (bytes.size() != kLineDriveBytes || GetU32(bytes, 4) > 1) return std::nullopt;
  return LineDrive{GetU32(bytes, 0), GetU32(bytes, 4)};
}

}  // namespace kaori::wire
