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
float RealOr(toml::Section& s, std::string_view key, float otherwise);
float Share(toml::Section& s, std::string_view key, float otherwise);  // 0 to 1.
float NotNegative(toml::Section& s, std::string_view key, float otherwise);
glm::vec3 Colour(toml::Section& s, std::string_view key);

// Two numbers [x, y], and a list of such pairs in any order.
glm::vec2 Pair(toml::Section& s, std::string_view key);
std::vector<glm::vec2> Positions(toml::Section& s, std::string_view key);

// Pairs [x, y] with x rising, two or more.
Knots Pairs(toml::Section& s, std::string_view key);
Knots PairsOrNone(toml::Section& s, std::string_view key);

// Which of the words stands there.
std::size_t OneOf(toml::Section& s, std::string_view key, std::span<const std::string_view> words);

}  // namespace kaori::appearance
