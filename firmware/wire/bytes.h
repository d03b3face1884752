// Little-endian numbers in reports, packets and files, byte by byte: no
// casts, no alignment, no operating system.
//
// `at` is an offset in bytes. The caller makes sure that the span holds the number: nothing is checked
// here. All functions are constexpr, so that tables of bytes are made by the compiler.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace kaori::wire {

// Writes 2 bytes, the low one first.
constexpr void PutU16(std::span<std::uint8_t> into, std::size_t at, std::uint16_t value) {
  into[at] = static_cast<std::uint8_t>(value & 0xFFu);
  into[at + 1] = static_cast<std::uint8_t>(value >> 8);
}

// Writes 4 bytes, the low one first.
constexpr void PutU32(std::span<std::uint8_t> into, std::size_t at, std::uint32_t value) {
  PutU16(into, at, static_cast<std::uint16_t>(value & 0xFFFFu));
  PutU16(into, at + 2, static_cast<std::uint16_t>(value >> 16));
}

// Reads 2 bytes. The shift is made in int, which holds 16 bits without a sign.
constexpr std::uint16_t GetU16(std::span<const std::uint8_t> from, std::size_t at) {
  return static_cast<std::uint16_t>(from[at] | (from[at + 1] << 8));
}

// Reads 4 bytes. The upper half is widened first: shifted as an int its highest bit would be the sign.
constexpr std::uint32_t GetU32(std::span<const std::uint8_t> from, std::size_t at) {
  return GetU16(from, at) | (static_cast<std::uint32_t>(GetU16(from, at + 2)) << 16);
}

// Writes 8 bytes, the low word first.
constexpr void PutU64(std::span<std::uint8_t> into, std::size_t at, std::uint64_t value) {
  PutU32(into, at, static_cast<std::uint32_t>(value & 0xFFFFFFFFu));
  PutU32(into, at + 4, static_cast<std::uint32_t>(value >> 32));
}

// Reads 8 bytes, the low word first.
constexpr std::uint64_t GetU64(std::span<const std::uint8_t> from, std::size_t at) {
  return GetU32(from, at) | (static_cast<std::uint64_t>(GetU32(from, at + 4)) << 32);
}

// Writes a signed number as two's complement, which C++20 guarantees for the conversion either way.
constexpr void PutI16(std::span<std::uint8_t> into, std::size_t at, std::int16_t value) {
  PutU16(into, at, static_cast<std::uint16_t>(value));
}

constexpr std::int16_t GetI16(std::span<const std::uint8_t> from, std::size_t at) {
  return static_cast<std::int16_t>(GetU16(from, at));
}

}  // namespace kaori::wire
