// Compares a drawn picture with the one that a person has looked at and accepted.
#pragma once

#include <filesystem>
#include <string>

#include "render/image/png.h"

namespace kaori::golden {

// Pictures differ a little between processors (vector widths, rounding), never by more than this.
struct Tolerance {
  double mean = 1.0;         // Mean absolute difference of a channel, of 255.
  double far_percent = 0.5;  // Pixels that differ by more than kFar in a channel.
};
inline constexpr int kFar = 24;

// Empty when `picture` matches the accepted picture `name`; else one line that says how it differs. A picture
// that does not match is written to the folder golden of the build, to be looked at: NAME.png as it was drawn, and
// NAME-compared.png, where the accepted one, this one and their difference stand side by side. With
// KAORI_ACCEPT_GOLDEN=1 in the environment the picture is accepted instead: look at it before you commit it.
std::string Compare(const image::Picture& picture, const std::string& name, const Tolerance& tolerance = {});

}  // namespace kaori::golden
