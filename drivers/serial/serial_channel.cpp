#include "drivers/serial/serial_channel.h"

#include <unistd.h>

#include <utility>

#include "firmware/wire/dial_box.h"

namespace kaori::serial {
namespace {

// What floods with bytes that say nothing does not hold up others; the loop comes again for the rest.
constexpr int kFillsAtOnce = 16;

}  // namespace

void SendDue(SpokenLine& spoken, Time now) {
  const auto bytes = spoken.session.Due(now);
  if (!bytes.empty()) (void)!::write(spoken.line.get(), bytes.data(), bytes.size());
}

SerialChannel::SerialChannel(SpokenLine spoken, std::string port, const Clock& clock, SerialLoan& loan)
    : spoken_(std::move(spoken)),
      identity_{.port = std::move(port),
                .vendor = 0,
                .product = 0,
                .name = "serial dial box",
                .descriptor = {wire::kDialBoxDescriptor.begin(), wire::kDialBoxDescriptor.end()}},
      clock_(clock),
      loan_(loan),
      reporter_(spoken_.session.decoder().counts()),
      told_torn_(spoken_.session.decoder().torn()) {
  loan_.is_out = true;
}

// The adapter that is pulled hangs its line up: reading gives no byte, or EIO.
Result<void> SerialChannel::Fill() {
  const ssize_t got = ::read(spoken_.line.get(), bytes_.data(), bytes_.size());
  if (got < 0 && (errno == EAGAIN || errno == EINTR))
    return Fail(std::errc::resource_unavailable_try_again, "read " + identity_.port);
  if (got <= 0) return Fail(std::errc::no_such_device, "read the serial line " + identity_.port);
  next_ = 0;
  end_ = static_cast<std::size_t>(got);
  read_at_ = clock_.now();
  return {};
}

// One message at a time: a button that went down and up in what was read at once has both its reports.
Result<ports::HidInput> SerialChannel::Read(std::span<std::uint8_t> into) {
  if (reporter_.has_rest()) return Report(into);
  SendDue(spoken_, clock_.now());
  const decode::SerialDialDecoder& decoder = spoken_.session.decoder();
  if (next_ == end_ && spoken_.session.Settle(clock_.now())) return Report(into);
  for (int fills = 0; fills < kFillsAtOnce; ++fills) {
    while (next_ < end_)
      if (spoken_.session.Accept(bytes_[next_++], read_at_)) return Report(into);
    SendDue(spoken_, read_at_);  // A box that began anew is told to report.
    if (spoken_.session.state() == decode::SerialDialSession::State::kStrange) {
      loan_.was_strange = true;
      return Fail(std::errc::no_such_device,
                  "what comes on the serial line " + identity_.port +
                      " is no message of this kind of box: its speed or its kind is another");
    }
    if (std::exchange(told_torn_, decoder.torn()) != decoder.torn())
      return Fail(std::errc::bad_message,
                  "a torn message on the serial line " + identity_.port + " was passed over");
    if (auto filled = Fill(); !filled) return tl::unexpected(filled.error());
  }
  return Fail(std::errc::resource_unavailable_try_again, "read " + identity_.port);
}

ports::HidInput SerialChannel::Report(std::span<std::uint8_t> into) {
  const decode::SerialDialDecoder& decoder = spoken_.session.decoder();
  return {.at = read_at_, .bytes = reporter_.Report(decoder.counts(), decoder.buttons_down(), into)};
}

// A box without lamps takes the report and does nothing. What was cut short is not sent again: the caller
// tries the whole report later.
Result<void> SerialChannel::Write(std::span<const std::uint8_t> report) {
  if (report.size() != 1 + wire::kDialBoxLampBytes)
    return FailInput("write an unknown report to " + identity_.port);
  const auto bytes = spoken_.session.LampBytes(wire::GetU32(report, 1));
  if (bytes.empty()) return {};
  const ssize_t sent = ::write(spoken_.line.get(), bytes.data(), bytes.size());
  if (sent == static_cast<ssize_t>(bytes.size())) return {};
  if (sent >= 0 || errno == EAGAIN)
    return Fail(std::errc::resource_unavailable_try_again, "write to the serial line " + identity_.port);
  return Fail(std::errc::no_such_device, "write to the serial line " + identity_.port);
}

}  // namespace kaori::serial
