#include "drivers/decode/serial_dials.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace kaori::decode {
namespace {

constexpr std::uint8_t kReset = 0x20;  // The box answers the same byte.
constexpr std::uint8_t kFirstButtonByte = 0xC0;
// A button's byte is C0 to DF where it went down, and 20 more where it came up.
constexpr std::uint8_t kReleasedBit = 0x20;
constexpr Duration kBackToBack = std::chrono::milliseconds(3);  // Not quite three bytes.
constexpr Duration kAnswerTime = std::chrono::seconds(1);
// More than one message of five that is torn is no longer chance.
constexpr int kDoubtOfTorn = 4;
constexpr int kMostDoubt = 64;
constexpr std::uint32_t kStrangeBytes = 960;  // What fits through the line in a second.

// All eight dials report by themselves; then the type of the 32 buttons and that they report by themselves.
// Switching the dials on switches the buttons off, so that buttons come last, and twice as the box wants it.
constexpr auto kStart = std::to_array<std::uint8_t>(
    {0x50, 0x00, 0xFF, 0x71, 0x00, 0x00, 0x00, 0x00, 0x73, 0xFF, 0xFF, 0xFF, 0xFF,  //
     0x71, 0x00, 0x00, 0x00, 0x00, 0x73, 0xFF, 0xFF, 0xFF, 0xFF});

std::uint8_t FirstDialByte(SerialBox box) {
  return box == SerialBox::kDls80 ? 0x80 : 0x30;
}

std::int32_t Signed(std::uint16_t value) {
  return static_cast<std::int16_t>(value);
}

std::int32_t AddedTo(std::int32_t count, std::int32_t turn) {
  return static_cast<std::int32_t>(static_cast<std::uint32_t>(count) + static_cast<std::uint32_t>(turn));
}

std::uint32_t BitOf(std::uint8_t byte) {
  return std::uint32_t{1} << ((3U - (byte >> 3U & 3U)) * 8U + (byte & 7U));
}

}  // namespace

SerialDialDecoder::SerialDialDecoder(SerialBox box, int counts_per_turn)
    : box_(box), largest_jump_(counts_per_turn / 3) {}

bool SerialDialDecoder::Settle(Time now) {
  if (!waiting_button_ || now - last_at_ < kSerialGap) return false;
  return ApplyButton(*std::exchange(waiting_button_, std::nullopt));
}

// Times decide before values: a gap ends whatever was begun, and a message that takes longer than the gap is
// torn, although no silence was in it.
bool SerialDialDecoder::Accept(std::uint8_t byte, Time at) {
  const bool settled = Settle(at);
  const bool is_late = state_ == State::kWithin && at - begun_at_ >= kSerialGap;
  if (at - last_at_ >= kSerialGap || is_late) {
    if (state_ == State::kWithin) NoteTorn();
    state_ = State::kBetween;
    is_first_ = true;
  }
  last_at_ = at;
  ++unread_bytes_;
  switch (state_) {
    case State::kBetween:
      return Begin(byte, at) || settled;
    case State::kWithin:
      message_[bytes_++] = byte;
      return bytes_ == message_.size() && AcceptDial(at);
    case State::kWatching:
      break;
  }
  return settled;
}

// Where it is none of the three beginnings the decoder is out of step: it watches until the next gap, and a
// button that waited is dropped, for it may have been a dial's byte.
bool SerialDialDecoder::Begin(std::uint8_t byte, Time at) {
  if (static_cast<std::size_t>(byte - FirstDialByte(box_)) < kMaxDials && byte >= FirstDialByte(box_)) {
    state_ = State::kWithin;
    begun_at_ = at;
    message_[0] = byte;
    bytes_ = 1;
    return false;
  }
  if (box_ != SerialBox::kDls80 && byte == kReset) {
    unread_bytes_ = 0;
    // Its test of itself takes longer than any gap, so that a byte without silence before it is no answer.
    if (is_first_) positions_ = {}, ++resets_;
    return false;
  }
  if (box_ != SerialBox::kDls80 && byte >= kFirstButtonByte) return AcceptButton(byte, at);
  NoteTorn();
  waiting_button_.reset();
  state_ = State::kWatching;
  return false;
}

