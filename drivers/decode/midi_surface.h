// A MIDI surface as dials, buttons and lamps, by a map that people write.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "drivers/decode/dial_box.h"
#include "drivers/decode/midi.h"

namespace kaori::decode {

// How the value of a control says that its dial turned.
//   kOffset    64 more than the turn: 63 is one back, 65 one on
//   kTwos      the turn in seven bits: 127 is one back
//   kSigned    the turn, and 64 for backwards: 65 is one back
//   kAbsolute  where it stands, 0 to 127, with dead ends. The first value is no turn, and at an end it turns no further
enum class MidiDialMode : std::uint8_t { kOffset, kTwos, kSigned, kAbsolute };
inline constexpr std::array<std::string_view, 4> kMidiDialModeNames{"offset", "twos", "signed", "absolute"};

struct MidiDial {
  int channel = 1;
  std::uint8_t control = 0;
  MidiDialMode mode = MidiDialMode::kOffset;
};

// A button is a note, or a control that is held from 64 on. Its lamp is lit by the same message.
struct MidiButton {
  int channel = 1;
  std::uint8_t number = 0;
  bool is_control = false;
  bool has_lamp = false;
};

// The first dial of the list is dial 0, and so on; beyond kMaxDials and 32 buttons none counts.
struct MidiMap {
  std::vector<MidiDial> dials;
  std::vector<MidiButton> buttons;
  std::vector<std::uint8_t>
      start;           // Sent once when the device comes: it puts some into the mode that the map speaks of.
  Duration repaint{};  // Lamps are sent again so often, whether they changed or not; 0: never.
  bool any = false;  // Nobody wrote one: the lists are empty, and what comes counts by AnyDial and AnyButton.
};

// What messages of a surface without a map do, on whichever channel: controls turn dials by the lower three
// bits of their numbers, so that eight in a row are the eight dials; their whole way is a turn of 254 counts.
// Notes push buttons by the lower five bits. Pedals (controls 64 to 69 of MIDI 1.0) push the buttons 24 to
// 29; the lower halves of values (32 to 63) and messages for a channel's mode (120 on) do nothing. Nothing:
// it does neither. Pure.
std::optional<std::size_t> AnyDial(const MidiMessage& message);
std::optional<std::size_t> AnyButton(const MidiMessage& message);

// Pure; one belongs to one opened device. The map outlives it.
class MidiSurface {
 public:
  explicit MidiSurface(const MidiMap& map);

  // Returns whether the byte changed anything.
  bool Accept(std::uint8_t byte);
  // The message that the last byte ended, if it ended one, and the dial or the button of the map for which it
  // is, whether it changed anything or not.
  struct Heard {
    MidiMessage message;
    std::optional<std::size_t> dial, button;
  };
  std::optional<Heard> heard() const;
  const std::array<std::int32_t, kMaxDials>& counts() const { return counts_; }
  std::uint32_t buttons_down() const { return down_; }

  // The messages that light these lamps and darken the others, where they are not so already; all of them
  // with `again`. They count as sent.
  std::vector<std::uint8_t> LampBytes(std::uint32_t lit, bool again);
  // They were not sent: what the device shows is unknown.
  void ForgetLamps() { lit_.reset(); }

 private:
  bool Turn(const MidiMessage& message);
  bool Press(const MidiMessage& message);
  bool AcceptAny(const MidiMessage& message);
  // Whether that changed anything.
  bool Add(std::size_t dial, std::int32_t turn);
  bool Hold(std::size_t button, bool is_down);

  const MidiMap& map_;
  // For which of the map's lists the message is.
  std::optional<std::size_t> DialOf(const MidiMessage& message) const;
  std::optional<std::size_t> ButtonOf(const MidiMessage& message) const;

  MidiParser parser_;
  std::optional<MidiMessage> ended_;  // By the last byte.
  std::vector<std::optional<std::uint8_t>>
      positions_;  // Of dials that tell where they stand; of any map, by channel and control.
  std::array<std::int32_t, kMaxDials> counts_{};
  std::uint32_t down_ = 0;
  std::optional<std::uint32_t> lit_;  // As the device was last told.
};

}  // namespace kaori::decode
