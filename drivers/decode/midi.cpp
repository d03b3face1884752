#include "drivers/decode/midi.h"

namespace kaori::decode {
namespace {

// MIDI 1.0: bytes from 80 on are status bytes, those from F8 on real-time messages of one byte each.
constexpr std::uint8_t kStatusBit = 0x80;
constexpr std::uint8_t kSysEx = 0xF0;
constexpr std::uint8_t kEndOfSysEx = 0xF7;
constexpr std::uint8_t kFirstRealTime = 0xF8;

// Program change and channel pressure have one byte of data, all other messages of a channel two.
std::size_t DataBytesOf(std::uint8_t status) {
  const unsigned kind = status >> 4U;
  return kind == 0xC || kind == 0xD ? 1 : 2;
}

}  // namespace

std::optional<MidiMessage> MidiParser::Accept(std::uint8_t byte) {
  if (byte >= kFirstRealTime) return std::nullopt;
  if ((byte & kStatusBit) == 0) return AcceptData(byte);
  AcceptStatus(byte);
  return std::nullopt;
}

// Messages of the system end what runs; any status ends a SysEx, and only F7 makes it whole.
void MidiParser::AcceptStatus(std::uint8_t byte) {
  if (byte == kEndOfSysEx) sysex_is_whole_ = in_sysex_ && sysex_bytes_ <= kMostSysExBytes;
  in_sysex_ = byte == kSysEx;
  if (in_sysex_) {
    sysex_bytes_ = 0;
    sysex_is_whole_ = false;
  }
  status_ = byte < kSysEx ? byte : 0;
  data_bytes_ = 0;
}

// Of a SysEx that is too long the count goes one beyond the limit, and no further: by that its end tells that
// it is not whole. Data without a status are passed over, as after a system message.
std::optional<MidiMessage> MidiParser::AcceptData(std::uint8_t byte) {
  if (in_sysex_) {
    if (sysex_bytes_ < kMostSysExBytes) sysex_[sysex_bytes_] = byte;
    if (sysex_bytes_ <= kMostSysExBytes) ++sysex_bytes_;
    return std::nullopt;
  }
  if (status_ == 0) return std::nullopt;
  data_[data_bytes_++] = byte;
  if (data_bytes_ < DataBytesOf(status_)) return std::nullopt;
  data_bytes_ = 0;
  const bool has_value = DataBytesOf(status_) > 1;
  MidiMessage message{.channel = (status_ & 0x0F) + 1,
                      .number = data_[0],
                      .value = has_value ? data_[1] : std::uint8_t{0},
                      .status = status_};
  const unsigned kind = status_ >> 4U;
  if (kind == 0x8 || (kind == 0x9 && message.value == 0)) message.kind = MidiMessage::Kind::kNoteOff;
  if (kind == 0x9 && message.value != 0) message.kind = MidiMessage::Kind::kNoteOn;
  if (kind == 0xB) message.kind = MidiMessage::Kind::kControl;
  return message;
}

std::span<const std::uint8_t> MidiParser::sysex() const {
  return std::span(sysex_).first(sysex_is_whole_ ? sysex_bytes_ : 0);
}

}  // namespace kaori::decode