// D8..DF are buttons 0..7 pressed, D0..D7 8..15, C8..CF 16..23, C0..C7 24..31; 0x20 more is the release.
// Without its first byte the data of a dial look like buttons: two of them back to back, or one that is so
// already. Of two buttons that a person presses within three milliseconds the second is lost for it.
bool SerialDialDecoder::AcceptButton(std::uint8_t byte, Time at) {
  const std::uint32_t bit = BitOf(byte);
  const bool is_release = (byte & kReleasedBit) != 0;
  const bool is_known = ((buttons_down_ & bit) == 0) == is_release;
  if ((last_button_at_ && at - *last_button_at_ < kBackToBack) || (is_known && !is_first_)) {
    NoteTorn();
    waiting_button_.reset();
    state_ = State::kWatching;
    return false;
  }
  last_button_at_ = at;
  is_first_ = false;
  if (last_dial_at_ && at - *last_dial_at_ < kBackToBack) {
    waiting_button_ = byte;
    return false;
  }
  return ApplyButton(byte);
}

bool SerialDialDecoder::ApplyButton(std::uint8_t byte) {
  const std::uint32_t bit = BitOf(byte);
  const std::uint32_t before = buttons_down_;
  buttons_down_ = (byte & kReleasedBit) != 0 ? before & ~bit : before | bit;
  NoteWhole();
  return buttons_down_ != before;
}

// A jump in the first message after a gap is the truth: the dial was turned while nobody could listen. Where
// it stands is known from here on, and what it turned is not.
bool SerialDialDecoder::AcceptDial(Time at) {
  state_ = State::kBetween;
  const bool is_first = is_first_;
  is_first_ = false;
  const std::size_t dial = message_[0] - FirstDialByte(box_);
  const auto word = static_cast<std::uint16_t>(message_[1] << 8U | message_[2]);
  std::int32_t turn = 0;
  if (box_ == SerialBox::kSgi)
    turn = Signed(static_cast<std::uint16_t>(word - positions_[dial].value_or(word)));
  else
    turn = box_ == SerialBox::kDls80 ? Signed(word) : message_[1] - message_[2];
  // Where a dial stands is learnt where the step is certain.
  const bool is_unknown = box_ == SerialBox::kSgi && !positions_[dial] && !is_first;
  if (std::abs(turn) > largest_jump_ || is_unknown) {
    NoteTorn();
    waiting_button_.reset();
    if (!is_first || box_ != SerialBox::kSgi) {
      state_ = State::kWatching;
      return false;
    }
    turn = 0;
  }
  positions_[dial] = word;
  NoteWhole();
  last_dial_at_ = at;
  counts_[dial] = AddedTo(counts_[dial], turn);
  const bool pressed = waiting_button_ && ApplyButton(*std::exchange(waiting_button_, std::nullopt));
  return turn != 0 || pressed;
}

void SerialDialDecoder::NoteWhole() {
  ++whole_;
  unread_bytes_ = 0;
  doubt_ = std::max(0, doubt_ - 1);
}

void SerialDialDecoder::NoteTorn() {
  ++torn_;
  doubt_ += kDoubtOfTorn;
}

bool SerialDialDecoder::is_strange() const {
  return doubt_ >= kMostDoubt || unread_bytes_ >= kStrangeBytes;
}

SerialDialSession::SerialDialSession(SerialBox box, int counts_per_turn)
    : box_(box), decoder_(box, counts_per_turn), answered_(box == SerialBox::kDls80), started_(answered_) {}

SerialDialSession::State SerialDialSession::state() const {
  if (decoder_.is_strange()) return State::kStrange;
  if (answered_ && started_) return State::kReady;
  return was_silent_ ? State::kSilent : State::kAsking;
}

// First the question, each second until it is answered; then once what starts the reports. A DLS80 is asked
// nothing.
std::vector<std::uint8_t> SerialDialSession::Due(Time now) {
  if (started_) return {};
  if (answered_) {
    started_ = true;
    return {kStart.begin(), kStart.end()};
  }
  if (asked_at_ && now - *asked_at_ < kAnswerTime) return {};
  was_silent_ = asked_at_.has_value();
  asked_at_ = now;
  return {kReset};
}

// What a box says before it was asked, or before its answer, is of an earlier life. A box that answers again is one that
// was asked twice since its first answer came late, or that lost its power: what started it is gone.
bool SerialDialSession::Accept(std::uint8_t byte, Time at) {
  const std::uint32_t resets = decoder_.resets();
  const bool changed = decoder_.Accept(byte, at);
  if (answered_ && decoder_.resets() != resets) started_ = false;
  if (!answered_ && byte == kReset && asked_at_) answered_ = true;
  return changed;
}

std::vector<std::uint8_t> SerialDialSession::LampBytes(std::uint32_t lit) const {
  if (box_ == SerialBox::kDls80) return {};
  std::vector<std::uint8_t> bytes{0x75};
  for (unsigned n = 0; n < 4; ++n) bytes.push_back(static_cast<std::uint8_t>(lit >> 8U * n));
  return bytes;
}

}  // namespace kaori::decode
