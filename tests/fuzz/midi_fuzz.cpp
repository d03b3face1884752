// Any bytes of a MIDI surface: they bear no harm, and turn a dial by no more than a message can say.
#include <cstdlib>

#include "drivers/decode/midi_surface.h"
#include "tests/fuzz/check.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  decode::MidiMap map;
  for (int n = 0; n < 8; ++n)
    map.dials.push_back({.channel = 1 + n % 2,
                         .control = static_cast<std::uint8_t>(n),
                         .mode = static_cast<decode::MidiDialMode>(n % 4)});
  for (int n = 0; n < 40; ++n)
    map.buttons.push_back(
        {.channel = 2, .number = static_cast<std::uint8_t>(n), .is_control = n % 2 == 0, .has_lamp = true});
  decode::MidiSurface surface(map);
  decode::MidiParser parser;
  for (std::size_t n = 0; n < size; ++n) {
    const auto before = surface.counts();
    surface.Accept(data[n]);
    for (std::size_t dial = 0; dial < before.size(); ++dial)
      fuzz::Promise(std::abs(surface.counts()[dial] - before[dial]) <= 127, "a message turns by 127 at most");
    if (const auto message = parser.Accept(data[n]))
      fuzz::Promise(
          message->number < 128 && message->value < 128 && message->channel >= 1 && message->channel <= 16,
          "numbers have seven bits");
    if (n % 16 == 0) surface.LampBytes(data[n] * 0x01010101U, n % 32 == 0);
  }
  return 0;
}
