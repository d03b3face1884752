#include "hw-sim/links/local/camera_port.h"

#include <algorithm>

namespace kaori::sim {
namespace {

// Room for the largest picture that the camera takes, so that a change of format needs no new memory; pages
// that are never drawn into cost nothing.
constexpr std::size_t kSlotBytes = std::size_t{1920} * 1080 * 2;

}  // namespace

std::optional<Time> CameraPort::next_due() const {
  if (!connected() || camera_.stalled()) return std::nullopt;
  // Frames are counted whether they are sent or not: a driver sees the gap in their numbers.
  return timing_.start + (last_ + 1) * timing_.period;
}

// Nothing is lent yet: a driver that crashed gives nothing back.
bool CameraPort::Greet() {
  // New memory for each driver: one that is still mapped by the driver before
  // cannot be written into by this one.
  auto memory = SharedMemory::Make("kaori-camera", kSlots * kSlotBytes);
  if (!memory) return false;
  memory_ = std::move(*memory);
  lent_.fill(false);
  return Send(wire::Encode(wire::CameraHello{kSlots, kSlotBytes}), memory_.descriptor());
}

void CameraPort::Handle(std::span<const std::uint8_t> packet) {
  // A packet of another length is no return; it is passed over, since nothing
  // would be gained by hanging up.
  if (packet.size() != wire::kCameraReturnBytes) return;
  const std::uint32_t slot = wire::GetU32(packet, 0);
  if (slot < lent_.size()) lent_[slot] = false;
}

// A frame whose time has gone by is not made up for: the newest one counts.
void CameraPort::SendDue(Time now) {
  const std::int64_t number = (now - timing_.start) / timing_.period;
  if (number <= last_) return;
  last_ = number;
  const auto slot = std::ranges::find(lent_, false);
  if (camera_.stalled() || slot == lent_.end()) return;
  SendFrame(number, static_cast<std::size_t>(slot - lent_.begin()));
}

// Draws first, announces then: the driver may read the slot as soon as the packet is there.
void CameraPort::SendFrame(std::int64_t number, std::size_t slot) {
  const auto room = memory_.bytes().subspan(slot * kSlotBytes, kSlotBytes);
  const std::size_t bytes = camera_.Shoot(static_cast<std::uint32_t>(number), room);
  wire::CameraFrameNote note = Describe(number, slot, bytes);
  const Spoil spoil = camera_.ExchangeSpoil();
  if (spoil == Spoil::kPixels) FillWithNoise(note.sequence, room.first(bytes));
  if (spoil == Spoil::kMessage) {
    // Numbers that no check may let through: a time before the machine's start, a
    // slot and sizes beyond everything.
    note = {.at_ns = -1,
            .sequence = note.sequence,
            .slot = 0xFFFFFFFF,
            .width_px = 0xFFFFFFFF,
            .bytes = 0xFFFFFFF0};
    Send(wire::Encode(note));
    return;
  }
  // A frame whose packet did not leave is nobody's: its slot stays free.
  lent_[slot] = Send(wire::Encode(note));
}

wire::CameraFrameNote CameraPort::Describe(std::int64_t number, std::size_t slot, std::size_t bytes) const {
  const auto format = camera_.format();
  return {.at_ns = (timing_.start + number * timing_.period).time_since_epoch().count(),
          .sequence = static_cast<std::uint32_t>(number),
          .slot = static_cast<std::uint32_t>(slot),
          .width_px = static_cast<std::uint32_t>(format.width_px),
          .height_px = static_cast<std::uint32_t>(format.height_px),
          .stride_bytes = camera_.stride_bytes(),
          .pixels = static_cast<std::uint32_t>(format.pixels),
          .bytes = static_cast<std::uint32_t>(bytes)};
}

}  // namespace kaori::sim
