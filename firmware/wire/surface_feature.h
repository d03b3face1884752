// The one feature report of our control surfaces: who the device is, how it does, and how it is updated. 64
// bytes each way.
//
//   read (GET_REPORT)                               written (SET_REPORT)
//      0  u16    firmware version, major               0  u8     operation
//      2  u16    firmware version, minor               1  u8     its number: brightness 0..15, lamp test 0 or 1,
//      4  u32    serial number: the low half of               calibration 1 begins and 0 ends
//                the chip's id                         2  u16    bytes of data that count, 0..56
//      8  u16    counts in a turn of a dial            4  u32    where they belong in the image, in bytes
//     10  u8     hardware                              8  u8[56] data; with kBegin:
//     11  u8     state                                        8  u32     product: vendor id * 65536 + product id
//     12  u32    bytes of an update that were taken          12  u32     bytes of the image
//     16  u32    double steps since the power came           16  u32     version: major * 65536 + minor
//     20  u8[8]  the chip's id                               20  u8[32]  SHA-256 of the image
//     28  u8     the chip's stepping
//     29         0
//
// What the device refuses it answers with a STALL: an operation that it does not know, an image of another
// product, too long or too old, data out of order, a wrong hash. Numbers are little-endian. HID 1.11, 7.2.1
// and 7.2.2.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "firmware/wire/bytes.h"

