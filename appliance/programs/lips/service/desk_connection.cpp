#include "appliance/programs/lips/service/desk_connection.h"

#include <unistd.h>

#include <algorithm>

#include "appliance/programs/lips/service/small_picture.h"
#include "drivers/base/log.h"
#include "drivers/base/packet_socket.h"

namespace kaori::lips {
namespace {

constexpr int kCommandsAtOnce = 64;  // A desk that sends without end must not hold the lips up.
// A page asks again every half second; pictures come 16 times a second at most, and reports ten times.
constexpr Duration kLookDuration = std::chrono::seconds(2);
constexpr Duration kPicturePeriod = std::chrono::milliseconds(60);
constexpr Duration kReportPeriod = std::chrono::milliseconds(100);

}  // namespace

// A socket's file that a killed program left behind is replaced (ListenForPackets).
Result<DeskConnection> DeskConnection::Open(const std::string& path) {
  auto listener = ListenForPackets(path);
  if (!listener) return tl::unexpected(listener.error());
  return DeskConnection(std::move(*listener), path);
}

// A connection that was moved from has no listener, and leaves the file to the one that has.
DeskConnection::~DeskConnection() {
  if (listener_.valid()) ::unlink(path_.c_str());
}

// A new desk gets shared memory of its own, so that an older one that hangs cannot write into its pictures.
void DeskConnection::Accept() {
  auto peer = AcceptPeer(listener_.get());
  if (!peer) return;
  auto pictures = SharedMemory::Make("kaori-lips", std::size_t{kPictureSlots} * kPictureSlotBytes);
  if (!pictures) return LogWarning("{}; the desk is refused", pictures.error().message());
  peer_ = std::move(*peer);
  pictures_ = std::move(*pictures);
  in_use_.fill(false);
  wanted_until_ = report_at_ = {};
  if (Send(HelloPacket(), pictures_.descriptor())) Log("lips: a desk is connected");
}

// A packet that is no command closes the connection; the desk connects again by itself within a quarter of a
// second.
std::vector<Command> DeskConnection::ReceiveCommands(Time now) {
  Accept();
  std::vector<Command> commands;
  for (int n = 0; n < kCommandsAtOnce && peer_.valid(); ++n) {
    std::array<std::uint8_t, kMaxCommandBytes> bytes;
    const auto packet = ReceivePacket(peer_.get(), bytes);
    if (!packet && packet.error().cause == std::errc::resource_unavailable_try_again) break;
    const auto command = packet ? ParseCommand({reinterpret_cast<const char*>(bytes.data()), packet->bytes})
                                : Result<Command>(tl::unexpected(packet.error()));
    if (!command) {
      LogWarning("lips: the connection to the desk is closed: {}", command.error().message());
      peer_.reset();
    } else if (command->kind == CommandKind::kLook || command->kind == CommandKind::kReturn) {
      HandlePictureCommand(*command, now);
    } else {
      commands.push_back(*command);
    }
  }
  return commands;
}

// A slot that does not exist is passed over, as is one that is returned twice.
void DeskConnection::HandlePictureCommand(const Command& command, Time now) {
  if (command.kind == CommandKind::kLook) wanted_until_ = now + kLookDuration;
  const auto slot = static_cast<std::size_t>(std::clamp(command.a, 0.0F, 1e3F));
  if (command.kind == CommandKind::kReturn && slot < in_use_.size()) in_use_[slot] = false;
}

// A report that could not be sent is sent at the next step, as it is then.
void DeskConnection::SendReport(const Report& report, Time now) {
  if (!peer_.valid() || (report == sent_ && now - report_at_ < kReportPeriod)) return;
  if (!Send(Packet(report))) return;
  sent_ = report;
  report_at_ = now;
}

// The slot counts as in use only where the note could be sent: otherwise nobody would return it.
void DeskConnection::SendPicture(const decode::Planes& planes, const PaintKey& key, Time now) {
  if (!peer_.valid() || now >= wanted_until_ || now - picture_at_ < kPicturePeriod) return;
  const auto slot = std::ranges::find(in_use_, false);
  if (slot == in_use_.end()) return;  // The desk has given none back yet.
  const auto number = static_cast<std::uint32_t>(slot - in_use_.begin());
  const SmallSize size = SmallSizeOf(planes, kPictureMaxWidth_px);
  DrawSmall(planes, key, size, pictures_.bytes().subspan(std::size_t{number} * kPictureSlotBytes));
  picture_at_ = now;
  *slot = Send(Packet(PictureNote{.slot = number,
                                  .number = number_,
                                  .width_px = static_cast<std::uint32_t>(size.width_px),
                                  .height_px = static_cast<std::uint32_t>(size.height_px)}));
  if (*slot) ++number_;
}

// A desk that does not read loses the packet; the connection to one that is gone is closed.
bool DeskConnection::Send(const std::vector<std::uint8_t>& packet, int descriptor) {
  if (!peer_.valid()) return false;
  const auto sent = SendPacket(peer_.get(), packet, descriptor);
  if (!sent && sent.error().cause != std::errc::resource_unavailable_try_again) peer_.reset();
  return sent.has_value();
}

}  // namespace kaori::lips
