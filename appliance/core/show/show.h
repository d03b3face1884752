// A show: the cast, and what each control of the operators calls up. Checked once, when it is loaded. Plain
// values that own all they refer to by index; read-only once it plays, but for the expressions that the
// editor renews (Studio::Renew).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "appliance/core/show/call.h"
#include "appliance/core/show/cue.h"
#include "appliance/core/show/fade.h"
#include "appliance/core/show/life.h"
#include "appliance/core/show/lobby.h"
#include "appliance/core/show/motion.h"
#include "appliance/core/show/roles.h"
#include "render/face/cast.h"
#include "render/scene/scene.h"

namespace kaori::show {

// What CheckShow allows. Fades that are longer are written in the wrong unit.
inline constexpr float kLongestFade_s = 60;
inline constexpr float kMostExposure = 4;
inline constexpr std::size_t kMostItems =
    4096;  // Faces, expressions, props ...: each has an index of 16 bits.
inline constexpr std::uint16_t kKeyUsages = 256;

// A key of the keyboard that calls what a button may call. `key_usage` is a usage of HID page 7, below
// kKeyUsages.
struct KeyCall {
  std::uint16_t key_usage = 0;
  Call call;
};

// What a scene change sets, all at once, each with its own fade. The fade's length is in seconds, 0 ..
// kLongestFade_s; the exposure multiplies all light, 0 .. kMostExposure.
struct StageScene {
  std::string name;
  std::uint16_t key_usage = 0;
  std::uint16_t face = 0;
  std::uint16_t expression = 0;
  scene::Style style = scene::Style::kSoft;
  scene::Backdrop backdrop;
  float exposure = 1;
  float fade_s = 0.8F;
  LifeAmounts life = kWholeLife;
  std::int32_t gaze = kNoTarget;  // Of the show's targets.
};

// Names of expressions that the stage needs by role; -1 where the show has none.
struct Channels {
  std::array<int, 2> brow_up{-1, -1};  // The character's left, right.
  int brow_frown = -1;
  int lids_up = -1;                          // Upper lids follow a gaze that rises,
  int lids_down = -1;                        // and one that falls.
  std::array<int, 4> mouth{-1, -1, -1, -1};  // Shut narrow, shut wide, open narrow, open wide.
};

// Everything that one evening plays. It may hold a few hundred megabytes: it is moved, and not copied.
struct Show {
  std::string name;
  face::Cast cast;
  // By the number of the button, from 0; kNothing for one that calls nothing. The buttons have two sheets,
  // between which calls of CallKind::kSheet change.
  std::array<Call, kButtonCount> buttons{}, second_buttons{};
  // Of the left stick, then of the right one; the roles.toml of the show fills them, and that of the box.
  std::array<Call, std::size_t{2} * kStickButtonCount> stick_buttons{};
  // By the indices of the cast; items behind their ends have none of their own.
  std::vector<ItemFade> face_fades, expression_fades;
  // Keys that call what buttons call; motions and scenes have keys of their own.
  std::vector<KeyCall> keys;
  std::vector<Motion> motions;
  std::vector<StageScene> scenes;
  Channels channels;
  CueList cue_list;
  Roles roles = UsualRoles();
  // What she can look at; the first one is the house (HouseOf).
  std::vector<GazeTarget> gaze_targets;
  std::optional<Lobby> lobby;  // None: she stays as the operators leave her.
};

// The item's own fade; one without its own times, where it has none.
inline ItemFade FadeOf(const Show& show, const Call& call) {
  const bool face = call.kind == CallKind::kFace;
  if (!face && call.kind != CallKind::kExpression) return {};
  const std::vector<ItemFade>& fades = face ? show.face_fades : show.expression_fades;
  return call.index < fades.size() ? fades[call.index] : ItemFade{};
}

}  // namespace kaori::show
