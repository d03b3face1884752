// The journal's records as bytes.
//
//   record   length of what follows the checksum (u32), checksum of it (u64), kind (u8), and for a kind that
//            carries work: slot (i32), lids (2 f32), name and origin (each u16 and its bytes), how many
//            pulls (u32), each pull (3 f32). Little-endian.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "appliance/programs/editor/session.h"

namespace kaori::editor {

// One change of a session.
struct Record {
  Change change = Change::kNone;
  Work work;  // As it was after the change.
};

// Appends the record's bytes. Names longer than 200 bytes are cut off. Pure.
void Encode(const Record& record, std::vector<std::uint8_t>& into);

// What Decode found.
struct Decoded {
  std::vector<Record> records;
  std::size_t sound_bytes = 0;  // Up to the end of the last whole record.
};

// Reads as far as records are whole: one that was torn, and what follows it, is left out. Safe for any bytes.
// Pure.
Decoded Decode(std::span<const std::uint8_t> bytes);

}  // namespace kaori::editor
