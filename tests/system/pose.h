// What an audience and the operators would notice if a program's death changed it.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "appliance/core/board/board.h"

namespace kaori::test {

struct Pose {
  std::array<std::int32_t, 8> counts{};
  std::array<std::uint32_t, 32> pushes{};
  std::array<std::uint32_t, 8> keys_down{};
  std::array<std::uint32_t, 256> key_pushes{};
  std::array<float, 4> axes{};            // Left x, y, right x, y.
  std::array<float, 2> mouth{};           // Height, width, by the lips.
  std::array<float, 8> knobs{};           // By the stage, and all that follows.
  std::array<std::uint16_t, 4> called{};  // Face, expression, style, scene.
  float head_yaw_rad = 0;
  float head_pitch_rad = 0;
};

Pose PoseOn(const board::Board& board);

// What differs, for people; empty where nothing does. Measured values may differ a little.
std::string Differs(const Pose& before, const Pose& now);

}  // namespace kaori::test
