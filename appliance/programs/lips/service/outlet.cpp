#include "appliance/programs/lips/service/outlet.h"

#include <unistd.h>

#include <algorithm>

#include "appliance/programs/lips/service/small_picture.h"
#include "drivers/base/log.h"
#include "drivers/base/packet_socket.h"

namespace kaori::lips {
namespace {

constexpr int kAtOnce = 64;  // A desk that asks without end must not hold the lips.
constexpr Duration kLookLasts = std::chrono::seconds(2);
constexpr Duration kPicturePeriod = std::chrono::milliseconds(60);
constexpr Duration kTellPeriod = std::chrono::milliseconds(100);

}  // namespace

Result<Outlet> Outlet::Open(const std::string& path) {
  auto listener = ListenForPackets(path);
  if (!listener) return tl::unexpected(listener.error());
  return Outlet(std::move(*listener), path);
}

Outlet::~Outlet() {
  if (listener_.valid()) ::unlink(path_.c_str());
}

void Outlet::Accept() {
  auto peer = AcceptPeer(listener_.get());
  if (!peer) return;
  auto pictures = SharedMemory::Make("kaori-lips", std::size_t{kPictureSlots} * kPictureSlotBytes);
  if (!pictures) return LogWarning("{}; a desk is refused", pictures.error().message());
  peer_ = std::move(*peer);
  pictures_ = std::move(*pictures);
  lent_.fill(false);
  look_until_ = told_at_ = {};
  if (Send(HelloPacket(), pictures_.descriptor())) Log("lips: a desk is here");
}

std::vector<Command> Outlet::Hear(Time now) {
  Accept();
  std::vector<Command> heard;
  for (int n = 0; n < kAtOnce && peer_.valid(); ++n) {
    std::array<std::uint8_t, kMostCommandBytes> bytes;
    const auto packet = ReceivePacket(peer_.get(), bytes);
    if (!packet && packet.error().cause == std::errc::resource_unavailable_try_again) break;
    const auto command = packet ? ParseCommand({reinterpret_cast<const char*>(bytes.data()), packet->bytes})
                                : Result<Command>(tl::unexpected(packet.error()));
    if (!command) {
      Log("lips: the desk is gone ({})", command.error().message());
      peer_.reset();
    } else if (command->ask == Ask::kLook || command->ask == Ask::kReturn) {
      Obey(*command, now);
    } else {
      heard.push_back(*command);
    }
  }
  return heard;
}

void Outlet::Obey(const Command& command, Time now) {
  if (command.ask == Ask::kLook) look_until_ = now + kLookLasts;
  const auto slot = static_cast<std::size_t>(std::clamp(command.a, 0.0F, 1e3F));
  if (command.ask == Ask::kReturn && slot < lent_.size()) lent_[slot] = false;
}

void Outlet::Tell(const Report& report, Time now) {
  if (!peer_.valid() || (report == told_ && now - told_at_ < kTellPeriod)) return;
  if (!Send(Packet(report))) return;
  told_ = report;
  told_at_ = now;
}

void Outlet::Show(const decode::Planes& planes, const PaintKey& key, Time now) {
  if (!peer_.valid() || now >= look_until_ || now - shown_at_ < kPicturePeriod) return;
  const auto slot = std::ranges::find(lent_, false);
  if (slot == lent_.end()) return;  // The desk still looks at all of them.
  const auto number = static_cast<std::uint32_t>(slot - lent_.begin());
  const SmallSize size = SmallSizeOf(planes, kPictureMostWidth_px);
  DrawSmall(planes, key, size, pictures_.bytes().subspan(std::size_t{number} * kPictureSlotBytes));
  shown_at_ = now;
  *slot = Send(Packet(PictureNote{.slot = number,
                                  .number = number_,
                                  .width_px = static_cast<std::uint32_t>(size.width_px),
                                  .height_px = static_cast<std::uint32_t>(size.height_px)}));
  if (*slot) ++number_;
}

// A desk that does not read loses the packet; one that is gone is let go.
bool Outlet::Send(const std::vector<std::uint8_t>& packet, int descriptor) {
  if (!peer_.valid()) return false;
  const auto sent = SendPacket(peer_.get(), packet, descriptor);
  if (!sent && sent.error().cause != std::errc::resource_unavailable_try_again) peer_.reset();
  return sent.has_value();
}

}  // namespace kaori::lips
