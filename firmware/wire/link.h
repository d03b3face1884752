// The local link: how a device plugged in on this machine by the simulator talks to the drivers.
//
// A link folder holds one Unix socket for each device, and the socket's file name is its port: "hid.<port>"
// (SOCK_SEQPACKET), "camera.<port>", "screen.<port>", "microphone.<port>", "loudspeaker.<port>"
// (SOCK_SEQPACKET as well; pixels lie in shared memory whose descriptor comes with the hello). The device
// listens and the driver connects; unplugging closes and unlinks. A newer driver connection replaces an older
// one. All numbers are little-endian; time is CLOCK_MONOTONIC in ns.
//
//   HID     device -> driver   hello: u32 'KHID', u16 vendor, u16 product, u16 name bytes, u16 descriptor
//   bytes,
//                              name, descriptor; then one packet for each input report: u64 time, report
//           driver -> device   one packet for each output report, as hidraw takes it (byte 0 is the report
//           id)
//   camera  device -> driver   hello: u32 'KCAM', u32 slots, u32 slot bytes, + descriptor of slots * slot
//   bytes;
//                              then for each frame: u64 time, u32 sequence, u32 slot, u32 width, u32 height,
//                              u32 stride bytes, u32 pixels (ports::PixelFormat), u32 bytes
//           driver -> device   u32 slot, when a slot is free again
//   screen  device -> driver   hello: u32 'KSCR', u32 slots, u32 width, u32 height, u64 period ns, +
//   descriptor
//                              of slots * width * height * 4 bytes; then for each flip: u64 time, u64 frame,
//                              u32 slot that was shown
//           driver -> device   u64 frame, u32 slot: show it at the next vertical blank
//   microphone
//           device -> driver   hello: u32 'KMIC', u32 rate Hz, u32 channels; then for each block: u64 time of
//           its
//                              first frame, u32 1 if frames were lost before it, samples of 16 bit
//   loudspeaker
//           device -> driver   hello: u32 'KSPK', u32 rate Hz, u32 channels, u32 frames that may wait; then
//           now and
//                              then: u64 time, u64 frames played by then, u32 how often it ran dry
//           driver -> device   samples of 16 bit, whole frames, to be played behind those that wait
#pragma once

#include <cstddef>
#include <cstdint>

namespace kaori::wire {

inline constexpr std::uint32_t kHidHello = 0x4449484B;          // "KHID"
inline constexpr std::uint32_t kCameraHello = 0x4D41434B;       // "KCAM"
inline constexpr std::uint32_t kScreenHello = 0x5243534B;       // "KSCR"
inline constexpr std::uint32_t kMicrophoneHello = 0x43494D4B;   // "KMIC"
inline constexpr std::uint32_t kLoudspeakerHello = 0x4B50534B;  // "KSPK"
inline constexpr std::size_t kMaxLinkPacket = 8192;

}  // namespace kaori::wire
