#include "drivers/gpio/local_lines.h"

#include <poll.h>

#include <array>
#include <utility>

#include "drivers/base/packet_socket.h"
#include "firmware/wire/link_lines.h"

namespace kaori::gpio {
namespace {

// The panel answers at once when it runs at all; a box that starts must not wait for one that hangs.
constexpr Duration kPanelPatience = std::chrono::milliseconds(100);
constexpr std::uint32_t kMostLines = 32;  // The bits of a level.

}  // namespace

// A panel that is unplugged and one that was never there are alike. A socket that may not be opened is
// another matter: waiting would not mend it.
Result<std::unique_ptr<LocalLines>> LocalLines::Connect(const std::string& folder, const std::string& port) {
  const std::string path = folder + "/lines." + port;
  auto socket = ConnectToPeer(path);
  if (socket) return std::make_unique<LocalLines>(std::move(*socket), path);
  const bool denied = socket.error().cause == std::errc::permission_denied;
  return Fail(denied ? std::errc::permission_denied : std::errc::no_such_device, socket.error().attempt);
}

// Blocks for the hello, `patience` at most: without it nobody knows how many lines there are. A number beyond
// 32 breaks the link, since lines are bits of a word.
Result<void> LocalLines::Greet(Duration patience) {
  const auto patience_ms = std::chrono::duration_cast<std::chrono::milliseconds>(patience).count();
  pollfd waiting{socket_.get(), POLLIN, 0};
  // A panel that hangs up also ends the wait; the reading below says that it has gone.
  if (::poll(&waiting, 1, static_cast<int>(patience_ms)) <= 0)
    return Fail(std::errc::timed_out, "wait for the lines of " + name_);
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  const auto packet = ReceivePacket(socket_.get(), buffer);
  if (!packet) return Fail(packet.error().cause, "read the lines of " + name_);
  const auto hello = wire::DecodeLinesHello(std::span(buffer).first(packet->bytes));
  if (!hello || hello->inputs > kMostLines || hello->outputs > kMostLines) return Broken();
  inputs_ = hello->inputs;
  outputs_ = hello->outputs;
  active_ = hello->active;
  return {};
}

// The levels as the edges that were given so far have left them: a level never tells
// of an edge that is still to be read.
Result<std::uint32_t> LocalLines::Levels() {
  if (broken_) return Broken();
  if (gone_) return Gone();
  return active_;
}

// Times are those that the panel gave its edges, on this machine's clock. A packet that is no edge, or of a
// line that is not there, breaks the link for good.
Result<ports::GpioEdge> LocalLines::ReadEdge() {
  if (broken_) return Broken();
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  const auto packet = ReceivePacket(socket_.get(), buffer);
  if (!packet) {
    const auto cause = packet.error().cause;
    if (cause == std::errc::no_such_device) return Gone();
    const bool none = cause == std::errc::resource_unavailable_try_again;
    return Fail(none ? cause : std::errc::io_error, "read an edge of " + name_);
  }
  const auto edge = wire::DecodeLineEdge(std::span(buffer).first(packet->bytes));
  if (!edge || edge->line >= inputs_) return Broken();
  // Below 32: the hello was checked.
  const std::uint32_t bit = 1U << edge->line;
  active_ = edge->active != 0 ? active_ | bit : active_ & ~bit;
  return ports::GpioEdge{Time(Duration(edge->at_ns)), edge->line, edge->active != 0};
}

Result<void> LocalLines::Drive(std::uint32_t line, bool active) {
  if (line >= outputs_) return FailInput("drive an output that " + name_ + " has not");
  if (broken_) return Broken();
  if (gone_) return Gone();
  const auto sent = SendPacket(socket_.get(), wire::Encode(wire::LineDrive{line, active ? 1U : 0U}));
  if (sent) return {};
  const auto cause = sent.error().cause;
  if (cause == std::errc::no_such_device) return Gone();
  // A panel that reads too slowly is still there, and so are its edges.
  const bool later = cause == std::errc::resource_unavailable_try_again;
  return Fail(later ? cause : std::errc::io_error, "drive an output of " + name_);
}

tl::unexpected<Error> LocalLines::Gone() {
  gone_ = true;
  return Fail(std::errc::no_such_device, "use the lines of " + name_);
}

tl::unexpected<Error> LocalLines::Broken() {
  broken_ = true;
  return Fail(std::errc::io_error, "understand the packets of " + name_);
}

Result<std::unique_ptr<ports::GpioLines>> OpenLocalLines(const std::string& folder) {
  auto lines = LocalLines::Connect(folder);
  if (!lines) return tl::unexpected(lines.error());
  if (auto ok = (*lines)->Greet(kPanelPatience); !ok) return tl::unexpected(ok.error());
  return std::move(*lines);
}

}  // namespace kaori::gpio
