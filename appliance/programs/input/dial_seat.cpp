#include "appliance/programs/input/dial_seat.h"

#include "appliance/core/board/press_log.h"
#include "drivers/base/log.h"

namespace kaori::input {
namespace {

// A kernel waits seconds for a box that does not answer, and all hands with it: a few tries are enough.
constexpr int kMostLampFailures = 3;
constexpr Duration kLampRetry = std::chrono::seconds(5);

}  // namespace

using board::SourceState;

DialSeat::DialSeat(const board::Board& board, board::Writer<board::Surface> writer, int counts_per_turn)
    : board_(board), writer_(std::move(writer)), surface_(board.Read<board::Surface>()) {
  surface_.value.counts_per_turn = counts_per_turn;
  buttons_.down = {surface_.value.buttons_down};
  buttons_.pushes = surface_.value.pushes;
}

Result<void> DialSeat::Plug(const ports::HidIdentity& identity, Time now) {
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
  proven_ = false;
  surface_.at = now;
  surface_.source = SourceState::kLive;
  Write();
  return {};
}

Result<void> DialSeat::Accept(std::span<const std::uint8_t> report, Time at) {
  const auto sample = decoder_->Decode(report, at);
  if (!sample) return tl::unexpected(sample.error());
  surface_.value.counts = sample->counts;
  surface_.at = at;
  buttons_.Accept(sample->buttons, [&](std::size_t button) {
    board::Append(surface_.value.log, static_cast<std::uint32_t>(button), at);
  });
  proven_ = changed_ = true;
  return {};
}

void DialSeat::Publish() {
  if (std::exchange(changed_, false)) Write();
}

void DialSeat::Unplug(Time now) {
  decoder_.reset();
  buttons_.Release();
  if (surface_.source != SourceState::kLive) return;
  surface_.source = SourceState::kStale;
  surface_.at = now;
  Write();
}

void DialSeat::Tick(Time now, ports::HidChannel* device) {
  if (device == nullptr || !decoder_) return;
  if (!proven_ && now - plugged_ >= kProof) {
    buttons_.Release();
    proven_ = true;
    Write();
  }
  ShowLamps(now, *device);
}

// A box that is busy gets them at the next tick; one that is gone says so when it is read.
void DialSeat::ShowLamps(Time now, ports::HidChannel& device) {
  const std::uint32_t lit = board_.Read<board::Lamps>().value.lit;
  if (lit_ == lit || now < lamps_after_ || lamp_failures_ == kMostLampFailures) return;
  const auto report = decoder_->LampReport(lit);
  const auto told = report.empty() ? Result<void>{} : device.Write(report);
  if (told) lit_ = lit;
  if (told || told.error().cause == std::errc::resource_unavailable_try_again) return;
  lamps_after_ = now + kLampRetry;
  if (++lamp_failures_ == kMostLampFailures)
    LogWarning("{}; its lamps stay as they are until it is plugged in anew", told.error().message());
}

void DialSeat::Write() {
  surface_.value.buttons_down = buttons_.down[0];
  surface_.value.pushes = buttons_.pushes;
  writer_.Write(surface_.value, surface_.at, surface_.source);
}

}  // namespace kaori::input
