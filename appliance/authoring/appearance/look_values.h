// Values as files of looks write them. What is wrong becomes a fault of the section and reads as nothing.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>

#include "appliance/authoring/sculpt/section.h"
#include "appliance/authoring/appearance/looks.h"

namespace kaori::appearance {

float Real(sculpt::Section& s, std::string_view key);
float RealOr(sculpt::Section& s, std::string_view key, float otherwise);
float Share(sculpt::Section& s, std::string_view key, float otherwise);  // 0 to 1.
float NotNegative(sculpt::Section& s, std::string_view key, float otherwise);
glm::vec3 Colour(sculpt::Section& s, std::string_view key);

// Pairs [x, y] with x rising, two or more.
Knots Pairs(sculpt::Section& s, std::string_view key);
Knots PairsOrNone(sculpt::Section& s, std::string_view key);

// Which of the words stands there.
std::size_t OneOf(sculpt::Section& s, std::string_view key, std::span<const std::string_view> words);

}  // namespace kaori::appearance
