#include "drivers/decode/midi.h"

namespace kaori::decode {
namespace {

// MIDI 1.0: bytes from 80 on are status bytes, those from F8 on real-time messages of one byte each.
constexpr std::uint8_t kStatusBit = 0x80;
constexpr std::uint8_t kSysEx = 0xF0;
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

// Messages of the system end what runs. No status runs within a SysEx, nor behind F7, which ends one.
void MidiParser::AcceptStatus(std::uint8_t byte) {
  status_ = byte < kSysEx ? byte : 0;
  data_bytes_ = 0;
}

// Data without a status are passed over: those of a SysEx, and those behind a system message.
std::optional<MidiMessage> MidiParser::AcceptData(std::uint8_t byte) {
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

}  // namespace kaori::decode
