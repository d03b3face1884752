// Kaori painted so that a small picture can be measured: brows red, lips green, the mouth's inside and its teeth blue,
// eyeballs white, and all else black.
#pragma once

#include "render/face/cast.h"

namespace kaori::tests {

// The pack's cast, of which the first face is painted so. Hair is black, and hides what it hides. Fails the program where
// the pack or the look cannot be read.
face::Cast FeatureCast();

}  // namespace kaori::tests
