#include "appliance/programs/input/stick_slot.h"

#include <algorithm>

#include "appliance/core/board/press_log.h"
#include "appliance/programs/input/stick_roles.h"

namespace kaori::input {
namespace {

// The stage waits 250 ms and then eases a lost stick to neutral within 1 s. After this longer time both
// programs agree that the axes are neutral.
constexpr Duration kEased = std::chrono::milliseconds(1750);

}  // namespace

using board::SourceState;

bool IsAtRest(const board::Stick& stick) {
  return stick.x == 0 && stick.y == 0 && stick.twist == 0 && stick.hat < 0 && stick.buttons_down == 0;
}

// Goes on from the board, so that a restart of the program moves no axis.
StickSlot::StickSlot(const board::Board& board, board::Writer<board::Stick> writer, int which,
                     const InputSettings& settings)
    : writer_(std::move(writer)),
      which_(which),
      settings_(settings.sticks[static_cast<std::size_t>(which)]),
      centre_button_(settings.centre_buttons[static_cast<std::size_t>(which)]),
      stick_(board.Read<board::Stick>(which)) {
  buttons_.down = {stick_.value.buttons_down};
  std::ranges::copy(stick_.value.pushes, buttons_.pushes.begin());
}

// Centres belong to the stick that was calibrated, which is told by its port.
Result<void> StickSlot::Plug(const ports::HidIdentity& identity, Time now) {
  auto decoder = decode::JoystickDecoder::For(identity, settings_);
  if (!decoder) return tl::unexpected(decoder.error());
  decoder_ = std::move(*decoder);
  buttons_.Plug();
  plugged_ = now;
  reported_ = false;
  centre_pushes_ = 0;
  const std::uint32_t port = HashOfPort(identity.port);
  if (stick_.value.port != port) stick_.value.centres = {};  // This is another stick.
  decoder_->SetCentres(stick_.value.centres);
  stick_.value.port = port;
  // Absent: the stick never moved, so neutral is right. Live: the program restarted and goes on. Stale: see
  // the class.
  Write(now, stick_.source == SourceState::kAbsent ? SourceState::kLive : stick_.source);
  return {};
}

// A report makes the section live again, whatever it was: the stick has said where it stands.
Result<void> StickSlot::Accept(std::span<const std::uint8_t> report, Time at) {
  if (const auto decoded = decoder_->Decode(report, at); !decoded) return tl::unexpected(decoded.error());
  CalibrateOnPush(decoder_->sample());
  const decode::StickSample& sample = decoder_->sample();
  board::Stick& stick = stick_.value;
  stick.x = sample.x;
  stick.y = sample.y;
  stick.twist = sample.twist;
  stick.slider = sample.slider;
  stick.hat = sample.hat;
  buttons_.Accept(sample.buttons, [&](std::size_t n) {
    if (n < stick.pushes.size()) board::NotePress(stick, n, at);
  });
  stick_.at = at;
  reported_ = changed_ = true;
  return {};
}

// Where the stick stands when its centre button goes down is its middle from now on; this sample is then
// decoded with the new centre already.
void StickSlot::CalibrateOnPush(const decode::StickSample& sample) {
  if (centre_button_ == 0) return;
  const std::uint32_t pushes = sample.buttons.pushes[static_cast<std::size_t>(centre_button_ - 1)];
  if (std::exchange(centre_pushes_, pushes) == pushes) return;
  decoder_->CalibrateCentre();
  stick_.value.centres = decoder_->centres();
}

// Live in any case: only a report sets `changed_`.
void StickSlot::Publish() {
  if (std::exchange(changed_, false)) Write(stick_.at, SourceState::kLive);
}

// Axes stay as they were: the stage holds them for a moment and eases them out.
void StickSlot::Unplug(Time now) {
  decoder_.reset();
  buttons_.Release();
  stick_.value.hat = -1;
  if (stick_.source == SourceState::kLive) Write(now, SourceState::kStale);
}

// A stick reports when something changes. One that has not reported since its plug is either at rest, or its
// state is unknown until it moves; the two cases end in neutral axes, by way of stale.
void StickSlot::Tick(Time now, ports::HidChannel* device) {
  if (device == nullptr || reported_) return;
  if (stick_.source == SourceState::kLive && IsAtRest(stick_.value)) return;
  if (stick_.source == SourceState::kLive && now - plugged_ >= kHeldStateTrust) {
    // The stick was deflected before the restart and is at rest now: it is handled like one that was pulled.
    buttons_.Release();
    Write(now, SourceState::kStale);
  }
  if (now - plugged_ < kEased) return;
  stick_.value = {.slider = stick_.value.slider,
                  .pushes = stick_.value.pushes,
                  .log = stick_.value.log,
                  .port = stick_.value.port,
                  .centres = stick_.value.centres};
  reported_ = true;
  Write(now, SourceState::kLive);
}

void StickSlot::Write(Time at, SourceState source) {
  stick_.at = at;
  stick_.source = source;
  stick_.value.buttons_down = buttons_.down[0];
  writer_.Write(stick_.value, at, source);
}

}  // namespace kaori::input
