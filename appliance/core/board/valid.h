// What may stand on the board: every reader checks every field before it believes a section.
//
// Memory is shared with programs that may be broken, or spoilt by somebody; what passes here can be used as an index, a
// duration or a share of something without a further check. That values fit each other, or the show, is not known here.
#pragma once

#include "appliance/core/board/sections.h"

namespace kaori::board {

// True where every field is finite and within the range that its declaration in sections.h gives. Pure. Bits
// that mean nothing (buttons, lines, lamps) may be anything. Counters may have any value, since they wrap. A
// fault here is a fault of the program that wrote: the value is passed over and nobody is told.
bool Valid(const Surface& surface);
bool Valid(const Stick& stick);
bool Valid(const Keys& keys);
bool Valid(const Lines& lines);
bool Valid(const Calls& calls);
bool Valid(const Pointer& pointer);
bool Valid(const Lips& lips);
bool Valid(const Voice& voice);
bool Valid(const Sound& sound);
bool Valid(const MotionNow& motion);
bool Valid(const LipsGuide& guide);
bool Valid(const Desk& desk);
bool Valid(const MidiHeard& heard);
bool Valid(const Lamps& lamps);
bool Valid(const ButtonCalls& calls);
bool Valid(const StageStatus& status);
bool Valid(const ShowNow& show);
bool Valid(const LineCheck& check);
bool Valid(const Learn& learn);
bool Valid(const ShowsMenu& menu);
bool Valid(const Performance& performance);
bool Valid(SourceState source);
// From the machine's start on, and so that readers may reckon with it.
bool Valid(Time at);

}  // namespace kaori::board
