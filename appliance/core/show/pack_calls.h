// What buttons, keys and roles call, in a pack's content.
#pragma once

#include <vector>

#include "appliance/core/show/call.h"
#include "appliance/core/show/pack_copier.h"

namespace kaori::show {

// The kind in the lowest byte and the mode in the next: a pack without modes has zeros there, and calls
// as CallMode::kCall does.
inline pack::Call StoredCall(const Call& call) {
  return {static_cast<std::uint32_t>(call.kind) | static_cast<std::uint32_t>(call.mode) << 8U, call.index};
}

// Numbers that are no kind and no mode stay so, for CheckShow to find.
inline Call HeldCall(const pack::Call& stored) {
  return {static_cast<CallKind>(stored.kind() & 0xFFU), Narrow<std::uint16_t>(stored.index()),
          static_cast<CallMode>(Narrow<std::uint8_t>(stored.kind() >> 8U))};
}

// All calls of a list or an array, in their order. Those that call nothing are kept, so that the place of each stays.
template <class Calls>
std::vector<pack::Call> StoredCalls(const Calls& calls) {
  std::vector<pack::Call> stored;
  for (const Call& call : calls) stored.push_back(StoredCall(call));
  return stored;
}

}  // namespace kaori::show
