#include "appliance/programs/input/pointer_slot.h"

#include <algorithm>
#include <utility>

namespace kaori::input {
namespace {

constexpr std::uint32_t kButtons = 0x7;  // The board counts the pushes of three buttons.

}  // namespace

using board::SourceState;

// Position, wheel and pushes go on from the board, and a button that was held there counts as held until a
// report or kHeldStateTrust says otherwise.
PointerSlot::PointerSlot(const board::Board& board, board::Writer<board::Pointer> writer,
                         const decode::PointerSettings& settings)
    : writer_(std::move(writer)), settings_(settings), pointer_(board.Read<board::Pointer>()) {
  buttons_.down = {pointer_.value.buttons_down};
  std::ranges::copy(pointer_.value.pushes, buttons_.pushes.begin());
}

// A mouse goes on from where the pointer stands; a tablet says its position itself with the first report.
Result<void> PointerSlot::Plug(const ports::HidIdentity& identity, Time now) {
  decode::PointerSample before;
  before.x = pointer_.value.x;
  before.y = pointer_.value.y;
  before.wheel = pointer_.value.wheel;
  auto decoder = decode::PointerDecoder::For(identity, settings_, before);
  if (!decoder) return tl::unexpected(decoder.error());
  decoder_ = std::move(*decoder);
  buttons_.Plug();
  plugged_ = now;
  held_confirmed_ = false;
  pointer_.at = now;
  pointer_.source = SourceState::kLive;
  Write();
  return {};
}

// Position and wheel are sums of the decoder's, which goes on from those of the board.
Result<void> PointerSlot::Accept(std::span<const std::uint8_t> report, Time at) {
  const auto sample = decoder_->Decode(report, at);
  if (!sample) return tl::unexpected(sample.error());
  pointer_.value.x = sample->x;
  pointer_.value.y = sample->y;
  pointer_.value.wheel = sample->wheel;
  pointer_.at = at;
  buttons_.Accept(sample->buttons);
  held_confirmed_ = changed_ = true;
  return {};
}

void PointerSlot::Publish() {
  if (std::exchange(changed_, false)) Write();
}

// The pointer stays where it is; only its buttons are let go. A section that is not live is left as it is.
void PointerSlot::Unplug(Time now) {
  decoder_.reset();
  buttons_.Release();
  if (pointer_.source != SourceState::kLive) return;
  pointer_.source = SourceState::kStale;
  pointer_.at = now;
  Write();
}

// Silence since the plug means that nothing is held: a mouse at rest sends no report.
void PointerSlot::Tick(Time now, ports::HidChannel* device) {
  if (device == nullptr || held_confirmed_ || now - plugged_ < kHeldStateTrust) return;
  buttons_.Release();
  held_confirmed_ = true;
  Write();
}

// Buttons beyond the third one are decoded and not published.
void PointerSlot::Write() {
  pointer_.value.buttons_down = buttons_.down[0] & kButtons;
  std::copy_n(buttons_.pushes.begin(), pointer_.value.pushes.size(), pointer_.value.pushes.begin());
  writer_.Write(pointer_.value, pointer_.at, pointer_.source);
}

}  // namespace kaori::input
