// Values as files of looks write them. What is wrong becomes a fault of the section and reads as nothing.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "appliance/authoring/appearance/looks.h"
#include "appliance/core/toml/section.h"

namespace kaori::appearance {

// A number, as float; a fault where it is missing.
float Real(toml::Section& s, std::string_view key);
// The same, or `otherwise` where there is none.
float RealOr(toml::Section& s, std::string_view key, float otherwise);
// A number from 0 to 1.
float Share(toml::Section& s, std::string_view key, float otherwise);
// A number from 0 on.
float NotNegative(toml::Section& s, std::string_view key, float otherwise);
// "#rrggbb", as linear light; black where it is none.
glm::vec3 Colour(toml::Section& s, std::string_view key);

// Two numbers [x, y].
glm::vec2 Pair(toml::Section& s, std::string_view key);
// A list of such pairs in any order.
std::vector<glm::vec2> Positions(toml::Section& s, std::string_view key);

// Pairs [x, y] with x rising, two or more.
Knots Pairs(toml::Section& s, std::string_view key);
// The same, or an empty table where there is none.
Knots PairsOrNone(toml::Section& s, std::string_view key);

// The index of the word that stands there; 0 where it is none of them.
std::size_t OneOf(toml::Section& s, std::string_view key, std::span<const std::string_view> words);

}  // namespace kaori::appearance
