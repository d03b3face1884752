// Lays the stage's own state into the board's `performance` section, and takes it up again after a restart.
#pragma once

#include <cstring>
#include <optional>
#include <type_traits>

#include "appliance/core/board/sections.h"

namespace kaori::board {

// `State` is trivially copyable, at most Performance::kCapacityBytes large, and has a
// `static constexpr std::uint32_t kLayout` above 0 that changes whenever its fields do.
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

// Nothing where the section holds another struct, or none. Fields are as their writer left them: check them.
template <class State>
std::optional<State> Restore(const Performance& performance) {
  static_assert(std::is_trivially_copyable_v<State> && std::is_default_constructible_v<State>);
  if (performance.layout != State::kLayout || performance.bytes != sizeof(State)) return std::nullopt;
  State state;
  std::memcpy(static_cast<void*>(&state), performance.state.data(), sizeof(State));
  return state;
}

}  // namespace kaori::board
