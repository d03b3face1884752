#include "hw-sim/links/local/screen_port.h"

namespace kaori::sim {
namespace {

// R, G, B, X, without padding.
std::size_t PictureBytes(const ScreenMode& mode) {
  return static_cast<std::size_t>(mode.width_px) * static_cast<std::size_t>(mode.height_px) * 4;
}

}  // namespace

// A picture waits for the next vertical blank alone; without one the screen needs no time.
std::optional<Time> ScreenPort::next_due() const {
  if (!waiting_) return std::nullopt;
  return screen_.blank_at(last_blank_ + 1);
}

// Every driver gets memory of its own: the picture that stands belongs to the one before, whether that still
// runs or not.
bool ScreenPort::Greet() {
  const ScreenMode mode = screen_.mode();
  auto memory = SharedMemory::Make("kaori-screen", kSlots * PictureBytes(mode));
  if (!memory) return false;
  // Of several drivers that came and went without a picture, the memory of
  // the first is what still stands.
  if (!shown_.valid()) shown_ = std::move(drawn_);
  drawn_ = std::move(*memory);
  greeted_ = mode;
  return Send(
      wire::Encode(wire::ScreenHello{kSlots, static_cast<std::uint32_t>(mode.width_px),
                                     static_cast<std::uint32_t>(mode.height_px), mode.period.count()}),
      drawn_.descriptor());
}

// A driver that speaks of a slot that there is not cannot be understood: it may come again.
void ScreenPort::Handle(std::span<const std::uint8_t> packet) {
  const auto present = wire::DecodeScreenPresent(packet);
  if (!present || present->slot >= kSlots) return HangUp();
  waiting_ = present;
}

void ScreenPort::SendDue(Time now) {
  // A driver draws in the mode that it was told: on another one it has to come again.
  if (greeted_ != screen_.mode()) return HangUp();
  const std::int64_t blank = screen_.blank_before(now);
  if (waiting_ && blank > last_blank_) {
    const wire::ScreenPresent present = *waiting_;
    waiting_.reset();
    Flip(present, screen_.blank_at(blank));
  }
  // Vertical blanks that passed between two calls are one: nothing could be
  // shown at those before the last.
  last_blank_ = blank;
}

// The time is that of the blank, and not of this call: a driver paces by it.
void ScreenPort::Flip(const wire::ScreenPresent& present, Time at) {
  const std::size_t bytes = PictureBytes(greeted_);
  screen_.Show({present.frame, at, greeted_.width_px, greeted_.height_px,
                drawn_.bytes().subspan(present.slot * bytes, bytes)});
  // The picture that stood before is nobody's any more.
  shown_ = {};
  Send(wire::Encode(wire::ScreenFlip{at.time_since_epoch().count(), present.frame, present.slot}));
}

// Power came or went: the screen is dark, and the memory of former drivers is nobody's any more.
void ScreenPort::PowerChanged() {
  screen_.Darken();
  shown_ = {};
  drawn_ = {};
}

}  // namespace kaori::sim
