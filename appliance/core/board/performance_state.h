// Lays the stage's own state into the board's `performance` section, and takes it up again after a restart.
//
// The board knows nothing of what is in it. A stage that was killed goes on from what its last frame left; one of
// another build begins anew, with a jump, rather than believe bytes that mean something else.
#pragma once

#include <cstring>
#include <optional>
#include <type_traits>

#include "appliance/core/board/sections.h"

namespace kaori::board {

// `State` is trivially copyable, at most Performance::kCapacityBytes large, and has a `static constexpr
// std::uint32_t kLayout` above 0 that changes whenever its fields do. Pure; the bytes that it gives are plain
// memory of this build and this machine, and kLayout is all that tells one build's struct from another's.
template <class State>
Performance Hold(const State& state) {
  static_assert(std::is_trivially_copyable_v<State> && sizeof(State) <= Performance::kCapacityBytes);
  static_assert(State::kLayout != 0);
  Performance performance;
  performance.layout = State::kLayout;
  performance.bytes = sizeof(State);
  std::memcpy(performance.state.data(), &state, sizeof(State));
  return performance;
}

// The state that a stage of the same layout held. Nothing where the section holds another struct, or none:
// the stage then begins anew. Fields are as their writer left them and may be anything, so the caller checks
// them before use (performance::IsValid).
template <class State>
std::optional<State> Restore(const Performance& performance) {
  static_assert(std::is_trivially_copyable_v<State> && std::is_default_constructible_v<State>);
  if (performance.layout != State::kLayout || performance.bytes != sizeof(State)) return std::nullopt;
  State state;
  std::memcpy(static_cast<void*>(&state), performance.state.data(), sizeof(State));
  return state;
}

}  // namespace kaori::board
