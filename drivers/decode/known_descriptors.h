// Report descriptors of our own, for known dials whose own descriptors do not say what turns.
#pragma once

#include <cstdint>
#include <span>

namespace kaori::decode {

// For the Griffin PowerMate, the Contour Shuttle and the Elgato Stream Deck; empty for every other device,
// whose own descriptor counts. Theirs call the turning part a generic axis, or nothing at all, and the deck's
// keys bytes of its vendor. Sources of the reports' bytes: the kernel's driver powermate.c, the Shuttle's
// public descriptions, and Elgato's published HID reference. The result lives as long as the program. Pure.
std::span<const std::uint8_t> KnownDescriptor(std::uint16_t vendor, std::uint16_t product);

// The boot protocol's report (HID 1.11, appendix B.1), for keyboards that are read in it, and for
// those whose descriptor is not known. Lives as long as the program.
std::span<const std::uint8_t> BootKeyboardDescriptor();

}  // namespace kaori::decode
