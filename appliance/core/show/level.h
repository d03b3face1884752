// The levels of a show: all numbers that operators, cues and remote controls may move, each between its ends
// and with a rest. One table for the roles' files, the performance, the board and the pages.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace kaori::show {

// The first eight are those of the dial box in the order of its dials. They stay where they were put; the
// others go back to their rest when nobody has them.
enum class Level : std::uint8_t {
  // How much of what was called last is seen, the rest being what was called before.
  kFace,
  kExpression,
  // How strong expressions are, and how many seconds a call of a face, an expression or a style takes.
  kStrength,
  kFade,
  // The mouth where no lips and no voice move it.
  kMouthOpen,
  kMouthWidth,
  kLife,
  kLight,
  // Degrees in files, radians here; lean is towards the audience, in centimetres and metres.
  kHeadYaw,
  kHeadPitch,
  kHeadRoll,
  kHeadLean,
  kGazeYaw,
  kGazePitch,
  // Of the whole face: brows from a frown to raised, and each lid by itself, from open to shut.
  kBrow,
  kLidLeft,
  kLidRight,
  // How much of one face or expression joins what was called; roles say of which (Roles::mixes).
  kMix1,
  kMix2,
  kMix3,
  kMix4,
  kMix5,
  kMix6,
  kMix7,
  kMix8,
};
inline constexpr std::size_t kLevelCount = 25;
inline constexpr std::size_t kMixCount = 8;
// Those that every show has, which are the first.
inline constexpr std::size_t kNamedLevels = kLevelCount - kMixCount;
inline constexpr std::size_t kStayingLevels = 8;

// What is known of a level besides its value. Texts are those of the program, and live as long.
struct LevelInfo {
  std::string_view name;  // As files and pages write it.
  float low, high, rest;  // As the performance has it: radians, metres, seconds, or a share.
  float unit;  // What one of the file's unit is in that: a degree in radians, a centimetre in metres; else 1.
  std::string_view words;  // Of the file's unit, for people; empty: none.
};

inline constexpr float kDegree = 0.017453293F;

// Head and gaze go as far as a stick pushed to its end took them in 1993's play: 35.5, 23 and 20 degrees of
// the head and 12 cm towards the audience; 31.5 and 22 degrees of the gaze. Signs are those of
// render/scene/scene.h: the character's left is the operator's right.
inline constexpr std::array<LevelInfo, kLevelCount> kLevels{{
    {"face", 0, 1, 1, 1, ""},            // How much of the called face.
    {"expression", 0, 1, 1, 1, ""},      // How much of the called expression.
    {"strength", 0, 1.4F, 1, 1, ""},     // 1 as authored.
    {"fade", 0, 4, 0.6F, 1, "s"},        // Of faces, expressions and styles that are called by hand.
    {"mouth_open", 0, 1, 0, 1, ""},      // 0 shut .. 1 open.
    {"mouth_width", 0, 1, 0.5F, 1, ""},  // 0 narrow .. 1 wide.
    {"life", 0, 1, 0.6F, 1, ""},         // What the box plays by itself.
    {"light", 0, 1.2F, 1, 1, ""},        // 0 black .. 1 as the scene is lit.
    {"head_yaw", -0.62F, 0.62F, 0, kDegree, "degrees"},
    {"head_pitch", -0.40F, 0.40F, 0, kDegree, "degrees"},
    {"head_roll", -0.35F, 0.35F, 0, kDegree, "degrees"},
    {"head_lean", 0, 0.12F, 0, 0.01F, "cm"},
    {"gaze_yaw", -0.55F, 0.55F, 0, kDegree, "degrees"},
    {"gaze_pitch", -0.38F, 0.38F, 0, kDegree, "degrees"},
    {"brow", -1, 1, 0, 1, ""},     // -1 frown .. 1 raised.
    {"lid_left", 0, 1, 0, 1, ""},  // 0 open .. 1 shut; the character's left.
    {"lid_right", 0, 1, 0, 1, ""},
    // A role names the face or the expression instead: "expression angry".
    {"mix 1", 0, 1, 0, 1, ""},
    {"mix 2", 0, 1, 0, 1, ""},
    {"mix 3", 0, 1, 0, 1, ""},
    {"mix 4", 0, 1, 0, 1, ""},
    {"mix 5", 0, 1, 0, 1, ""},
    {"mix 6", 0, 1, 0, 1, ""},
    {"mix 7", 0, 1, 0, 1, ""},
    {"mix 8", 0, 1, 0, 1, ""},
}};

// `level` must be one of the enumerators: whoever has a number from a file or a call looks at it before.
constexpr const LevelInfo& InfoOf(Level level) {
  return kLevels[static_cast<std::size_t>(level)];
}

// The level of the mix with this number, from 0.
constexpr Level MixLevel(std::size_t mix) {
  return static_cast<Level>(kNamedLevels + mix);
}
constexpr bool IsMix(Level level) {
  return static_cast<std::size_t>(level) >= kNamedLevels;
}

// Whether the level stays where it was put when nobody has it any more. Others go back to their rest.
constexpr bool Stays(Level level) {
  return static_cast<std::size_t>(level) < kStayingLevels;
}

// The nearest value between its ends, both included. `value` is finite, and in the level's own unit.
constexpr float Clamped(Level level, float value) {
  return std::clamp(value, InfoOf(level).low, InfoOf(level).high);
}

}  // namespace kaori::show
