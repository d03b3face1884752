#include "appliance/programs/input/keyboard_slot.h"

#include "appliance/core/board/press_log.h"

namespace kaori::input {

using board::SourceState;

// The log goes on too: its count is what readers remember.
KeyboardSlot::KeyboardSlot(const board::Board& board, board::Writer<board::Keys> writer)
    : writer_(std::move(writer)) {
  const board::Stamped<board::Keys> before = board.Read<board::Keys>();
  keys_.down = before.value.down;
  keys_.pushes = before.value.pushes;
  log_ = before.value.log;
  source_ = before.source;
}

// Live before the first report: a keyboard on which nothing is held sends none.
Result<void> KeyboardSlot::Plug(const ports::HidIdentity& identity, Time now) {
  auto decoder = decode::KeyboardDecoder::For(identity);
  if (!decoder) return tl::unexpected(decoder.error());
  decoder_ = std::move(*decoder);
  keys_.Plug();
  plugged_ = now;
  held_confirmed_ = false;
  source_ = SourceState::kLive;
  Write(now);
  return {};
}

// Keys are logged with the modifiers that are held in the same report.
Result<void> KeyboardSlot::Accept(std::span<const std::uint8_t> report, Time at) {
  const auto sample = decoder_->Decode(report, at);
  if (!sample) return tl::unexpected(sample.error());
  keys_.Accept(sample->keys,
               [&](std::size_t usage) { board::Append(log_, board::CodeOf(keys_.down, usage), at); });
  at_ = at;
  held_confirmed_ = changed_ = true;
  return {};
}

// With the time of the newest report since the last call.
void KeyboardSlot::Publish() {
  if (std::exchange(changed_, false)) Write(at_);
}

// A key that was held when the cable went must not stay down. Where no keyboard ever was, the section stays
// absent.
void KeyboardSlot::Unplug(Time now) {
  decoder_.reset();
  keys_.Release();
  if (source_ != SourceState::kLive) return;
  source_ = SourceState::kStale;
  Write(now);
}

// A keyboard at rest sends nothing, so that keys which the board shows as held since before a restart are
// released by time where no report confirms them.
void KeyboardSlot::Tick(Time now, ports::HidChannel* device) {
  if (device == nullptr || held_confirmed_ || now - plugged_ < kHeldStateTrust) return;
  keys_.Release();
  held_confirmed_ = true;
  Write(now);
}

void KeyboardSlot::Write(Time at) {
  writer_.Write({.down = keys_.down, .pushes = keys_.pushes, .log = log_}, at, source_);
}

}  // namespace kaori::input
