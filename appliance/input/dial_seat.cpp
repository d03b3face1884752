#include "appliance/input/dial_seat.h"

namespace kaori::input {

using board::SourceState;

DialSeat::DialSeat(const board::Board& board, board::Writer<board::Surface> writer, int counts_per_turn)
    : board_(board), writer_(std::move(writer)), surface_(board.Read<board::Surface>()) {
  surface_.value.counts_per_turn = counts_per_turn;
  buttons_.down = {surface_.value.buttons_down};
  buttons_.pushes = surface_.value.pushes;
}

Result<void> DialSeat::Plug(const ports::HidIdentity& identity, Time now) {
  hid::DialSample before;
  before.counts = surface_.value.counts;
  auto decoder = hid::DialBoxDecoder::For(identity, before);
  if (!decoder) return tl::unexpected(decoder.error());
  decoder_ = std::move(*decoder);
  buttons_.Plug();
  lit_.reset();
  plugged_ = now;
  proven_ = false;
  surface_.at = now;
  surface_.source = SourceState::kLive;
  Write();
  return {};
}

Result<void> DialSeat::Take(std::span<const std::uint8_t> report, Time at) {
  const auto sample = decoder_->Decode(report, at);
  if (!sample) return tl::unexpected(sample.error());
  surface_.value.counts = sample->counts;
  surface_.at = at;
  buttons_.Take(sample->buttons);
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
  const std::uint32_t lit = board_.Read<board::Lamps>().value.lit;
  if (lit_ == lit) return;
  const auto report = decoder_->LampReport(lit);
  // A box that is busy gets them at the next tick; one that is gone says so when it is read.
  if (report.empty() || device->Write(report)) lit_ = lit;
}

void DialSeat::Write() {
  surface_.value.buttons_down = buttons_.down[0];
  surface_.value.pushes = buttons_.pushes;
  writer_.Write(surface_.value, surface_.at, surface_.source);
}

}  // namespace kaori::input
