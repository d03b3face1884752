// Descriptors of our own for dials that people have and whose descriptors do not say what turns.
#pragma once

#include <cstdint>
#include <span>

namespace kaori::decode {

// Griffin PowerMate and Contour Shuttle; empty for every other device, which is taken at its word.
// Bytes of the reports: kernel driver powermate.c, and the Shuttle's public descriptions.
std::span<const std::uint8_t> KnownDescriptor(std::uint16_t vendor, std::uint16_t product);

// The boot protocol's report (HID 1.11, appendix B.1), for keyboards that are read in it.
std::span<const std::uint8_t> BootKeyboardDescriptor();

}  // namespace kaori::decode
