// From the names that artists give their shapes to the roles that a show plays.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/authoring/model/model.h"

namespace kaori::import {

using model::Model;
using model::Target;

// Whose vocabulary a name is from: Apple's ARKit, VRM 1.0 and 0.x, the lip-sync visemes of Oculus (Meta), or
// plain words that artists use.
enum class NameStyle : std::uint8_t { kArkit, kVrm1, kVrm0, kViseme, kPlain };
// For people: "ARKit", "VRM 1.0".
std::string_view NameOf(NameStyle style);

// What an artist's name means: the style's own spelling of it.
struct Meaning {
  NameStyle style = NameStyle::kPlain;
  std::string name;  // "eyeBlinkLeft", "viseme_aa".
};

// Where a name was found. VRM's names count only for presets, since "a" or "blink" as a target
// may mean anything.
enum class NameOrigin : std::uint8_t { kTarget, kPreset };
// Case, underscores, spaces, dots and dashes do not matter, nor does what stands before the last dot or colon
// ("face.eyeBlink_L"); "_L" and "_R" at the end mean left and right. Names of presets must be spelled as
// their style spells them, apart from case: "blink_l" is VRM 0.x, "blinkLeft" is VRM 1.0. None for a word
// that no style has.
std::optional<Meaning> MeaningOf(std::string_view name, NameOrigin origin);

// A shape by its position in the list given to FindRoles, and how much of it.
struct RolePart {
  std::size_t shape = 0;
  float weight = 1;
};
// A role is the weighted sum of shapes of one style. Styles are not mixed: each has its own idea of how far a
// whole jaw opens.
struct Role {
  std::string name;  // As the show says it: "brow_up_left", "jaw_open", "a".
  NameStyle style = NameStyle::kPlain;
  std::vector<RolePart> parts;
};

// `meanings`: for each shape what its name means. A role is made of the first style, in the order ARKit,
// visemes, VRM 1.0, VRM 0.x, plain, that has its first entry of the table; further entries join where they
// are there. Roles for which nothing is there are left out.
std::vector<Role> FindRoles(const std::vector<std::optional<Meaning>>& meanings);

// All roles that FindRoles knows, each once.
std::vector<std::string> KnownRoles();

// The first target whose name means just this role, at its whole weight; null where there is none. Borrowed
// from `model`. Used before roles are made, where parts are told by how they move.
const Target* FindTarget(const Model& model, std::string_view role);

}  // namespace kaori::import
