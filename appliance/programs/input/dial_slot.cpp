#include "appliance/programs/input/dial_slot.h"

#include <utility>

#include "drivers/base/log.h"

namespace kaori::input {
namespace {

// The kernel can wait seconds for a box that does not answer (the timeout of a USB control transfer is 5 s),
// and all other input waits with it: three tries in a minute are enough.
constexpr Duration kLampRetry = std::chrono::seconds(5);
// Lamps are told again so often: some surfaces forget theirs, and nobody should have to touch a button to see
// them.
constexpr Duration kRepaint = std::chrono::seconds(1);

}  // namespace

DialSlot::DialSlot(const board::Board& board, SurfaceSection& section, std::size_t device,
                   const std::vector<SurfaceMap>& maps, const LearntTurns& turns)
    : board_(board), section_(section), device_(device), maps_(maps), turns_(turns) {}

// The first position that a wrapping dial reports counts as no turn: a plug does not move a dial. A box that
// was just plugged in has all lamps dark, so that lit_ is unknown.
Result<void> DialSlot::Plug(const ports::HidIdentity& identity, Time now) {
  const SurfaceMap* const map = MapFor(maps_, identity.vendor, identity.product);
  auto decoder =
      map != nullptr ? decode::DialBoxDecoder::ForSurface(identity) : decode::DialBoxDecoder::For(identity);
  if (!decoder) return tl::unexpected(decoder.error());
  decoder_ = std::move(*decoder);
  map_ = map != nullptr ? map : &usual_;
  identity_ = identity;
  const int learnt = turns_.CountsOf(identity);
  SetCountsPerTurn(learnt != 0 ? learnt : map_->counts_per_turn);
  turned_at_ = {};
  passed_on_ = {};
  lit_.reset();
  lamps_after_ = now;
  lamp_failures_ = {};
  plugged_ = now;
  held_confirmed_ = false;
  deck_ = decode::StreamDeckOf(identity.vendor, identity.product);
  pictures_.Plug(deck_, map_->pictures, map_->pictures_of_show);
  section_.Plug(device_, now);
  return {};
}

// The decoder's counts wrap at 32 bits: their difference is taken without a sign, so that a wrap is a step
// and no leap. Where several buttons of the device are one of the board's, each of them holds it down and all
// pushes count.
Result<void> DialSlot::Accept(std::span<const std::uint8_t> report, Time at) {
  if (deck_.keys > 0) {
    const auto kind = decode::DeckReportOf(deck_, report);
    if (kind == decode::DeckReport::kTorn) return Fail(std::errc::bad_message, "read the keys of a deck");
    if (kind == decode::DeckReport::kOther) return {};
  }
  const auto sample = decoder_->Decode(report, at);
  if (!sample) return tl::unexpected(sample.error());
  for (std::size_t n = 0; n < passed_on_.size(); ++n) {
    const auto before = static_cast<std::uint32_t>(std::exchange(passed_on_[n], sample->counts[n]));
    Turn(n, static_cast<std::int32_t>(static_cast<std::uint32_t>(sample->counts[n]) - before), at);
  }
  decode::Switches<1> buttons;
  for (std::size_t n = 0; n < map_->buttons.size(); ++n) {
    if (!map_->buttons[n]) continue;
    buttons.down[0] |= (sample->buttons.down[0] >> n & 1U) << *map_->buttons[n];
    buttons.pushes[*map_->buttons[n]] += sample->buttons.pushes[n];
  }
  section_.Switch(device_, buttons, at);
  held_confirmed_ = true;
  return {};
}

// A turn of any device is a turn; what division leaves over waits for the next.
void DialSlot::Turn(std::size_t dial, std::int32_t counts, Time at) {
  if (counts == 0 || !map_->dials[dial]) return;
  std::int64_t turned = counts;
  if (counts_per_turn_ != 0) {
    const std::int64_t parts = rests_[dial] + turned * section_.counts_per_turn();
    turned = parts / counts_per_turn_;
    rests_[dial] = parts % counts_per_turn_;
  }
  turned_at_[*map_->dials[dial]] = at;
  section_.Turn(*map_->dials[dial], static_cast<std::int32_t>(turned), at);
}

// The inverse of what Turn does, without its whole numbers: a lesson rounds once, at its end.
double DialSlot::CountsOfItsOwn(std::uint32_t on_board) const {
  return counts_per_turn_ == 0
             ? on_board
             : static_cast<double>(on_board) * counts_per_turn_ / section_.counts_per_turn();
}

// Parts of a count are of the size that counts had before.
// At a plug and by a lesson. What was turned before stays as it was counted.
void DialSlot::SetCountsPerTurn(int counts) {
  counts_per_turn_ = counts;
  rests_ = {};
}

void DialSlot::Unplug(Time now) {
  turned_at_ = {};
  decoder_.reset();
  pictures_.Unplug();
  section_.Unplug(device_, now);
}

// Buttons that the board shows as held since before the plug are trusted for kHeldStateTrust and then let go,
// unless a report has confirmed them.
void DialSlot::Tick(Time now, ports::HidChannel* device) {
  if (device == nullptr || !decoder_) return;
  if (!held_confirmed_ && now - plugged_ >= kHeldStateTrust) {
    section_.Release(device_);
    held_confirmed_ = true;
  }
  ShowLamps(now, *device);
  if (pictures_.has_keys()) pictures_.Show(DeckKeys(), now, *device, name());
}

// A box that is busy is told at the next tick; a box that is gone is noticed when it is read. Only other
// failures count against the plug, and the first two of them in a minute are tried again in silence.
void DialSlot::ShowLamps(Time now, ports::HidChannel& device) {
  const std::uint32_t on_board = board_.Read<board::Lamps>().value.lit;
  std::uint32_t lit = 0;
  for (std::size_t n = 0; n < map_->buttons.size(); ++n)
    if (map_->buttons[n]) lit |= (on_board >> *map_->buttons[n] & 1U) << n;
  const bool same = lit_ == lit && now - told_ < kRepaint;
  if (same || now < lamps_after_ || lamp_failures_.are_too_many()) return;
  const auto report = decoder_->LampReport(lit);
  const auto told = report.empty() ? Result<void>{} : device.Write(report);
  if (told) lit_ = lit, told_ = now;
  if (told || told.error().cause == std::errc::resource_unavailable_try_again) return;
  lamps_after_ = now + kLampRetry;
  if (lamp_failures_.Note(now))
    LogWarning("{}; the lamps of the {} stay as they are until it is plugged in again",
               told.error().message(), name());
}

// A key that is no button of the board calls nothing.
DeckPictures::Keys DialSlot::DeckKeys() const {
  const auto calls = board_.Read<board::ButtonCalls>().value;
  const std::uint32_t sheet = board_.Read<board::ShowNow>().value.sheet;
  const std::uint32_t lit = board_.Read<board::Lamps>().value.lit;
  DeckPictures::Keys keys;
  for (std::size_t key = 0; key < keys.size() && sheet < calls.sums.size(); ++key)
    if (const auto button = map_->buttons[key])
      keys[key] = {calls.sums[sheet][*button], (lit >> *button & 1U) != 0};
  return keys;
}

}  // namespace kaori::input
