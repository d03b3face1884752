// What the performance remembers of the levels, and of the controls that move them.
#pragma once

#include <array>
#include <cstdint>

#include "appliance/core/show/level.h"
#include "appliance/core/show/roles.h"

namespace kaori::performance {

// Who has a level: of several that claim it the last of this list. Life and registered motions add to what
// stands here; the lips and the voice have the mouth where no dial does (mouth.h).
enum class Owner : std::uint8_t {
  kRest,    // Nobody: it stays where it was put, or goes back to its rest (show::Stays).
  kCue,     // A cue or a call put it there.
  kRemote,  // A remote control, until a second after its last word.
  kHand,    // A role's controls.
};
inline constexpr std::uint8_t kOwnerCount = 4;

// SmoothStep rises by 1.5 of its length at its steepest: with this much of a second for a whole range no
// frame of a 60th of a second moves by more than 2 % of it.
inline constexpr float kEaseOfRange_s = 1.25F;

// One level, in its own unit (show::LevelInfo). Plain bytes, a part of State.
struct LevelNow {
  float value = 0;          // As its owner wants it, with what is left of the hand-over.
  float base = 0;           // What the owning role's dials have added to where its other controls stand.
  float offset = 0;         // What the value was beside the owner's when it came to own: eases out
  float ease_s = 0;         // in this time,
  float eased_s = 0;        // of which so much has passed.
  float rest_s = 0;         // For how long the owning role's controls have said nothing.
  float remote = 0;         // What a remote control said last,
  float remote_left_s = 0;  // and how long that counts.
  Owner owner = Owner::kRest;
  std::uint8_t role = 0;    // Of the show's roles, where the owner is a hand.
  std::uint8_t let_go = 0;  // Bit n: role n has it again only when its control has been moved.
  std::uint8_t put = 0;     // 1: it was put elsewhere since the last frame; roles begin anew.
};

// A control of a role; in the order of the roles and of their maps.
struct MapNow {
  float way = 0;            // Of its control at the last frame.
  float anchor = 0;         // Where it was when the role last had not, or no longer had, the level.
  float value = 0;          // What it contributes.
  float untaken_s = 10;     // Since a movement of it was taken, for Takeover::kPickUp.
  std::uint32_t known = 0;  // 1: `way` was seen, and a movement is one.
};

inline constexpr std::uint8_t kNoDevice = show::kDeviceCount;  // A role that nobody plays.
inline constexpr std::uint8_t kNoRole = kNoDevice + 1;         // There is no such role.

// All levels at their rests.
constexpr std::array<LevelNow, show::kLevelCount> RestingLevels() {
  std::array<LevelNow, show::kLevelCount> levels{};
  for (std::size_t i = 0; i < levels.size(); ++i) levels[i].value = show::kLevels[i].rest;
  return levels;
}

}  // namespace kaori::performance
