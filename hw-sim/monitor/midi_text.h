// A MIDI message as the makers of surfaces write it.
#pragma once

#include <string>

#include "appliance/core/board/sections.h"

namespace kaori::sim {

// "CC 21 = 64", "note 36 on, velocity 100", "note 36 off", "program 5", "pitch bend 8192"; on another channel than the
// first "channel 11: CC 1 = 3".
std::string MidiText(const board::MidiHeard::Message& message);

}  // namespace kaori::sim
