// Decodes the serial dial and button boxes of 1993: bytes with their times to turns and buttons.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/decode/dial_box.h"

namespace kaori::decode {

// The dialects, 9600 baud 8N1 all of them. Sources of the bytes: VRPN's vrpn_raw_sgibox, freeglut's
// fg_input_devices, and the cctalk list of April 2018 on two real boxes.
//   kSgi              SN-921. Mute until it is asked. A dial sends 30+n HH LL: where it stands, 16 bits that wrap
//   kSpectragraphics  asked as the SN-921. A dial sends 30+n b c: it turned by b - c
//   kDls80            DLS80-1022 and HP A4362A. Speaks unasked. A dial sends 80+n HH LL: by how much it turned, clockwise positive
enum class SerialBox : std::uint8_t { kSgi, kSpectragraphics, kDls80 };
inline constexpr std::array<std::string_view, 3> kSerialBoxNames{"sgi", "spectragraphics", "dls80"};

// A message is whole within this time, and silence for this long begins anew.
inline constexpr Duration kSerialGap = std::chrono::milliseconds(10);

// The rule of resynchronising. Three bytes without a mark can be read in three ways, so that no decoder finds
// back to them by their values alone. Where a byte begins no message, or a dial jumps by more than a third of
// a turn, the line is only watched until it was silent for kSerialGap; what comes then is a beginning. A
// fault lets one false value pass at most, but for a few in a million where a byte looks right by chance; it
// is bounded by that jump, and none passes after the next gap. Pure; one decoder belongs to one opened line.
class SerialDialDecoder {
 public:
  // `counts_per_turn` is 1 to 2^20.
  SerialDialDecoder(SerialBox box, int counts_per_turn);

  // Accepts the next byte, which arrived at `at`. Returns whether the counts or the buttons changed.
  bool Accept(std::uint8_t byte, Time at);
  // What silence until `now` confirms: a button right behind a dial's message may be a dial's byte that is
  // out of step, and waits for the gap or for the next whole message. Returns whether a button changed.
  bool Settle(Time now);

  // Turns since the decoder began, clockwise positive; they wrap. The first position of a dial that tells
  // positions is no turn.
  const std::array<std::int32_t, kMaxDials>& counts() const { return counts_; }
  std::uint32_t buttons_down() const { return buttons_down_; }  // Bit n: button n is held.
  // Messages that were passed over, and those that were whole.
  std::uint32_t torn() const { return torn_; }
  std::uint32_t whole() const { return whole_; }
  // How often the box said, after silence, that it has begun anew: then it reports nothing until it is told to, and its
  // dials stand elsewhere.
  std::uint32_t resets() const { return resets_; }
  // Much of what came lately was no message, or nothing for a second: the line has another speed, or another
  // device.
  bool is_strange() const;

 private:
  enum class State : std::uint8_t { kBetween, kWithin, kWatching };
  bool Begin(std::uint8_t byte, Time at);
  bool AcceptButton(std::uint8_t byte, Time at);
  bool ApplyButton(std::uint8_t byte);
  // A whole message of a dial.
  bool AcceptDial(Time at);
  // A message that was whole, or not.
  void NoteWhole();
  void NoteTorn();

  SerialBox box_;
  std::int32_t largest_jump_;  // In counts.
  State state_ = State::kBetween;
  bool is_first_ = true;  // No message came since the gap, so that the next one is in step for certain.
  std::optional<Time> last_button_at_;
  std::optional<Time> last_dial_at_;
  std::optional<std::uint8_t> waiting_button_;
  Time last_at_{};
  Time begun_at_{};
  std::size_t bytes_ = 0;
  std::array<std::uint8_t, 3> message_{};
  std::array<std::optional<std::uint16_t>, kMaxDials> positions_{};
  std::array<std::int32_t, kMaxDials> counts_{};
  std::uint32_t buttons_down_ = 0;
  std::uint32_t torn_ = 0;
  std::uint32_t whole_ = 0;
  std::uint32_t resets_ = 0;
  int doubt_ = 0;                   // Grows with torn messages, and is taken back by several whole ones.
  std::uint32_t unread_bytes_ = 0;  // Since the last whole message.
};

// Both directions of a line: the box is asked, and what it sends is decoded. It sends nothing by itself; what
// is to be sent it gives away. A question resets the box, and one that is late on its way resets a box that was started
// meanwhile: it answers once more, and is started once more. Pure; one thread.
class SerialDialSession {
 public:
  enum class State : std::uint8_t {
    kAsking,   // The box was asked, and has time left.
    kSilent,   // It did not answer within a second; it is asked again each second.
    kReady,    // Its messages count.
    kStrange,  // SerialDialDecoder::is_strange.
  };

  SerialDialSession(SerialBox box, int counts_per_turn);

  State state() const;
  const SerialDialDecoder& decoder() const { return decoder_; }

  // The bytes that are to be sent at `now`, mostly none.
  std::vector<std::uint8_t> Due(Time now);
  // As SerialDialDecoder::Accept and Settle.
  bool Accept(std::uint8_t byte, Time at);
  bool Settle(Time now) { return decoder_.Settle(now); }
  // What shows these lamps (bit n: lamp n); empty for a box without.
  std::vector<std::uint8_t> LampBytes(std::uint32_t lit) const;

 private:
  SerialBox box_;
  SerialDialDecoder decoder_;
  std::optional<Time> asked_at_;
  bool answered_ = false;
  bool was_silent_ = false;
  bool started_ = false;  // The box was told to report.
};

}  // namespace kaori::decode
