#include "hw-sim/monitor/midi_text.h"

#include <fmt/format.h>

namespace kaori::sim {
namespace {

// By the upper half of the status byte (MIDI 1.0, table 1).
std::string InWords(unsigned kind, unsigned number, unsigned value) {
  switch (kind) {
    case 0x8:
      return fmt::format("note {} off", number);
    case 0x9:
      return value == 0 ? fmt::format("note {} off", number)
                        : fmt::format("note {} on, velocity {}", number, value);
    case 0xA:
      return fmt::format("note {} pressed {}", number, value);
    case 0xB:
      return fmt::format("CC {} = {}", number, value);
    case 0xC:
      return fmt::format("program {}", number);
    case 0xD:
      return fmt::format("channel pressed {}", number);
    case 0xE:
      return fmt::format("pitch bend {}", number | value << 7U);
    default:
      return fmt::format("byte {:02X}", kind << 4U);
  }
}

}  // namespace

std::string MidiText(const board::MidiHeard::Message& message) {
  const unsigned status = message.bytes & 0xFFU;
  const std::string words = InWords(status >> 4U, message.bytes >> 8U & 0x7FU, message.bytes >> 16U & 0x7FU);
  const unsigned channel = (status & 0x0FU) + 1;
  return channel == 1 ? words : fmt::format("channel {}: {}", channel, words);
}

}  // namespace kaori::sim