namespace kaori::wire {

inline constexpr std::size_t kSurfaceFeatureBytes = 64;
inline constexpr std::size_t kSurfaceDataBytes = 56;
inline constexpr std::size_t kSha256Bytes = 32;

enum class SurfaceState : std::uint8_t {
  kPlays = 0,
  kUpdates = 1,  // An image is on its way.
  kTries = 2,    // It plays from an image that nobody has confirmed by kKeep yet.
  kReady = 3,    // A new image is whole; kRestart starts it.
  kRefuses = 4,  // Its chip is older than the firmware bears: it plays nothing, and takes no update.
};

// Which making of the chip it is. Of an RP2040, B2 is the first that connects to USB on a busy hub (RP2040-E5).
enum class ChipStepping : std::uint8_t {
  kUntold = 0,  // Firmware before this field, or a surface without a chip.
  kB0 = 1,
  kB1 = 2,
  kB2 = 3,  // Or a later one.
};

enum class SurfaceOperation : std::uint8_t {
  kLampTest = 1,    // All lamps are lit while its number is 1.
  kBrightness = 2,  // Of all lamps, 0..15.
  kCalibrate = 3,   // Move every axis from stop to stop between 1 and 0, beginning at rest.
  kBegin = 4,       // An update.
  kData = 5,
  kEnd = 6,
  kKeep = 7,     // This image is good: it stays the one that is started.
  kRestart = 8,  // As if the power had gone.
};

struct SurfaceStatus {
  // Two numbers, as in version 1.4.
  std::uint16_t firmware_major = 0;
  std::uint16_t firmware_minor = 0;
  std::uint32_t serial = 0;  // 0 where the chip told none.
  // 0 where it has no dials.
  std::uint16_t counts_per_turn = 0;
  std::uint8_t hardware = 0;  // Of the board: 1 is RP2040.
  SurfaceState state = SurfaceState::kPlays;
  std::uint32_t bytes_taken = 0;
  std::uint32_t double_steps = 0;
  std::array<std::uint8_t, 8> chip_id{};
  ChipStepping stepping = ChipStepping::kUntold;
};

// The report descriptor of a surface that refuses to play: the feature report alone, so that no driver takes it
// for a dial box or a stick.
// Drivers bind a device by its usages: a page of the vendor's own has none that they know.
inline constexpr auto kRefusalDescriptor = std::to_array<std::uint8_t>({
    0x06, 0x00, 0xFF,        // Usage page: vendor FF00
    0x09, 0x42,              // Usage: vendor 42, a surface that refuses
    0xA1, 0x01,              // Collection: Application
    0x09, 0x41,              //   Usage: vendor 41, the feature report
    0x15, 0x00,              //   Logical 0..
    0x26, 0xFF, 0x00,        //   255
    0x75, 0x08, 0x95, 0x40,  //   64 x 8 bits
    0xB1, 0x02,              //   Feature: data, variable, absolute
    0xC0,                    // End collection
});

// Answers GET_REPORT.
constexpr std::array<std::uint8_t, kSurfaceFeatureBytes> Encode(const SurfaceStatus& status) {
  std::array<std::uint8_t, kSurfaceFeatureBytes> bytes{};
  PutU16(bytes, 0, status.firmware_major);
  PutU16(bytes, 2, status.firmware_minor);
  PutU32(bytes, 4, status.serial);
  PutU16(bytes, 8, status.counts_per_turn);
  bytes[10] = status.hardware;
  bytes[11] = static_cast<std::uint8_t>(status.state);
  PutU32(bytes, 12, status.bytes_taken);
  PutU32(bytes, 16, status.double_steps);
  std::ranges::copy(status.chip_id, bytes.begin() + 20);
  bytes[28] = static_cast<std::uint8_t>(status.stepping);
  return bytes;
}

// A state that a newer firmware has is passed on as it is.
constexpr SurfaceStatus DecodeSurfaceStatus(std::span<const std::uint8_t, kSurfaceFeatureBytes> bytes) {
  SurfaceStatus status{.firmware_major = GetU16(bytes, 0),
                       .firmware_minor = GetU16(bytes, 2),
                       .serial = GetU32(bytes, 4),
                       .counts_per_turn = GetU16(bytes, 8),
                       .hardware = bytes[10],
                       .state = static_cast<SurfaceState>(bytes[11]),
                       .bytes_taken = GetU32(bytes, 12),
                       .double_steps = GetU32(bytes, 16)};
  std::ranges::copy(bytes.subspan<20, 8>(), status.chip_id.begin());
  status.stepping = static_cast<ChipStepping>(bytes[28]);
  return status;
}

struct SurfaceCommand {
  SurfaceOperation operation{};  // Of the table above, or one that nobody knows.
  std::uint8_t number = 0;
  std::uint16_t length = 0;  // Bytes of data that count; more than 56 is for the device to refuse.
  std::uint32_t offset = 0;
  std::array<std::uint8_t, kSurfaceDataBytes> data{};
};

constexpr std::array<std::uint8_t, kSurfaceFeatureBytes> Encode(const SurfaceCommand& command) {
  std::array<std::uint8_t, kSurfaceFeatureBytes> bytes{};
  bytes[0] = static_cast<std::uint8_t>(command.operation);
  bytes[1] = command.number;
  PutU16(bytes, 2, command.length);
  PutU32(bytes, 4, command.offset);
  std::ranges::copy(command.data, bytes.begin() + 8);
  return bytes;
}

constexpr SurfaceCommand DecodeSurfaceCommand(std::span<const std::uint8_t, kSurfaceFeatureBytes> bytes) {
  SurfaceCommand command{.operation = static_cast<SurfaceOperation>(bytes[0]),
                         .number = bytes[1],
                         .length = GetU16(bytes, 2),
                         .offset = GetU32(bytes, 4)};
  std::ranges::copy(bytes.subspan<8>(), command.data.begin());
  return command;
}

// What an image says of itself before it comes.
struct SurfaceImage {
  std::uint32_t product = 0;  // Vendor id * 65536 + product id.
  std::uint32_t length = 0;   // In bytes.
  std::uint32_t version = 0;  // Major * 65536 + minor.
  std::array<std::uint8_t, kSha256Bytes> sha256{};
  friend bool operator==(const SurfaceImage&, const SurfaceImage&) = default;
};
inline constexpr std::size_t kSurfaceImageBytes = 12 + kSha256Bytes;

// The data of kBegin.
constexpr std::array<std::uint8_t, kSurfaceImageBytes> Encode(const SurfaceImage& image) {
  std::array<std::uint8_t, kSurfaceImageBytes> bytes{};
  PutU32(bytes, 0, image.product);
  PutU32(bytes, 4, image.length);
  PutU32(bytes, 8, image.version);
  std::ranges::copy(image.sha256, bytes.begin() + 12);
  return bytes;
}

constexpr SurfaceImage DecodeSurfaceImage(std::span<const std::uint8_t, kSurfaceImageBytes> bytes) {
  SurfaceImage image{.product = GetU32(bytes, 0), .length = GetU32(bytes, 4), .version = GetU32(bytes, 8)};
  std::ranges::copy(bytes.subspan<12>(), image.sha256.begin());
  return image;
}

}  // namespace kaori::wire
