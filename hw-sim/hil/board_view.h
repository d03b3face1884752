// The box's board as the bench reads it: what the in-guest agent sent, as plain values.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "drivers/base/result.h"

namespace kaori::hil {

// A joystick of the board. Values are the box's: after dead zone and centre.
// `port` is a number that the box made of the port's name, so that equal sticks can be told apart.
struct StickView {
  // Its device is there and delivers, and the program that reads it runs; else the values are those that were read last.
  bool live = false;
  // Between the stops, -1 .. 1: right and forwards are positive.
  double x = 0;
  double y = 0;
  // Equal sticks differ in it alone.
  std::uint32_t port = 0;
};

// What the stage tells of itself.
struct StageView {
  // It runs: it holds the right to write this.
  bool live = false;
  // Presented since the board began, by whichever stage: a new program counts on.
  std::uint32_t frames = 0;
  // Vertical blanks at which no new frame was ready.
  std::uint32_t missed_flips = 0;
  // As the stage measures it.
  double frames_per_s = 0;
  // Numbers of what is shown, as the show counts them, from 0.
  std::uint32_t face = 0;
  std::uint32_t expression = 0;
  std::uint32_t scene = 0;
  // When input was sampled for the frame that is on the screen, by the guest's clock.
  std::int64_t read_ns = 0;
};

// One look at all sections of the board, each as it was at that moment. A section whose writer is away
// keeps its last values and is not live. Units are those of appliance/core/board.
struct BoardView {
  // The machine's clock.
  std::int64_t now_ns = 0;
  // Of the dial box.
  bool surface_live = false;
  // Accumulated; clockwise is positive; 256 a turn of the simulated box.
  std::array<std::int32_t, 8> counts{};
  // Bit n: button n is held.
  std::uint32_t buttons = 0;
  // How often each button was pressed; wraps after 2^32.
  std::array<std::uint32_t, 32> pushes{};
  StickView left;
  StickView right;
  bool keys_live = false;
  // Bit u % 32 of word u / 32: the key of usage u is held.
  std::array<std::uint32_t, 8> keys_down{};
  bool pointer_live = false;
  // 0 at the left and the upper edge, 1 at the right and the lower one.
  double pointer_x = 0;
  double pointer_y = 0;
  // When a device of those above was last plugged in or heard, by the guest's clock; of those that were ever
  // there, that for which it is longest ago.
  std::int64_t input_at_ns = 0;
  // The same of that which was plugged in or heard last.
  std::int64_t newest_input_ns = 0;
  bool lines_live = false;
  // Bit n: input line n is active, as the box's settings have it: active low is turned round already.
  std::uint32_t lines_active = 0;
  bool lips_live = false;
  // When the picture was taken that was measured last, by the guest's clock.
  std::int64_t lips_at_ns = 0;
  // Camera frames that were measured since the lip program began.
  std::uint32_t lips_frames = 0;
  // In widths of the mouth at rest.
  double lips_height = 0;
  // 0 nothing was found .. 1 the lip reader is sure.
  double lips_quality = 0;
  bool voice_live = false;
  // Loud enough to move the mouth, by the lip program's own threshold.
  bool voice_speaking = false;
  // Of full scale; -100 is silence.
  double voice_level_db = -100;
  // How far the voice opens the mouth, as lips_height does.
  double voice_height = 0;
  // Blocks of sound that were heard since the program began.
  std::uint32_t voice_blocks = 0;
  // Bit n: the stage wants lamp n lit.
  std::uint32_t lamps = 0;
  StageView stage;
  // Numbers of the show's cues, from 0. The cue that was played last, and the one that comes by itself; -1:
  // none.
  int cue_active = -1;
  int cue_pending = -1;
  // What GO plays next.
  int cue_standby = 0;
  // In radians, as the stage plays them.
  // Of the levels, not of the picture: a head that eases over is still on its way there.
  double head_yaw_rad = 0;
  double gaze_yaw_rad = 0;
  // By which a visitor of the desk pairs, as the screen shows it; -1: it shows none.
  int desk_code = -1;

  // `usage` is of HID page 7.
  bool key_down(std::uint8_t usage) const { return (keys_down[usage / 32U] >> (usage % 32U) & 1U) != 0; }
};

// Reads what the agent's question "board" answers: one JSON object. Errors:
// invalid_argument (not what an agent sends). Pure.
Result<BoardView> ReadBoardView(const std::string& json);

}  // namespace kaori::hil
