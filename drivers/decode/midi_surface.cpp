#include "drivers/decode/midi_surface.h"

#include <algorithm>

namespace kaori::decode {
namespace {

// The middle of the seven bits: no turn where a value is an offset, and the least that holds a control's
// button.
constexpr int kMiddle = 64;
constexpr std::uint8_t kFull = 127;
constexpr std::size_t kMostButtons = 32;
// Of a surface without a map.
constexpr std::size_t kChannels = 16, kNumbers = 128;
constexpr std::size_t kAnyPositions = kChannels * kNumbers;
constexpr std::int32_t kAnyCounts = 2;  // Of each step of a control.
constexpr int kFirstLowerHalf = 32, kFirstPedal = 64, kLastPedal = 69, kFirstPedalButton = 24,
              kFirstMode = 120;

// Detents or ticks, as the device counts them, clockwise positive. Positions are differenced by the caller.
std::int32_t TurnOf(MidiDialMode mode, int value) {
  switch (mode) {
    case MidiDialMode::kOffset:
      return value - kMiddle;
    case MidiDialMode::kTwos:
      return value < kMiddle ? value : value - 2 * kMiddle;
    case MidiDialMode::kSigned:
      return value < kMiddle ? value : kMiddle - value;
    case MidiDialMode::kAbsolute:
      break;
  }
  return 0;
}

}  // namespace

std::optional<std::size_t> AnyDial(const MidiMessage& message) {
  const int control = message.number;
  const bool is_meant = message.kind == MidiMessage::Kind::kControl && control < kFirstMode &&
                        (control < kFirstLowerHalf || control > kLastPedal);
  return is_meant ? std::optional(static_cast<std::size_t>(control) % kMaxDials) : std::nullopt;
}

std::optional<std::size_t> AnyButton(const MidiMessage& message) {
  const int number = message.number;
  if (message.kind == MidiMessage::Kind::kNoteOn || message.kind == MidiMessage::Kind::kNoteOff)
    return static_cast<std::size_t>(number) % kMostButtons;
  if (message.kind != MidiMessage::Kind::kControl || number < kFirstPedal || number > kLastPedal)
    return std::nullopt;
  return static_cast<std::size_t>(kFirstPedalButton + number - kFirstPedal);
}

MidiSurface::MidiSurface(const MidiMap& map)
    : map_(map), positions_(map.any ? kAnyPositions : map.dials.size()) {}

// A control that is no dial of the map, or did not turn it, may still be a button.
bool MidiSurface::Accept(std::uint8_t byte) {
  const auto message = ended_ = parser_.Accept(byte);
  if (!message || message->kind == MidiMessage::Kind::kOther) return false;
  if (map_.any) return AcceptAny(*message);
  return message->kind == MidiMessage::Kind::kControl && Turn(*message) ? true : Press(*message);
}

std::optional<MidiSurface::Heard> MidiSurface::heard() const {
  if (!ended_) return std::nullopt;
  return Heard{*ended_, DialOf(*ended_), ButtonOf(*ended_)};
}

// Where each control stands is known by its channel and number: two of them may turn one dial.
bool MidiSurface::AcceptAny(const MidiMessage& message) {
  const bool is_control = message.kind == MidiMessage::Kind::kControl;
  if (const auto button = AnyButton(message))
    return Hold(*button, is_control ? message.value >= kMiddle : message.kind == MidiMessage::Kind::kNoteOn);
  const auto dial = AnyDial(message);
  if (!dial) return false;
  auto& position = positions_[static_cast<std::size_t>(message.channel - 1) * 128 + message.number];
  const std::int32_t turn = kAnyCounts * (message.value - position.value_or(message.value));
  position = message.value;
  return Add(*dial, turn);
}

// Counts wrap at 32 bits by unsigned arithmetic.
bool MidiSurface::Add(std::size_t dial, std::int32_t turn) {
  counts_[dial] =
      static_cast<std::int32_t>(static_cast<std::uint32_t>(counts_[dial]) + static_cast<std::uint32_t>(turn));
  return turn != 0;
}

// A message that repeats what is known already changes nothing, so that no report is made of it.
bool MidiSurface::Hold(std::size_t button, bool is_down) {
  const std::uint32_t bit = std::uint32_t{1} << button;
  const std::uint32_t before = down_;
  down_ = is_down ? down_ | bit : down_ & ~bit;
  return down_ != before;
}

// The first dial of the map with this channel and control counts.
std::optional<std::size_t> MidiSurface::DialOf(const MidiMessage& message) const {
  if (message.kind != MidiMessage::Kind::kControl) return std::nullopt;
  if (map_.any) return AnyButton(message) ? std::nullopt : AnyDial(message);
  for (std::size_t n = 0; n < std::min(map_.dials.size(), counts_.size()); ++n)
    if (map_.dials[n].channel == message.channel && map_.dials[n].control == message.number) return n;
  return std::nullopt;
}

bool MidiSurface::Turn(const MidiMessage& message) {
  const auto n = DialOf(message);
  if (!n) return false;
  const MidiDial& dial = map_.dials[*n];
  std::int32_t turn = TurnOf(dial.mode, message.value);
  if (dial.mode == MidiDialMode::kAbsolute) {
    turn = message.value - positions_[*n].value_or(message.value);
    positions_[*n] = message.value;
  }
  return Add(*n, turn);
}

std::optional<std::size_t> MidiSurface::ButtonOf(const MidiMessage& message) const {
  if (message.kind == MidiMessage::Kind::kOther) return std::nullopt;
  if (map_.any) return AnyButton(message);
  const bool is_control = message.kind == MidiMessage::Kind::kControl;
  const auto is_meant = [&](const MidiButton& button) {
    return button.is_control == is_control && button.channel == message.channel &&
           button.number == message.number;
  };
  const auto found = std::ranges::find_if(map_.buttons, is_meant);
  const auto n = static_cast<std::size_t>(found - map_.buttons.begin());
  return found != map_.buttons.end() && n < kMostButtons ? std::optional(n) : std::nullopt;
}

bool MidiSurface::Press(const MidiMessage& message) {
  const bool is_control = message.kind == MidiMessage::Kind::kControl;
  const bool is_down = is_control ? message.value >= kMiddle : message.kind == MidiMessage::Kind::kNoteOn;
  const auto button = ButtonOf(message);
  return button && Hold(*button, is_down);
}

// Note-on or control change, by what the button itself sends; value 127 lights and 0 darkens, since a note-on
// of velocity 0 is a note-off (MIDI 1.0).
std::vector<std::uint8_t> MidiSurface::LampBytes(std::uint32_t lit, bool again) {
  std::vector<std::uint8_t> bytes;
  for (std::size_t n = 0; n < std::min(map_.buttons.size(), kMostButtons); ++n) {
    const MidiButton& button = map_.buttons[n];
    const bool is_lit = (lit >> n & 1U) != 0;
    const bool is_known = lit_ && (*lit_ >> n & 1U) == (is_lit ? 1U : 0U);
    if (!button.has_lamp || (is_known && !again)) continue;
    const unsigned status = (button.is_control ? 0xB0U : 0x90U) + static_cast<unsigned>(button.channel - 1);
    for (const unsigned byte : {status, unsigned{button.number}, is_lit ? unsigned{kFull} : 0U})
      bytes.push_back(static_cast<std::uint8_t>(byte));
  }
  lit_ = lit;
  return bytes;
}

}  // namespace kaori::decode
