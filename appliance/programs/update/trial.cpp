#include "appliance/programs/update/trial.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace kaori::update {
namespace {

// The second line of what is kept of a try begins with this, where it is the reason in Japanese; notes of before have the log there.
constexpr std::string_view kInJapanese = "/ ";

// Said where the tried system kept nothing: the kernel stopped, or the firmware started another system than it was told.
Reason WithoutAWord() {
  return {"it never came so far as to say why, or this PC forgets what it is to try",
          "理由を残すまで起動できなかったか、このPCが指定を忘れます"};
}

Reason Started() {
  return {"it started, and then the power went or it hung before its face was kept",
          "起動したあと、顔を確かめる前に電源が切れたか止まりました"};
}

// One line each, since the screen shows them so.
std::string Kept(const Reason& reason) {
  std::string lines = reason.english + "\n" + std::string(kInJapanese) + reason.japanese;
  std::replace(lines.begin(), lines.begin() + static_cast<std::ptrdiff_t>(reason.english.size()), '\n', ' ');
  return lines + "\n";
}

Reason ReadKept(const std::string& text) {
  const std::size_t end = text.find('\n');
  Reason reason{text.substr(0, end), {}};
  if (end == text.npos || text.compare(end + 1, kInJapanese.size(), kInJapanese) != 0) return reason;
  const std::size_t from = end + 1 + kInJapanese.size();
  reason.japanese = text.substr(from, text.find('\n', from) - from);
  return reason;
}

}  // namespace

Outcome BeginTry(ports::BootChoice& choice, Notes& notes, std::uint32_t version) {
  const auto pending = notes.ReadPending();
  if (!pending) return {Message::kNothingWaits};
  const auto by_itself = choice.Default();
  if (!by_itself) return {Message::kOtherLayout, pending->version, by_itself.error().message()};
  if (*by_itself != choice.running()) return {Message::kTrialRuns, pending->version};
  if (pending->tries >= kMostTries) return {Message::kTriedOften, pending->version};
  Pending tried = *pending;
  ++tried.tries;
  auto kept = notes.KeepLastTry("");
  if (kept) kept = notes.KeepBefore({version, choice.running(), 0});
  if (kept) kept = notes.KeepPending(tried);
  if (!kept) return {Message::kDiskFault, pending->version, kept.error().message()};
  if (auto ok = choice.TryOnce(pending->slot); !ok) {
    static_cast<void>(notes.KeepPending(*pending));  // Where that fails too a try is lost.
    return {Message::kForgets, pending->version, ok.error().message()};
  }
  return {Message::kRestarts, pending->version};
}

namespace {

// Below what the running system lets this box become. Without a note of it both slots hold what the image was made with.
bool IsBelowLeast(const Pending& there, ports::BootChoice& choice, const Running& running) {
  return there.slot == ports::Other(choice.running()) && there.version < running.least;
}

// With a note that is made for it. Where the try cannot be begun, both notes are as they were.
Outcome BeginNoted(ports::BootChoice& choice, Notes& notes, const Pending& wanted, std::uint32_t version) {
  const auto before = notes.ReadBefore();
  if (auto ok = notes.KeepPending(wanted); !ok)
    return {Message::kDiskFault, wanted.version, ok.error().message()};
  Outcome begun = BeginTry(choice, notes, version);
  if (begun.message == Message::kRestarts) return begun;
  static_cast<void>(notes.ForgetPending());
  if (before) static_cast<void>(notes.KeepBefore(*before));
  return begun;
}

}  // namespace

// Without a note one is made, of no version: it is known that the other slot was written once, and not what is in it. A
// half-written one does not start, and the next start is this system again.
Outcome TryOther(ports::BootChoice& choice, Notes& notes, const Running& running) {
  const auto pending = notes.ReadPending();
  if (pending && pending->tries > 0) return {Message::kTriedOften, pending->version};
  if (pending) return BeginTry(choice, notes, running.version);
  for (const auto& there : {notes.ReadBefore(), notes.ReadOverwritten()})
    if (there && IsBelowLeast(*there, choice, running)) return {Message::kBelowLeast, there->version};
  return BeginNoted(choice, notes, {0, ports::Other(choice.running()), 0}, running.version);
}

Outcome TryWhatIsThere(ports::BootChoice& choice, Notes& notes, const Running& running) {
  if (notes.ReadPending()) return BeginTry(choice, notes, running.version);
  const auto before = notes.ReadBefore();
  if (!before || before->slot != ports::Other(choice.running())) return {Message::kNothingWaits};
  if (IsBelowLeast(*before, choice, running)) return {Message::kBelowLeast, before->version};
  return BeginNoted(choice, notes, {before->version, before->slot, 0}, running.version);
}

bool LastingFault::Lasts(bool is_there, Time now) {
  since_ = is_there ? std::min(since_, now) : kNever;
  return is_there && now - since_ >= kLasts;
}

// A slot that is the default is confirmed, whatever its note says.
Outcome AfterStart(ports::BootChoice& choice, Notes& notes) {
  const auto pending = notes.ReadPending();
  if (!pending) return {Message::kNothingWaits};
  const auto by_itself = choice.Default();
  if (!by_itself) return {Message::kOtherLayout, pending->version, by_itself.error().message()};
  if (pending->slot == *by_itself) {
    const auto forgotten = notes.ForgetPending();
    return {Message::kNothingWaits, 0, forgotten ? "" : forgotten.error().message()};
  }
  if (choice.running() == pending->slot) return {Message::kLooking, pending->version};
  if (pending->tries == 0) return {Message::kWaits, pending->version};
  Reason said = ReadKept(notes.ReadLastTry());
  if (said.empty()) said = WithoutAWord();
  return {pending->tries < kMostTries ? Message::kGaveWay : Message::kTriedOften, pending->version,
          std::move(said.english), std::move(said.japanese)};
}

void NoteStart(Notes& notes) {
  static_cast<void>(notes.KeepLastTry(Kept(Started())));
}

Confirmation::Verdict Confirmation::Observe(const Reason& fault, Time now) {
  if (verdict_ != Verdict::kLooking) return verdict_;
  if (!fault.empty()) {
    reason_ = fault;
    well_since_.reset();
  } else if (!well_since_) {
    well_since_ = now;
  }
  if (well_since_ && now - *well_since_ >= kHolds)
    verdict_ = Verdict::kStays;
  else if (now - began_ >= kLongest)
    verdict_ = Verdict::kGivesWay;
  return verdict_;
}

Result<void> ConfirmTried(ports::BootChoice& choice, Notes& notes) {
  if (auto ok = choice.Confirm(choice.running()); !ok) return ok;
  // It is kept by now. A note that stays is forgotten at the next start (AfterStart).
  static_cast<void>(notes.ForgetPending());
  static_cast<void>(notes.KeepLastTry(""));
  return {};
}

Result<void> GiveWay(Notes& notes, const Reason& reason, std::string_view log) {
  return notes.KeepLastTry(Kept(reason) + std::string(log));
}

}  // namespace kaori::update
