// The local link: how the simulator's devices on this machine talk to the drivers.
//
// A link folder holds one Unix socket (SOCK_SEQPACKET) for each device, named by its kind and its port:
// "hid.<port>", "camera.<port>", "screen.<port>", "microphone.<port>", "loudspeaker.<port>", "lines.<port>"; beside
// them the operators' monitor, which is a file (link_monitor.h).
// The device listens and the driver connects; to unplug the device closes and unlinks. A newer connection of
// a driver replaces an older one. The device greets first, with a hello whose first word names the kind.
// Pixels lie in shared memory, whose descriptor comes beside the hello. All numbers are little-endian; a time
// is CLOCK_MONOTONIC in ns (u64). The format is our own.
//
//   HID, device to driver
//     hello     0  u32 'KHID'   4  u16 vendor   6  u16 product   8  u16 bytes of the name   10  u16 bytes of the
//               descriptor   12  the name, then the report descriptor
//     report    0  u64 time     8  the input report
//   HID, driver to device
//     report    0  u8 report id (0: none)   1  the output report
//
//   camera, device to driver
//     hello     0  u32 'KCAM'   4  u32 slots    8  u32 bytes of a slot; beside it the memory of all slots
//     frame     0  u64 time     8  u32 sequence number   12  u32 slot   16  u32 width   20  u32 height
//               24  u32 bytes of a row   28  u32 ports::PixelFormat   32  u32 bytes of the frame
//   camera, driver to device
//     return    0  u32 slot that is free again
//
//   screen, device to driver
//     hello     0  u32 'KSCR'   4  u32 slots    8  u32 width   12  u32 height   16  u64 period in ns; beside it the
//               memory of all slots, each width * height * 4 bytes
//     flip      0  u64 time     8  u64 frame    16  u32 slot that is scanned out now
//   screen, driver to device
//     present   0  u64 frame    8  u32 slot to scan out at the next vertical blank
//
//   microphone, device to driver
//     hello     0  u32 'KMIC'   4  u32 rate in Hz   8  u32 channels
//     block     0  u64 time of its first frame   8  u32 1 where frames were lost before it   12  i16 samples
//
//   loudspeaker, device to driver
//     hello     0  u32 'KSPK'   4  u32 rate in Hz   8  u32 channels   12  u32 frames that may be queued
//     played    0  u64 time     8  u64 frames played by then   16  u32 how often the queue ran dry
//   loudspeaker, driver to device
//     block     0  i16 samples, whole frames, to be played behind those in the queue
//
//   lines, device to driver
//     hello     0  u32 'KLIN'   4  u32 input lines   8  u32 output lines   12  u32 active, bit n for input n
//     edge      0  u64 time     8  u32 input line    12  u32 1 active, 0 not
//   lines, driver to device
//     drive     0  u32 output line   4  u32 1 active, 0 not
#pragma once

#include <cstddef>
#include <cstdint>

namespace kaori::wire {

// The first words of a hello, in memory order "KHID" and so on: a driver that finds another
// device behind a socket's name hangs up rather than misread it.
inline constexpr std::uint32_t kHidHello = 0x4449484B;          // "KHID"
inline constexpr std::uint32_t kCameraHello = 0x4D41434B;       // "KCAM"
inline constexpr std::uint32_t kScreenHello = 0x5243534B;       // "KSCR"
inline constexpr std::uint32_t kMicrophoneHello = 0x43494D4B;   // "KMIC"
inline constexpr std::uint32_t kLoudspeakerHello = 0x4B50534B;  // "KSPK"
inline constexpr std::uint32_t kLinesHello = 0x4E494C4B;        // "KLIN"
// A longer packet is refused. It holds a hello with the longest report descriptor (4096
// bytes in Linux) and its name, and 40 ms of stereo sound at 48 kHz.
inline constexpr std::size_t kMaxLinkPacket = 8192;

}  // namespace kaori::wire
