#include "drivers/camera/local_camera.h"

#include <array>

#include "drivers/base/packet_socket.h"

namespace kaori::camera {
namespace {

// Bounds of a hello that makes sense. They are checked before anything is mapped or multiplied.
constexpr std::uint32_t kMostSlots = 64;
constexpr int kNotesAtOnce = 64;  // In one call: a camera that never stops must not hold us.
constexpr std::uint32_t kMostSlotBytes = 64u << 20;
constexpr std::uint32_t kMostSide = 16384;

// Bounds that keep products of them within 64 bits.
bool HasAnyFrameSize(const wire::CameraFrameNote& note) {
  return note.width_px > 0 && note.width_px <= kMostSide && note.height_px > 0 &&
         note.height_px <= kMostSide && note.stride_bytes <= 4 * kMostSide;
}

// Whether the numbers fit each other, so that a reader who trusts them stays within the bytes.
bool MakesSense(const wire::CameraFrameNote& note) {
  if (!HasAnyFrameSize(note) || note.bytes == 0) return false;
  const std::uint64_t rows = std::uint64_t{note.stride_bytes} * note.height_px;
  switch (note.pixels) {
    case static_cast<std::uint32_t>(ports::PixelFormat::kYuyv):
      return note.width_px % 2 == 0 && note.stride_bytes >= note.width_px * 2 && note.bytes >= rows;
    case static_cast<std::uint32_t>(ports::PixelFormat::kNv12):
      return note.width_px % 2 == 0 && note.height_px % 2 == 0 && note.stride_bytes >= note.width_px &&
             note.bytes >= rows + rows / 2;
    case static_cast<std::uint32_t>(ports::PixelFormat::kMjpeg):
      return true;
    default:
      return false;
  }
}

}  // namespace

Result<std::unique_ptr<ports::Camera>> LocalCamera::Open(const std::string& folder, const std::string& port) {
  const std::string path = folder + "/camera." + port;
  auto socket = ConnectToPeer(path);
  if (socket) return std::make_unique<LocalCamera>(std::move(*socket), path);
  const bool denied = socket.error().cause == std::errc::permission_denied;
  return Fail(denied ? std::errc::permission_denied : std::errc::no_such_device, socket.error().attempt);
}

// An error of ReceivePacket as an error of the port.
tl::unexpected<Error> LocalCamera::ReceiveError(const Error& error) const {
  const bool waits = error.cause == std::errc::resource_unavailable_try_again;
  const bool gone = error.cause == std::errc::no_such_device;
  return Fail(waits || gone ? error.cause : std::errc::io_error, "read a frame of " + name_);
}

// The frame borrows its slot until the next call, which gives it back to the simulator: one that never calls
// again keeps one slot and no more.
Result<ports::CameraFrame> LocalCamera::Next() {
  if (broken_) return Fail(std::errc::io_error, "read the hello of " + name_);
  // The caller's frame ends with this call.
  if (borrowed_) GiveBack(*borrowed_);
  borrowed_.reset();
  if (!memory_.valid()) {
    if (auto greeted = ReadHello(); !greeted) return tl::unexpected(greeted.error());
  }
  const auto note = NewestNote();
  if (!note) return tl::unexpected(note.error());
  if (!*note) return Fail(std::errc::bad_message, "read a frame's note of " + name_);
  return Borrow(**note);
}

Result<void> LocalCamera::ReadHello() {
  std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
  auto packet = ReceivePacket(socket_.get(), buffer);
  if (!packet && packet.error().cause != std::errc::message_size) return ReceiveError(packet.error());
  // Until the hello has been understood.
  broken_ = true;
  const auto hello = packet ? wire::DecodeCameraHello(std::span(buffer).first(packet->bytes)) : std::nullopt;
  if (!hello || hello->slots == 0 || hello->slots > kMostSlots || hello->slot_bytes > kMostSlotBytes)
    return Fail(std::errc::io_error, "read the hello of " + name_);
  auto memory =
      SharedMemory::Adopt(std::move(packet->descriptor), std::size_t{hello->slots} * hello->slot_bytes);
  if (!memory) return Fail(std::errc::io_error, memory.error().attempt);
  memory_ = std::move(*memory);
  hello_ = *hello;
  broken_ = false;
  return {};
}

// The newest note that was sent; slots of earlier ones go back. None: the newest one was torn, and
// its slot is not known, so it stays with us.
Result<std::optional<wire::CameraFrameNote>> LocalCamera::NewestNote() {
  std::optional<wire::CameraFrameNote> newest;
  bool any = false;
  for (int n = 0; n < kNotesAtOnce; ++n) {
    std::array<std::uint8_t, wire::kMaxLinkPacket> buffer;
    const auto packet = ReceivePacket(socket_.get(), buffer);
    const bool torn = !packet && packet.error().cause == std::errc::message_size;
    if (!packet && !torn) {
      if (any) return newest;  // The next call meets the stream's end again.
      return ReceiveError(packet.error());
    }
    any = true;
    // Only the newest frame is given: the older one's slot goes back at once.
    if (newest) GiveBack(newest->slot);
    newest = torn ? std::nullopt : wire::DecodeCameraFrame(std::span(buffer).first(packet->bytes));
  }
  return newest;
}

// A slot that does not exist is not given back: the simulator would refuse the packet.
Result<ports::CameraFrame> LocalCamera::Borrow(const wire::CameraFrameNote& note) {
  if (note.slot >= hello_.slots)
    return Fail(std::errc::bad_message, "read a frame of " + name_ + " from a slot that does not exist");
  if (!MakesSense(note) || note.bytes > hello_.slot_bytes) {
    GiveBack(note.slot);
    return Fail(std::errc::bad_message, "read a whole frame of " + name_);
  }
  borrowed_ = note.slot;
  const auto slot = memory_.bytes().subspan(std::size_t{note.slot} * hello_.slot_bytes, note.bytes);
  return ports::CameraFrame{.at = Time(Duration(note.at_ns)),
                            .sequence = note.sequence,
                            .format = {static_cast<int>(note.width_px), static_cast<int>(note.height_px),
                                       static_cast<ports::PixelFormat>(note.pixels)},
                            .stride_bytes = note.stride_bytes,
                            .bytes = slot};
}

// That the camera is gone is no error here: the next call tells.
void LocalCamera::GiveBack(std::uint32_t slot) {
  std::array<std::uint8_t, wire::kCameraReturnBytes> packet{};
  wire::PutU32(packet, 0, slot);
  static_cast<void>(SendPacket(socket_.get(), packet));
}

}  // namespace kaori::camera
