#include "drivers/scanout/local_screen.h"

#include <array>

#include "drivers/base/packet_socket.h"

namespace kaori::scanout {
namespace {

// Bounds of a hello that makes sense: products of them fit into 64 bits.
constexpr std::uint32_t kMostSlots = 8;
constexpr std::uint32_t kMostSide = 16384;
constexpr std::int64_t kLongestPeriod_ns = 1'000'000'000;
constexpr std::int64_t kLastTime_ns = std::int64_t{1} << 62;  // Sums with it do not overflow.

// Whether a stamp is one that a clock can give: stamps before the machine's start, or near the
// end of time, are a broken simulator's.
bool IsTime(std::int64_t at_ns) {
  return at_ns >= 0 && at_ns <= kLastTime_ns;
}

// Two slots at least: one is shown while the other one is drawn.
bool MakesSense(const wire::ScreenHello& hello) {
  return hello.slots >= 2 && hello.slots <= kMostSlots && hello.width_px > 0 && hello.width_px <= kMostSide &&
         hello.height_px > 0 && hello.height_px <= kMostSide && hello.period_ns > 0 &&
         hello.period_ns <= kLongestPeriod_ns;
}

}  // namespace

Result<std::unique_ptr<ports::Scanout>> LocalScreen::Open(const std::string& folder,
                                                          const std::string& port) {
  auto socket = ConnectToPeer(folder + "/screen." + port);
  if (socket) return std::make_unique<LocalScreen>(std::move(*socket), folder);
  const bool denied = socket.error().cause == std::errc::permission_denied;
  return Fail(denied ? std::errc::permission_denied : std::errc::no_such_device, socket.error().attempt);
}

// A screen that sends what cannot be read counts as gone, and is opened anew.
Result<std::size_t> LocalScreen::Receive(std::span<std::uint8_t> into, UniqueFd* descriptor) {
  if (gone_) return Fail(std::errc::no_such_device, "read the local screen");
  auto packet = ReceivePacket(socket_.get(), into);
  if (packet) {
    *descriptor = std::move(packet->descriptor);
    return packet->bytes;
  }
  if (packet.error().cause == std::errc::resource_unavailable_try_again)
    return tl::unexpected(packet.error());
  // Any other failure ends the connection: nothing tells where the next packet would begin to make sense.
  gone_ = true;
  return Fail(std::errc::no_such_device, "read the local screen");
}

Result<void> LocalScreen::ReadHello() {
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  UniqueFd descriptor;
  const auto bytes = Receive(buffer, &descriptor);
  if (!bytes) return tl::unexpected(bytes.error());
  // Until the hello has been understood.
  gone_ = true;
  const auto hello = wire::DecodeScreenHello(std::span(buffer).first(*bytes));
  if (!hello || !MakesSense(*hello)) return Fail(std::errc::no_such_device, "read the local screen's hello");
  hello_ = *hello;
  auto memory = SharedMemory::Adopt(std::move(descriptor), hello_.slots * picture_bytes());
  if (!memory) return Fail(std::errc::no_such_device, memory.error().attempt);
  memory_ = std::move(*memory);
  gone_ = false;
  return {};
}

Result<ports::PixelBuffer> LocalScreen::Acquire() {
  if (!memory_.valid()) {
    if (auto greeted = ReadHello(); !greeted) return tl::unexpected(greeted.error());
  }
  if (gone_) return Fail(std::errc::no_such_device, "acquire a buffer of the local screen");
  if (presented_)
    return Fail(std::errc::resource_unavailable_try_again, "acquire a buffer of the local screen");
  acquired_ = true;
  return ports::PixelBuffer{
      static_cast<int>(hello_.width_px), static_cast<int>(hello_.height_px),
      ports::PixelMemory{memory_.bytes().subspan(next_slot_ * picture_bytes(), picture_bytes())}};
}

Result<void> LocalScreen::Present(std::uint64_t frame) {
  if (!acquired_) return FailInput("present without a buffer");
  if (gone_ || !SendPacket(socket_.get(), wire::Encode(wire::ScreenPresent{frame, next_slot_}))) {
    gone_ = true;
    return Fail(std::errc::no_such_device, "present a frame on the local screen");
  }
  acquired_ = false;
  presented_ = frame;
  return {};
}

// Slots are used in turn, which both sides count for themselves: after a flip that does not agree nobody
// knows what is on the screen, so that the link ends.
Result<ports::Flip> LocalScreen::ReadFlip() {
  if (!memory_.valid()) {
    if (auto greeted = ReadHello(); !greeted) return tl::unexpected(greeted.error());
  }
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  UniqueFd none;
  const auto bytes = Receive(buffer, &none);
  if (!bytes) return tl::unexpected(bytes.error());
  const auto flip = wire::DecodeScreenFlip(std::span(buffer).first(*bytes));
  // A flip must be that of the frame that was presented, in the slot that it was drawn into.
  if (!flip || !presented_ || flip->frame != *presented_ || flip->slot != next_slot_ ||
      !IsTime(flip->at_ns)) {
    gone_ = true;
    return Fail(std::errc::no_such_device, "read a flip of the local screen");
  }
  presented_.reset();
  next_slot_ = (next_slot_ + 1) % hello_.slots;
  return ports::Flip{Time(Duration(flip->at_ns)), flip->frame, Duration(hello_.period_ns)};
}

ports::SideDisplay* LocalScreen::monitor_display() {
  if (monitor_ && !monitor_->IsThere()) monitor_.reset();
  if (!monitor_ && !folder_.empty()) monitor_ = LocalMonitor::Open(folder_);
  return monitor_.get();
}

std::vector<ports::Output> LocalScreen::outputs() const {
  if (gone_ || !memory_.valid()) return {};
  return {{.connector = "simulator",
           .width_px = static_cast<int>(hello_.width_px),
           .height_px = static_cast<int>(hello_.height_px),
           .rate_hz = 1 / Seconds(Duration(hello_.period_ns))}};
}

}  // namespace kaori::scanout
