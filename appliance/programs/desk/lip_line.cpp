#include "appliance/programs/desk/lip_line.h"

#include <algorithm>
#include <array>

#include "drivers/base/log.h"
#include "drivers/base/packet_socket.h"

namespace kaori::desk {
namespace {

constexpr Duration kRetry = std::chrono::milliseconds(250);
constexpr Duration kLookPeriod = std::chrono::milliseconds(500);
constexpr int kAtOnce = 64;

}  // namespace

void LipLine::Step(Time now) {
  if (!socket_.valid() && now >= retry_at_) Connect(now);
  if (socket_.valid()) Hear();
}

void LipLine::Connect(Time now) {
  retry_at_ = now + kRetry;
  auto socket = ConnectToPeer(path_);
  if (!socket) return;  // Expected while no lips are in service.
  socket_ = std::move(*socket);
  look_at_ = {};
}

void LipLine::Hear() {
  for (int n = 0; n < kAtOnce && socket_.valid(); ++n) {
    std::array<std::uint8_t, lips::kMostWordBytes> bytes;
    auto packet = ReceivePacket(socket_.get(), bytes);
    if (!packet && packet.error().cause == std::errc::resource_unavailable_try_again) return;
    if (!packet || !Handle(std::span(bytes).first(packet->bytes), std::move(packet->descriptor))) HangUp();
  }
}

// False: nothing that these lips say can be believed.
bool LipLine::Handle(std::span<const std::uint8_t> packet, UniqueFd descriptor) {
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
  number_ = std::max(number_, report->answered);  // A desk that was started again counts on.
  return true;
}

// Copied at once, so that a browser may take its time.
void LipLine::Copy(const lips::PictureNote& note) {
  const std::size_t bytes = std::size_t{note.width_px} * note.height_px * 4;
  if (!pictures_.valid() || bytes > lips::kPictureSlotBytes) return;
  const auto from = pictures_.bytes().subspan(std::size_t{note.slot} * lips::kPictureSlotBytes, bytes);
  picture_.rgbp.assign(from.begin(), from.end());
  picture_.width_px = static_cast<int>(note.width_px);
  picture_.height_px = static_cast<int>(note.height_px);
  ++picture_.number;
  static_cast<void>(Send({.ask = lips::Ask::kReturn, .a = static_cast<float>(note.slot)}));
}

Result<std::uint32_t> LipLine::Ask(lips::Command command) {
  command.number = ++number_;
  if (auto sent = Send(command); !sent) return tl::unexpected(sent.error());
  return command.number;
}

void LipLine::Look(Time now) {
  if (now < look_at_) return;
  look_at_ = now + kLookPeriod;
  static_cast<void>(Send({.ask = lips::Ask::kLook}));
}

Result<void> LipLine::Send(const lips::Command& command) {
  if (!socket_.valid()) return Fail(std::errc::no_such_device, "ask the lips");
  const std::string text = lips::CommandText(command);
  return SendPacket(socket_.get(), {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

void LipLine::HangUp() {
  if (live()) Log("the lips are gone");
  socket_.reset();
  report_.reset();
  pictures_ = SharedMemory();
}

}  // namespace kaori::desk
