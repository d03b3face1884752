// How loud the voice is, and whether somebody speaks.
#pragma once

#include <cstdint>
#include <span>

#include "drivers/base/clock.h"

namespace kaori::voice {

inline constexpr float kSilent_db = -100;  // What nothing at all counts as.

// Of full scale: a sine as loud as the format allows is -3 dB; never below kSilent_db.
float Level_db(std::span<const float> samples);

struct GateSettings {
  float opens_db = -38;
  float shuts_db = -44;                            // Not above opens_db.
  Duration hold = std::chrono::milliseconds(120);  // A stop within a word is shorter.
  Duration rise = std::chrono::milliseconds(10);   // Of the level, to two thirds.
  Duration fall = std::chrono::milliseconds(60);
  friend bool operator==(const GateSettings&, const GateSettings&) = default;
};

// Pure: time is in the arguments.
class Gate {
 public:
  explicit Gate(const GateSettings& settings = {}) : settings_(settings) {}

  // Takes the level of a block that ended at `at` and lasted `length`; tells whether the voice is there. NaN
  // is silence.
  bool Accept(float level_db, Time at, Duration length);

  void Use(const GateSettings& settings) { settings_ = settings; }

  float level_db() const { return level_db_; }  // Smoothed.
  bool open() const { return open_; }

 private:
  GateSettings settings_;
  float level_db_ = kSilent_db;
  bool open_ = false;
  Time loud_at_{};  // When it was last above shuts_db.
};

}  // namespace kaori::voice
