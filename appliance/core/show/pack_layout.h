// Plain values that have the same bytes in a pack and in memory, so that they move by one copy.
#pragma once

#include <span>
#include <type_traits>
#include <vector>

#include "appliance/core/show/pack_generated.h"
#include "appliance/core/show/show.h"

namespace kaori::show {

// Packs are little-endian, as every machine that the box runs on.
static_assert(FLATBUFFERS_LITTLEENDIAN == 1);

// Refuses, when the program is built, two types that cannot have the same bytes. That their fields stand in
// the same order is for pack.fbs to keep, and the tests of packs see it.
template <class Stored, class Held>
constexpr void SameBytes() {
  static_assert(std::is_trivially_copyable_v<Stored> && std::is_trivially_copyable_v<Held>);
  static_assert(sizeof(Stored) == sizeof(Held) && alignof(Stored) == alignof(Held));
}

// The same bytes under the other name, for a builder that copies them. Borrowed: valid as long as `held` lives and
// does not grow; of an empty vector it may be null.
template <class Stored, class Held>
const Stored* AsStored(const std::vector<Held>& held) {
  SameBytes<Stored, Held>();
  return reinterpret_cast<const Stored*>(held.data());
}

// The same of one value; valid as long as that.
template <class Stored, class Held>
const Stored& AsStored(const Held& held) {
  SameBytes<Stored, Held>();
  return reinterpret_cast<const Stored&>(held);
}

// The way back: a value of the content as the show has it. Valid as long as the content, so that whoever keeps it
// copies it. Numbers may be anything: the show is checked as a whole afterwards.
template <class Stored, class Held>
const Held& AsHeld(const Stored& stored) {
  SameBytes<Stored, Held>();
  return reinterpret_cast<const Held&>(stored);
}

}  // namespace kaori::show
