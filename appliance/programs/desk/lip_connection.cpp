#include "appliance/programs/desk/lip_connection.h"

#include <algorithm>
#include <array>

#include "drivers/base/log.h"
#include "drivers/base/packet_socket.h"

namespace kaori::desk {
namespace {

// Lips that start are found within this time.
constexpr Duration kRetry = std::chrono::milliseconds(250);
// The lips send pictures for two seconds after each request, so that a lost one costs nothing.
constexpr Duration kRequestPeriod = std::chrono::milliseconds(500);
constexpr int kPacketsAtOnce = 64;

}  // namespace

// A connection that was just made is read at once: the hello may lie in it already.
void LipConnection::Step(Time now) {
  if (!socket_.valid() && now >= retry_at_) Connect(now);
  if (socket_.valid()) ReceivePackets();
}

// No report is there yet, so that live() is false until the lips have answered.
void LipConnection::Connect(Time now) {
  retry_at_ = now + kRetry;
  auto socket = ConnectToPeer(path_);
  if (!socket) return;  // This is expected while no lips are in service.
  socket_ = std::move(*socket);
  request_at_ = {};
}

// A bounded number, so that lips which send without end do not keep the browsers waiting.
void LipConnection::ReceivePackets() {
  for (int n = 0; n < kPacketsAtOnce && socket_.valid(); ++n) {
    std::array<std::uint8_t, lips::kMaxPacketBytes> bytes;
    auto packet = ReceivePacket(socket_.get(), bytes);
    if (!packet && packet.error().cause == std::errc::resource_unavailable_try_again) return;
    if (!packet || !Handle(std::span(bytes).first(packet->bytes), std::move(packet->descriptor)))
      Disconnect();
  }
}

// Returns false for a packet that breaks the protocol; the connection is then closed.
bool LipConnection::Handle(std::span<const std::uint8_t> packet, UniqueFd descriptor) {
  if (lips::IsHello(packet)) {
    auto pictures = SharedMemory::Adopt(std::move(descriptor),
                                        std::size_t{lips::kPictureSlots} * lips::kPictureSlotBytes);
    if (pictures) pictures_ = std::move(*pictures);
    return pictures.has_value();
  }
  if (const auto note = lips::ReadPictureNote(packet)) {
    Copy(*note);
    return true;
  }
  const auto report = lips::ReadReport(packet);
  if (!report) return false;
  if (!live()) Log("the lips answer");
  report_ = *report;
  number_ = std::max(number_, report->answered);  // A desk that was restarted goes on counting.
  return true;
}

// The picture is copied at once, so that a slow browser holds no slot.
void LipConnection::Copy(const lips::PictureNote& note) {
  const std::size_t bytes = std::size_t{note.width_px} * note.height_px * 4;
  if (!pictures_.valid() || bytes > lips::kPictureSlotBytes) return;
  const auto from = pictures_.bytes().subspan(std::size_t{note.slot} * lips::kPictureSlotBytes, bytes);
  picture_.rgbp.assign(from.begin(), from.end());
  picture_.width_px = static_cast<int>(note.width_px);
  picture_.height_px = static_cast<int>(note.height_px);
  ++picture_.number;
  static_cast<void>(SendNow({.kind = lips::CommandKind::kReturn, .a = static_cast<float>(note.slot)}));
}

// The number is used up even where sending fails, so that none stands for two commands.
Result<std::uint32_t> LipConnection::Send(lips::Command command) {
  command.number = ++number_;
  if (auto sent = SendNow(command); !sent) return tl::unexpected(sent.error());
  return command.number;
}

// A request that could not be sent is not repeated before its time: the next one comes half a second later.
void LipConnection::RequestPictures(Time now) {
  if (now < request_at_) return;
  request_at_ = now + kRequestPeriod;
  static_cast<void>(SendNow({.kind = lips::CommandKind::kLook}));
}

// Errors: no_such_device while no lips are connected; those of SendPacket.
Result<void> LipConnection::SendNow(const lips::Command& command) {
  if (!socket_.valid()) return Fail(std::errc::no_such_device, "send a command to the lips");
  const std::string text = lips::CommandText(command);
  return SendPacket(socket_.get(), {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

// The last picture stays for pages that still show it; the shared memory is given back.
void LipConnection::Disconnect() {
  if (live()) LogWarning("the connection to the lips is closed");
  socket_.reset();
  report_.reset();
  pictures_ = SharedMemory();
}

}  // namespace kaori::desk
