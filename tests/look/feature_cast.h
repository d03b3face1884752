// Kaori and others painted so that a small picture can be measured: brows red, lips green, the mouth's inside and its teeth
// blue, eyeballs white, and all else black.
#pragma once

#include <span>
#include <string_view>

#include "render/face/cast.h"

namespace kaori::tests {

// The pack's cast, of which the faces with these names are painted so, and the others are black. Hair is black, and hides
// what it hides. A face that is a print is none here. Fails the program where the pack or a look cannot be read.
face::Cast FeatureCast(std::span<const std::string_view> faces);

}  // namespace kaori::tests
