// The box's board as the bench reads it: what the in-guest agent sent, as plain values.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "drivers/base/result.h"

namespace kaori::hil {

struct StickView {
  bool live = false;
  double x = 0;
  double y = 0;
  std::uint32_t port = 0;
};

struct StageView {
  bool live = false;
  std::uint32_t frames = 0;
  std::uint32_t missed_flips = 0;
  double frames_per_s = 0;
  std::uint32_t face = 0;
  std::uint32_t expression = 0;
  std::uint32_t scene = 0;
  std::int64_t read_ns =
      0;  // When input was sampled for the frame that is on the screen, by the guest's clock.
};

struct BoardView {
  std::int64_t now_ns = 0;  // The machine's clock.
  bool surface_live = false;
  std::array<std::int32_t, 8> counts{};
  std::uint32_t buttons = 0;
  std::array<std::uint32_t, 32> pushes{};
  StickView left;
  StickView right;
  bool keys_live = false;
  std::array<std::uint32_t, 8> keys_down{};
  bool pointer_live = false;
  double pointer_x = 0;
  double pointer_y = 0;
  bool lines_live = false;
  std::uint32_t lines_active = 0;
  bool lips_live = false;
  std::uint32_t lips_frames = 0;
  double lips_height = 0;
  double lips_quality = 0;
  bool voice_live = false;
  bool voice_speaking = false;
  double voice_level_db = -100;
  double voice_height = 0;
  std::uint32_t voice_blocks = 0;
  std::uint32_t lamps = 0;
  StageView stage;

  bool key_down(std::uint8_t usage) const { return (keys_down[usage / 32U] >> (usage % 32U) & 1U) != 0; }
};

// Errors: invalid_argument (not what an agent sends).
Result<BoardView> ReadBoardView(const std::string& json);

}  // namespace kaori::hil
