#include "drivers/serial/serial_bus.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "drivers/base/timer.h"
#include "drivers/serial/serial_line.h"

namespace kaori::serial {
namespace {

// A line that floods does not hold up others: four seconds of 9600 baud in a look.
constexpr int kReadsAtOnce = 16;

std::string_view NameOf(decode::SerialBox box) {
  return decode::kSerialBoxNames[static_cast<std::size_t>(box)];
}

}  // namespace

// The last "=" counts, since a path may have one.
Result<SerialBoxOptions> ParseSerialBox(const std::string& text, int counts_per_turn) {
  const auto equals = text.rfind('=');
  const std::string kind = equals == std::string::npos ? "" : text.substr(equals + 1);
  const auto* const found = std::ranges::find(decode::kSerialBoxNames, kind);
  if (found == decode::kSerialBoxNames.end() || equals == 0)
    return FailInput(fmt::format(
        "--serial {}: expected a line and its kind of box, such as /dev/ttyUSB0=sgi; kinds are {}", text,
        fmt::join(decode::kSerialBoxNames, ", ")));
  return SerialBoxOptions{.path = text.substr(0, equals),
                          .box = static_cast<decode::SerialBox>(found - decode::kSerialBoxNames.begin()),
                          .counts_per_turn = counts_per_turn};
}

Result<std::unique_ptr<SerialBus>> SerialBus::Open(SerialBoxOptions options, const Clock& clock) {
  auto timer = OpenTimer(options.look_every, options.look_every, "look for serial lines now and then");
  if (!timer) return tl::unexpected(timer.error());
  return std::unique_ptr<SerialBus>(new SerialBus(std::move(options), clock, std::move(*timer)));
}

SerialBus::SerialBus(SerialBoxOptions options, const Clock& clock, UniqueFd timer)
    : options_(std::move(options)),
      port_(std::filesystem::path(options_.path).filename().string()),
      clock_(clock),
      timer_(std::move(timer)) {}

// The timer's expirations are read and dropped: the bus is looked at because they came. A line is listed only
// when its box answered, when a channel has it, or when there is a fault that Open can tell.
Result<std::vector<std::string>> SerialBus::Ports() {
  std::uint64_t expirations = 0;
  (void)!::read(timer_.get(), &expirations, sizeof expirations);
  struct stat file {};
  if (::stat(options_.path.c_str(), &file) != 0) {
    spoken_.reset();
    refused_.reset();
    loan_.was_strange = false;  // What comes next is another adapter.
    return std::vector<std::string>{};
  }
  Tend();
  if (loan_.is_out || fault() || is_ready()) return std::vector<std::string>{port_};
  return std::vector<std::string>{};
}

// A line that hangs up is closed, and opened anew at the next look.
void SerialBus::Tend() {
  if (loan_.is_out) return;
  if (!spoken_) {
    auto line = OpenSerialLine(options_.path);
    refused_ = line ? std::nullopt : std::optional(line.error());
    if (!line) return;
    spoken_.emplace(
        SpokenLine{std::move(*line), decode::SerialDialSession(options_.box, options_.counts_per_turn)});
  }
  SendDue(*spoken_, clock_.now());
  std::array<std::uint8_t, 256> bytes;
  for (int reads = 0; reads < kReadsAtOnce; ++reads) {
    const ssize_t got = ::read(spoken_->line.get(), bytes.data(), bytes.size());
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) break;
    if (got <= 0) return spoken_.reset();
    for (const std::uint8_t byte : std::span(bytes).first(static_cast<std::size_t>(got)))
      spoken_->session.Accept(byte, clock_.now());
  }
  SendDue(*spoken_, clock_.now());
}

// After a line that was strange the next one has to show that it is not.
bool SerialBus::is_ready() const {
  if (!spoken_ || spoken_->session.state() != decode::SerialDialSession::State::kReady) return false;
  return !loan_.was_strange || spoken_->session.decoder().whole() > 0;
}

// Nothing while the box still has time to answer. A line that could not be opened is told first; then one
// that speaks otherwise than it should, by the wrong kind or another speed; then silence.
std::optional<Error> SerialBus::fault() const {
  if (refused_) return refused_;
  if (!spoken_ || is_ready()) return std::nullopt;
  if (loan_.was_strange || spoken_->session.state() == decode::SerialDialSession::State::kStrange)
    return Error{std::errc::protocol_error, fmt::format("use the dial box at {} as one of the kind {}",
                                                        options_.path, NameOf(options_.box))};
  if (spoken_->session.state() != decode::SerialDialSession::State::kSilent) return std::nullopt;
  return Error{
      std::errc::timed_out,
      fmt::format("ask the dial box at {}, of the kind {}, whether it has power and its cable is right",
                  options_.path, NameOf(options_.box))};
}

Result<std::unique_ptr<ports::HidChannel>> SerialBus::Open(const std::string& port) {
  if (port != port_) return Fail(std::errc::no_such_device, "open the serial line " + port);
  if (loan_.is_out) return Fail(std::errc::device_or_resource_busy, "open the serial line " + port);
  Tend();
  if (auto wrong = fault()) return tl::unexpected(*wrong);
  if (!is_ready())
    return Fail(std::errc::device_or_resource_busy,
                "open the serial line " + port + ": it has not answered yet");
  loan_.was_strange = false;
  auto channel = std::make_unique<SerialChannel>(std::move(*spoken_), port_, clock_, loan_);
  spoken_.reset();
  return channel;
}

}  // namespace kaori::serial
