// Which pin of the RP2040 goes where: the firmware uses this table, and so does the wiring page
// (firmware/images.py reads it).
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace kaori::rp2040 {

enum class PinUse : std::uint8_t {
  kInput,   // A line with a pull-up, closed towards ground.
  kOutput,  // Low when the power comes.
  kSpi
};

struct Pin {
  std::uint8_t gpio;
  PinUse use;
  std::string_view line;
  std::string_view goes_to;
};

// Lines A and B of dial n are GPIO 2n and 2n + 1, so that one look is one load.
inline constexpr unsigned kFirstDialPin = 0;
inline constexpr unsigned kShiftStrobePin = 17;
inline constexpr unsigned kConverterSelectPin = 13;

inline constexpr std::array kDialBoxPins = std::to_array<Pin>({
    {0, PinUse::kInput, "dial 1 A", "encoder 1, channel A"},
    {1, PinUse::kInput, "dial 1 B", "encoder 1, channel B"},
    {2, PinUse::kInput, "dial 2 A", "encoder 2, channel A"},
    {3, PinUse::kInput, "dial 2 B", "encoder 2, channel B"},
    {4, PinUse::kInput, "dial 3 A", "encoder 3, channel A"},
    {5, PinUse::kInput, "dial 3 B", "encoder 3, channel B"},
    {6, PinUse::kInput, "dial 4 A", "encoder 4, channel A"},
    {7, PinUse::kInput, "dial 4 B", "encoder 4, channel B"},
    {8, PinUse::kInput, "dial 5 A", "encoder 5, channel A"},
    {9, PinUse::kInput, "dial 5 B", "encoder 5, channel B"},
    {10, PinUse::kInput, "dial 6 A", "encoder 6, channel A"},
    {11, PinUse::kInput, "dial 6 B", "encoder 6, channel B"},
    {12, PinUse::kInput, "dial 7 A", "encoder 7, channel A"},
    {13, PinUse::kInput, "dial 7 B", "encoder 7, channel B"},
    {14, PinUse::kInput, "dial 8 A", "encoder 8, channel A"},
    {15, PinUse::kInput, "dial 8 B", "encoder 8, channel B"},
    {16, PinUse::kSpi, "buttons in", "QH (9) of the last 74HC165"},
    {17, PinUse::kOutput, "strobe", "SH/LD (1) of every 74HC165 and RCLK (12) of every 74HC595"},
    {18, PinUse::kSpi, "clock", "CLK (2) of every 74HC165 and SRCLK (11) of every 74HC595"},
    {19, PinUse::kSpi, "lamps out", "SER (14) of the first 74HC595"},
});

inline constexpr std::array kStickPodPins = std::to_array<Pin>({
    {10, PinUse::kSpi, "converter clock", "CLK (13) of the MCP3208"},
    {11, PinUse::kSpi, "converter in", "DIN (11) of the MCP3208"},
    {12, PinUse::kSpi, "converter out", "DOUT (12) of the MCP3208"},
    {13, PinUse::kOutput, "converter select", "CS (10) of the MCP3208"},
    {16, PinUse::kSpi, "switches in", "QH (9) of the 74HC165 of buttons 9 to 12 and the hat"},
    {17, PinUse::kOutput, "strobe", "SH/LD (1) of both 74HC165"},
    {18, PinUse::kSpi, "clock", "CLK (2) of both 74HC165"},
});

}  // namespace kaori::rp2040
