// Cuts a MIDI stream into messages: MIDI 1.0, with running status, messages of the system in between, and
// SysEx.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace kaori::decode {

// A message of a channel. Channels are counted from 1 here, as on devices' pages, and from 0 on the wire.
struct MidiMessage {
  enum class Kind : std::uint8_t { kNoteOff, kNoteOn, kControl, kOther };
  Kind kind = Kind::kOther;
  int channel = 1;
  std::uint8_t number = 0;  // Of the note or the control.
  std::uint8_t value = 0;   // Velocity or value; 0 of a message with one byte of data.
  std::uint8_t status = 0;  // The byte with which it began, or would have without running status.
};

// Pure; any bytes are borne. SysEx is passed over to its end, however long. A note-on of velocity 0 is a note-off, as MIDI 1.0 says.
class MidiParser {
 public:
  // The message that `byte` ends, if it ends one. Bytes of the clock may come anywhere, and change nothing.
  std::optional<MidiMessage> Accept(std::uint8_t byte);

 private:
  std::optional<MidiMessage> AcceptData(std::uint8_t byte);
  void AcceptStatus(std::uint8_t byte);

  std::uint8_t status_ = 0;  // That runs; 0: none does.
  std::array<std::uint8_t, 2> data_{};
  std::size_t data_bytes_ = 0;
};

}  // namespace kaori::decode
