#include "hw-sim/devices/usb_midi.h"

#include <algorithm>
#include <array>

#include "hw-sim/devices/usb_descriptors.h"
#include "hw-sim/devices/usb_requests.h"

namespace kaori::sim {
namespace {

constexpr std::uint8_t kAudioClass = 1, kAudioControl = 1, kMidiStreaming = 3;
constexpr std::uint16_t kMidiPacketBytes = 64;  // Bulk at full speed (USB 2.0, 5.8.3).
constexpr std::size_t kEventBytes = 4;          // Of USB-MIDI, section 4.

// Class descriptors are of type 0x24 for interfaces and 0x25 for endpoints. The control interface names the
// streaming one, which is number 1 (audio devices, 4.3.2).
const UsbBytes kControlHeader{9, 0x24, 1, 0x00, 0x01, 9, 0, 1, 1};
// Four jacks: what the host sends comes in by the embedded jack 1 and goes out by the external jack 4, and the
// other way by 2 and 3 (USB-MIDI, appendix B). 65 bytes with the endpoints behind them.
const UsbBytes kJacks{
    7, 0x24, 1, 0x00, 0x01, 65, 0,        // Header
    6, 0x24, 2, 1,    1,    0,            // In, embedded, jack 1
    6, 0x24, 2, 2,    2,    0,            // In, external, jack 2
    9, 0x24, 3, 1,    3,    1,  2, 1, 0,  // Out, embedded, jack 3, from pin 1 of jack 2
    9, 0x24, 3, 2,    4,    1,  1, 1, 0,  // Out, external, jack 4, from pin 1 of jack 1
};
// Which jack an endpoint is of.
const UsbBytes kOfJack1{5, 0x25, 1, 1, 1}, kOfJack3{5, 0x25, 1, 1, 3};

UsbBytes MidiConfiguration() {
  UsbBytes all;
  for (const UsbBytes& part :
       {InterfaceDescriptor({.number = 0, .kind = kAudioClass, .subclass = kAudioControl, .protocol = 0}, 0),
        kControlHeader,
        InterfaceDescriptor({.number = 1, .kind = kAudioClass, .subclass = kMidiStreaming, .protocol = 0}, 2),
        kJacks, EndpointDescriptor({UsbMidi::kOut, UsbTransfer::kBulk, kMidiPacketBytes, 0, 1}), kOfJack1,
        EndpointDescriptor({UsbMidi::kIn, UsbTransfer::kBulk, kMidiPacketBytes, 0, 1}), kOfJack3})
    all.insert(all.end(), part.begin(), part.end());
  return ConfigurationOf(2, all);
}

// How many bytes of an event are MIDI, by its code index number (USB-MIDI, table 4-1).
constexpr std::array<std::size_t, 16> kEventLengths{0, 0, 2, 3, 3, 1, 2, 3, 3, 3, 3, 3, 2, 2, 3, 1};

}  // namespace

UsbMidi::UsbMidi(MidiTwin& surface) : surface_(surface) {
  const bool is_touch = surface.kind() == MidiTwin::Kind::kXTouchMini;
  descriptors_ = {.speed = UsbSpeed::kFull,
                  .vendor = static_cast<std::uint16_t>(is_touch ? 0x1397 : 0x2580),
                  .product = static_cast<std::uint16_t>(is_touch ? 0x00B3 : 0x0007),
                  .maker = is_touch ? "Behringer" : "DJ TechTools",
                  .name = is_touch ? "X-TOUCH MINI" : "Midi Fighter Twister",
                  .configuration = MidiConfiguration()};
}

// An event that carries nothing is filling.
void UsbMidi::HandleOut(std::uint8_t endpoint, std::span<const std::uint8_t> data) {
  if (endpoint != kOut) return;
  for (; data.size() >= kEventBytes; data = data.subspan(kEventBytes))
    surface_.Receive(data.subspan(1, kEventLengths[data[0] & 0x0FU]));
}

// The surfaces say messages of a channel, three bytes each, some with running status, and the clock between
// any two of their bytes.
void UsbMidi::Pack(std::span<const std::uint8_t> bytes) {
  constexpr std::uint8_t kRealTime = 0xF8, kStatus = 0x80, kSingleByte = 0x0F;
  for (const std::uint8_t byte : bytes) {
    if (byte >= kRealTime) {
      packets_.insert(packets_.end(), {kSingleByte, byte, 0, 0});
      continue;
    }
    if ((byte & kStatus) != 0) message_.clear();
    message_.push_back(byte);
    if (message_.size() < 3) continue;
    packets_.insert(packets_.end(),
                    {static_cast<std::uint8_t>(message_[0] >> 4U), message_[0], message_[1], message_[2]});
    message_.resize(1);
  }
}

std::optional<UsbBytes> UsbMidi::NextIn(std::uint8_t endpoint, std::size_t room_bytes, Time) {
  if (endpoint != kIn) return std::nullopt;
  Pack(surface_.Send());
  const std::size_t taken =
      std::min({packets_.size(), room_bytes / kEventBytes * kEventBytes, std::size_t{kMidiPacketBytes}});
  if (taken == 0) return std::nullopt;
  const auto end = packets_.begin() + static_cast<std::ptrdiff_t>(taken);
  UsbBytes data(packets_.begin(), end);
  packets_.erase(packets_.begin(), end);
  return data;
}

std::optional<Time> UsbMidi::next_due(Time now) const {
  return surface_.has_said() || !packets_.empty() ? std::optional(now) : std::nullopt;
}

void UsbMidi::PowerCycle() {
  surface_.PowerCycle();
  packets_.clear();
  message_.clear();
}

}  // namespace kaori::sim
