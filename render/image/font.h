// The bytes of the fonts that the program carries.
#pragma once

#include <cstddef>
#include <span>

namespace kaori::image {

// A TrueType file: Debian's fonts-dejavu-core without the instructions for its outlines; lives as long as the program.
std::span<const std::byte> FontBytes();

// The same, packed by gzip, for letters that the first one lacks: those of japanese.txt out of Debian's
// fonts-motoya-l-cedar, cut when the program was built.
std::span<const std::byte> PackedJapaneseFont();

}  // namespace kaori::image
