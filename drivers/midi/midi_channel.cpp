#include "drivers/midi/midi_channel.h"

#include <unistd.h>

#include "firmware/wire/dial_box.h"

namespace kaori::midi {
namespace {

// What floods with bytes that say nothing does not hold up others; the loop comes again for the rest.
constexpr int kFillsAtOnce = 16;

}  // namespace

MidiChannel::MidiChannel(UniqueFd node, const ports::HidIdentity& identity, const decode::MidiMap& map,
                         const Clock& clock, ports::MidiTap* tap)
    : node_(std::move(node)), identity_(identity), map_(map), clock_(clock), tap_(tap), surface_(map) {
  // Where it does not take it now it is as it was switched on, and its dials may do nothing.
  (void)Send(map_.start);
}

// Only when all that was read before is used up. The time is that of the reading, for raw MIDI has none.
Result<void> MidiChannel::Fill() {
  const ssize_t got = ::read(node_.get(), bytes_.data(), bytes_.size());
  if (got < 0 && (errno == EAGAIN || errno == EINTR))
    return Fail(std::errc::resource_unavailable_try_again, "read " + identity_.port);
  if (got <= 0) return Fail(std::errc::no_such_device, "read the MIDI device at " + identity_.port);
  next_ = 0;
  end_ = static_cast<std::size_t>(got);
  read_at_ = clock_.now();
  return {};
}

// One report for each byte that changed something, so that a tap between two calls is not lost. A device that
// floods is left after some fills, with "try again": the loop has other devices.
Result<ports::HidInput> MidiChannel::Read(std::span<std::uint8_t> into) {
  const auto report = [&] {
    return ports::HidInput{.at = read_at_,
                           .bytes = reporter_.Report(surface_.counts(), surface_.buttons_down(), into)};
  };
  if (reporter_.has_rest()) return report();
  Repaint(clock_.now());
  for (int fills = 0; fills < kFillsAtOnce; ++fills) {
    while (next_ < end_)
      if (AcceptNext()) return report();
    if (auto filled = Fill(); !filled) return tl::unexpected(filled.error());
  }
  return Fail(std::errc::resource_unavailable_try_again, "read " + identity_.port);
}

bool MidiChannel::AcceptNext() {
  const bool changed = surface_.Accept(bytes_[next_++]);
  const auto heard = surface_.heard();
  if (tap_ != nullptr && heard)
    tap_->Note({.at = read_at_,
                .vendor = identity_.vendor,
                .product = identity_.product,
                .status = heard->message.status,
                .number = heard->message.number,
                .value = heard->message.value,
                .dial = heard->dial,
                .button = heard->button});
  return changed;
}

void MidiChannel::Repaint(Time now) {
  if (map_.repaint == Duration::zero() || now - painted_at_ < map_.repaint) return;
  painted_at_ = now;
  (void)Send(surface_.LampBytes(lit_, true));
}

Result<void> MidiChannel::Write(std::span<const std::uint8_t> report) {
  if (report.size() != 1 + wire::kDialBoxLampBytes)
    return FailInput("write an unknown report to " + identity_.port);
  lit_ = wire::GetU32(report, 1);
  return Send(surface_.LampBytes(lit_, false));
}

// What was cut short is sent whole the next time: a status byte ends whatever message it comes into. EBADF is
// a device that has no way back and is open for reading alone.
Result<void> MidiChannel::Send(std::span<const std::uint8_t> bytes) {
  if (bytes.empty()) return {};
  const ssize_t sent = ::write(node_.get(), bytes.data(), bytes.size());
  if (sent == static_cast<ssize_t>(bytes.size()) || (sent < 0 && errno == EBADF)) return {};
  const bool is_full = sent >= 0 || errno == EAGAIN || errno == EINTR;
  surface_.ForgetLamps();
  return Fail(is_full ? std::errc::resource_unavailable_try_again : std::errc::no_such_device,
              "write to the MIDI device at " + identity_.port);
}

}  // namespace kaori::midi
