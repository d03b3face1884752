// The level of the voice, and the gate that says whether somebody speaks. The gate tells a voice from the
// noise of a stage: it opens at one level, shuts at a lower one, and stays open over pauses within a word.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/clock.h"

namespace kaori::voice {

inline constexpr float kSilent_db = -100;  // The level of silence.

// The level in dB of full scale (dBFS by RMS): a sine of full scale has -3 dB. Never below kSilent_db.
float Level_db(std::span<const float> samples);

// Levels are in dB of full scale.
struct GateSettings {
  float opens_db = -38;  // The level at which the gate opens.
  float shuts_db = -44;  // The level below which it shuts; not above opens_db.
  Duration hold =
      std::chrono::milliseconds(120);  // How long it stays open below that; pauses in a word are shorter.
  Duration rise = std::chrono::milliseconds(10);  // How soon the smoothed level follows a rise to two thirds,
  Duration fall = std::chrono::milliseconds(60);  // and a fall.
  friend bool operator==(const GateSettings&, const GateSettings&) = default;
};

// Pure: time is in the arguments. One thread.
class Gate {
 public:
  explicit Gate(const GateSettings& settings = {}) : settings_(settings) {}

  // Handles the level of a block that ended at `at` and lasted `length`. Returns whether the gate is open.
  // NaN is silence.
  bool Accept(float level_db, Time at, Duration length);

  // Other settings from the next block on; an open gate stays open until they shut it.
  void Use(const GateSettings& settings) { settings_ = settings; }

  float level_db() const { return level_db_; }  // Smoothed.
  // Whether somebody speaks, as of the last level.
  bool open() const { return open_; }

 private:
  GateSettings settings_;
  float level_db_ = kSilent_db;
  bool open_ = false;
  Time loud_at_{};  // When the level was last above shuts_db.
};

}  // namespace kaori::voice
