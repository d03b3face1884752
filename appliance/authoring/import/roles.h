// From the names that artists give their shapes to the roles that a show plays.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "appliance/authoring/import/model.h"

namespace kaori::import {

enum class NameStyle : std::uint8_t { kArkit, kVrm1, kVrm0, kViseme, kPlain };
std::string_view NameOf(NameStyle style);

// What an artist's name means: the style's own spelling of it.
struct Meaning {
  NameStyle style = NameStyle::kPlain;
  std::string name;  // "eyeBlinkLeft", "viseme_aa".
};

// Case, underscores, spaces, dots and dashes do not matter, nor does what stands before the last dot or colon
// ("face.eyeBlink_L"); "_L" and "_R" at the end mean left and right. VRM's names count only for presets.
enum class NameOrigin : std::uint8_t { kTarget, kPreset };
std::optional<Meaning> MeaningOf(std::string_view name, NameOrigin origin);

// A role is the weighted sum of shapes of one style. Positions in `shapes` as given to FindRoles.
struct RolePart {
  std::size_t shape = 0;
  float weight = 1;
};
struct Role {
  std::string name;  // As the show says it: "brow_up_left", "jaw_open", "a".
  NameStyle style = NameStyle::kPlain;
  std::vector<RolePart> parts;
};

// `meanings`: for each shape what its name means. A role is made of the first style that has all or the most
// telling of its parts; roles for which nothing is there are left out.
std::vector<Role> FindRoles(const std::vector<std::optional<Meaning>>& meanings);

// All roles that FindRoles knows, each once.
std::vector<std::string> KnownRoles();

// The target whose name means just this role; null where there is none.
const Target* FindTarget(const Model& model, std::string_view role);

}  // namespace kaori::import
