// The last MIDI messages on the board, with what they were for.
#pragma once

#include <cstdint>
#include <vector>

#include "appliance/core/board/board.h"
#include "appliance/programs/input/surface_map.h"
#include "drivers/ports/midi_tap.h"

namespace kaori::input {

// Goes on from what the board holds. One thread; allocates nothing.
class MidiSection {
 public:
  // Borrows the maps. The board is not kept.
  MidiSection(const board::Board& board, board::Writer<board::MidiHeard> writer,
              const std::vector<SurfaceMap>& maps)
      : writer_(std::move(writer)), maps_(maps), heard_(board.Read<board::MidiHeard>().value) {}

  // Publishes what was heard since the last call, the newest where more came than the tap keeps.
  void Publish(const ports::MidiTap& tap);

 private:
  board::MidiHeard::Message MessageOf(const ports::MidiHeard& heard) const;

  board::Writer<board::MidiHeard> writer_;
  const std::vector<SurfaceMap>& maps_;
  board::MidiHeard heard_;
  std::uint32_t seen_ = 0;  // Of the tap's count.
};

}  // namespace kaori::input
