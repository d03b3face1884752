#include "hw-sim/devices/serial_dial_box.h"

#include <algorithm>
#include <utility>

namespace kaori::sim {
namespace {

// 9600 baud, and ten bits a byte with start and stop.
constexpr Duration kByteTime = std::chrono::nanoseconds(1'000'000'000 / 960);
// The SN-921 tests itself before it answers.
constexpr Duration kSelfTest = std::chrono::milliseconds(300);

// How many bytes a command has, itself included.
std::size_t LengthOf(std::uint8_t command) {
  if (command == 0x50 || command == 0x51 || command == 0x53) return 3;
  return command >= 0x70 && command <= 0x75 ? 5 : 1;
}

}  // namespace

// A fault spoils one byte, and is used up by it.
void SerialDialBox::Say(std::initializer_list<int> bytes) {
  if (is_mute_) return;
  for (const int byte : bytes) {
    const Fault fault = std::exchange(fault_, Fault::kNone);
    if (fault == Fault::kLost) continue;
    said_.push_back(static_cast<std::uint8_t>(fault == Fault::kChanged ? byte ^ 0x55 : byte));
    if (fault == Fault::kTwice) said_.push_back(static_cast<std::uint8_t>(byte));
  }
}

// One message for at most 60 counts, as the box looks at its dials often enough.
void SerialDialBox::Turn(int dial, int counts) {
  if (dial < 0 || dial >= static_cast<int>(positions_.size())) return;
  std::uint16_t& position = positions_[static_cast<std::size_t>(dial)];
  while (counts != 0) {
    const int step = std::clamp(counts, -60, 60);
    counts -= step;
    position = static_cast<std::uint16_t>(position + step);
    if (kind_ == Kind::kDls80)
      Say({0x80 + dial, step >> 8 & 0xFF, step & 0xFF});
    else if (!dials_on_)
      continue;
    else if (kind_ == Kind::kSgi)
      Say({0x30 + dial, position >> 8, position & 0xFF});
    else
      Say({0x30 + dial, std::max(step, 0), std::max(-step, 0)});
  }
}

void SerialDialBox::Push(int button) {
  Button(button, true);
}
void SerialDialBox::Release(int button) {
  Button(button, false);
}

// Four groups of eight, the last one first; the sixth bit is the release.
void SerialDialBox::Button(int button, bool down) {
  if (button < 0 || button >= 32 || kind_ == Kind::kDls80) return;
  const std::uint32_t bit = std::uint32_t{1} << button;
  if (((down_ & bit) != 0) == down) return;
  down_ ^= bit;
  if (buttons_on_) Say({(down ? 0xD8 : 0xF8) - button / 8 * 8 + button % 8});
}

void SerialDialBox::Receive(std::span<const std::uint8_t> bytes, Time now) {
  if (is_mute_ || kind_ == Kind::kDls80) return;
  heard_.insert(heard_.end(), bytes.begin(), bytes.end());
  while (Obey(now)) {
  }
}

// What comes while the box tests itself is lost to it, which is why a host has to await the answer.
bool SerialDialBox::Obey(Time now) {
  if (heard_.empty() || heard_.size() < LengthOf(heard_[0])) return false;
  const bool is_testing = line_free_at_ > now && !waiting_.empty() && waiting_.back().byte == 0x20;
  const auto command = heard_[0];
  if (!is_testing && command == 0x20) {
    PowerCycle();
    line_free_at_ = now + kSelfTest;
    waiting_.push_back({0x20, line_free_at_});
    return false;
  }
  if (!is_testing && command == 0x50) {
    dials_on_ = heard_[2] == 0xFF;
    buttons_on_ = false;
  }
  if (!is_testing && command == 0x73) buttons_on_ = true;
  if (!is_testing && command == 0x75)
    lamps_ = heard_[1] | heard_[2] << 8U | heard_[3] << 16U | static_cast<std::uint32_t>(heard_[4]) << 24U;
  heard_.erase(heard_.begin(), heard_.begin() + static_cast<std::ptrdiff_t>(LengthOf(command)));
  return true;
}

// Bytes queue up behind each other on the line, whenever they were said.
std::vector<std::uint8_t> SerialDialBox::Send(Time now) {
  for (const std::uint8_t byte : said_) {
    line_free_at_ = std::max(line_free_at_, now) + kByteTime;
    waiting_.push_back({byte, line_free_at_});
  }
  said_.clear();
  std::vector<std::uint8_t> left;
  for (; !waiting_.empty() && waiting_.front().leaves_at <= now; waiting_.pop_front())
    left.push_back(waiting_.front().byte);
  return left;
}

std::optional<Time> SerialDialBox::next_due() const {
  if (!said_.empty()) return line_free_at_;
  return waiting_.empty() ? std::nullopt : std::optional(waiting_.front().leaves_at);
}

void SerialDialBox::PowerCycle() {
  dials_on_ = buttons_on_ = false;
  lamps_ = 0;
  positions_ = {};
  heard_.clear();
  said_.clear();
  waiting_.clear();
}

}  // namespace kaori::sim
