#include "appliance/programs/input/dial_slot.h"

#include "appliance/core/board/press_log.h"
#include "drivers/base/log.h"

namespace kaori::input {
namespace {

// The kernel can wait seconds for a box that does not answer (the timeout of a USB control transfer is 5 s),
// and all other input waits with it: three tries per plug are enough.
constexpr int kMaxLampFailures = 3;
constexpr Duration kLampRetry = std::chrono::seconds(5);
// Lamps are told again so often: some surfaces forget theirs, and nobody should have to touch a button to see them.
constexpr Duration kRepaint = std::chrono::seconds(1);

}  // namespace

using board::SourceState;

DialSlot::DialSlot(const board::Board& board, board::Writer<board::Surface> writer, int counts_per_turn)
    : board_(board), writer_(std::move(writer)), surface_(board.Read<board::Surface>()) {
  surface_.value.counts_per_turn = counts_per_turn;
  buttons_.down = {surface_.value.buttons_down};
  buttons_.pushes = surface_.value.pushes;
}

// The decoder begins with the counts of the board, and the first position that a wrapping dial reports counts as no
// turn: a plug does not move a dial. A box that was just plugged in has all lamps dark, so that lit_ is unknown.
Result<void> DialSlot::Plug(const ports::HidIdentity& identity, Time now) {
  decode::DialSample before;
  before.counts = surface_.value.counts;
  auto decoder = decode::DialBoxDecoder::For(identity, before);
  if (!decoder) return tl::unexpected(decoder.error());
  decoder_ = std::move(*decoder);
  buttons_.Plug();
  lit_.reset();
  lamps_after_ = now;
  lamp_failures_ = 0;
  plugged_ = now;
  held_confirmed_ = false;
  surface_.at = now;
  surface_.source = SourceState::kLive;
  Write();
  return {};
}

// Counts are the decoder's, which goes on from those of the board; pushes come by way of the carried switches.
Result<void> DialSlot::Accept(std::span<const std::uint8_t> report, Time at) {
  const auto sample = decoder_->Decode(report, at);
  if (!sample) return tl::unexpected(sample.error());
  surface_.value.counts = sample->counts;
  surface_.at = at;
  buttons_.Accept(sample->buttons, [&](std::size_t button) {
    board::Append(surface_.value.log, static_cast<std::uint32_t>(button), at);
  });
  held_confirmed_ = changed_ = true;
  return {};
}

void DialSlot::Publish() {
  if (std::exchange(changed_, false)) Write();
}

// A section that was never live stays absent: there never was a box.
void DialSlot::Unplug(Time now) {
  decoder_.reset();
  buttons_.Release();
  if (surface_.source != SourceState::kLive) return;
  surface_.source = SourceState::kStale;
  surface_.at = now;
  Write();
}

// The time of the section is left as it was: releasing what nobody holds any more is no new input.
void DialSlot::Tick(Time now, ports::HidChannel* device) {
  if (device == nullptr || !decoder_) return;
  if (!held_confirmed_ && now - plugged_ >= kHeldStateTrust) {
    buttons_.Release();
    held_confirmed_ = true;
    Write();
  }
  ShowLamps(now, *device);
}

// A box that is busy is told at the next tick; a box that is gone is noticed when it is read. Only other
// failures count against the plug, and the first two of them are tried again in silence.
void DialSlot::ShowLamps(Time now, ports::HidChannel& device) {
  const std::uint32_t lit = board_.Read<board::Lamps>().value.lit;
  const bool same = lit_ == lit && now - told_ < kRepaint;
  if (same || now < lamps_after_ || lamp_failures_ == kMaxLampFailures) return;
  const auto report = decoder_->LampReport(lit);
  const auto told = report.empty() ? Result<void>{} : device.Write(report);
  if (told) lit_ = lit, told_ = now;
  if (told || told.error().cause == std::errc::resource_unavailable_try_again) return;
  lamps_after_ = now + kLampRetry;
  if (++lamp_failures_ == kMaxLampFailures)
    LogWarning("{}; the lamps of the dial box stay as they are until it is plugged in again",
               told.error().message());
}

// The carried switches are the truth about buttons; the section gets a copy.
void DialSlot::Write() {
  surface_.value.buttons_down = buttons_.down[0];
  surface_.value.pushes = buttons_.pushes;
  writer_.Write(surface_.value, surface_.at, surface_.source);
}

}  // namespace kaori::input
