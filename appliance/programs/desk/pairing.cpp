#include "appliance/programs/desk/pairing.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

namespace kaori::desk {
namespace {

// Five tries a minute of a million codes that change every five minutes: who guesses all day has a chance of
// less than one in a hundred. A visitor who reads the code from the screen needs one try.
constexpr Duration kCodeLasts = std::chrono::minutes(5);
constexpr Duration kShownFor = std::chrono::minutes(2);
constexpr Duration kMinute = std::chrono::minutes(1);
// An evening: rehearsal, show and the time between them.
constexpr Duration kSessionLasts = std::chrono::hours(8);
// How many wrong codes within a minute lock the desk, and how many sessions there are at once.
constexpr std::size_t kMostTries = 5;
constexpr std::size_t kMostSessions = 4;
constexpr std::uint32_t kCodes = 1'000'000;
// 256 random bits: a session cannot be guessed.
constexpr std::size_t kNameBytes = 32;

// Compares in a time that does not depend on where the two differ. Otherwise the time of an answer would tell
// how many digits are right. Lengths are no secret.
bool SameText(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  unsigned differ = 0;
  for (std::size_t n = 0; n < a.size(); ++n)
    differ |= static_cast<unsigned char>(a[n]) ^ static_cast<unsigned char>(b[n]);
  return differ == 0;
}

}  // namespace

Pairing::Pairing(const Clock& clock, RandomBytes random_bytes)
    : clock_(clock), random_bytes_(std::move(random_bytes)) {
  RenewCode();
}

// Draws until the number is below a multiple of a million, so that every code is equally likely.
void Pairing::RenewCode() {
  constexpr std::uint32_t kFair = UINT32_MAX - UINT32_MAX % kCodes;
  std::array<std::uint8_t, 4> bytes;
  std::uint32_t number = kFair;
  while (number >= kFair) {
    random_bytes_(bytes);
    number = 0;
    for (const std::uint8_t byte : bytes) number = number << 8 | byte;
  }
  code_ = number % kCodes;
  code_until_ = clock_.now() + kCodeLasts;
  changed_ = true;
}

// Compared as it came: six digits with zeros in front, and no blank in the middle.
bool Pairing::IsCode(std::string_view text) const {
  return SameText(text, fmt::format("{:06}", code_));
}

// Hexadecimal, so that it needs no quoting in a cookie.
std::string Pairing::NewName() const {
  std::array<std::uint8_t, kNameBytes> bytes;
  random_bytes_(bytes);
  std::string name;
  for (const std::uint8_t byte : bytes) name += fmt::format("{:02x}", byte);
  return name;
}

// A right code is refused too while tries are locked: otherwise guessing could go on. The code is renewed
// once it was used, so that whoever saw it over a shoulder cannot use it again.
Verdict Pairing::Try(std::string_view code, std::string& session) {
  Step();
  const Time now = clock_.now();
  if (wrong_.size() >= kMostTries) return Verdict::kLocked;
  if (!IsCode(code)) {
    wrong_.push_back(now);
    return Verdict::kWrongCode;
  }
  if (sessions_.size() >= kMostSessions) sessions_.erase(sessions_.begin());
  session = NewName();
  sessions_.push_back({session, now + kSessionLasts});
  shown_until_ = now;
  RenewCode();
  return Verdict::kAccepted;
}

// A session that has run out is unknown at once, though Step removes it later.
bool Pairing::Knows(std::string_view session) const {
  const Time now = clock_.now();
  return std::ranges::any_of(
      sessions_, [&](const Session& one) { return now < one.until && SameText(one.name, session); });
}

void Pairing::EndSession(std::string_view session) {
  std::erase_if(sessions_, [&](const Session& one) { return SameText(one.name, session); });
}

void Pairing::RequestCode() {
  shown_until_ = clock_.now() + kShownFor;
}

// Called by Try as well, so that a code that has run out is not accepted between two steps.
bool Pairing::Step() {
  const Time now = clock_.now();
  std::erase_if(wrong_, [&](Time at) { return now - at >= kMinute; });
  std::erase_if(sessions_, [&](const Session& one) { return now >= one.until; });
  if (now >= code_until_) RenewCode();
  if (shown() != was_shown_) changed_ = true;
  was_shown_ = shown();
  return std::exchange(changed_, false);
}

// While nobody is paired the code stays on the screen, so that the first visitor has to ask for nothing.
bool Pairing::shown() const {
  return sessions_.empty() || clock_.now() < shown_until_;
}

// Of the code and not of a session; 0 between its end and the Step that renews it.
Duration Pairing::valid() const {
  return std::max(Duration{}, code_until_ - clock_.now());
}

}  // namespace kaori::desk
