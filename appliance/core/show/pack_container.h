// What stands before a pack's content: mark, version, length, checksum and, where it is signed, the
// signature.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "appliance/core/show/pack_key.h"
#include "drivers/base/result.h"

namespace kaori::show {

// Raised when older programs could not read a pack any more. Fields that FlatBuffers adds at the end of a
// table need no new version: they read as their default.
inline constexpr std::uint32_t kPackVersion = 2;

// Packs are read whole into memory; a show of 100 000 triangles and 16 faces takes less than 0.2 GB.
inline constexpr std::uint64_t kLargestPack_bytes = std::uint64_t{1} << 30U;

// The header, little-endian:
//     0   8  mark "KAORI\r\n\x1A": a transfer that rewrites line ends breaks it
//     8   4  version
//    12   4  1: signed; 0: not
//    16   8  length of the content, which is the rest of the file
//    24  32  BLAKE2b-256 of the content
//    56  32  the signer's public key     zeros where it is not signed
//    88  64  Ed25519 of bytes 0 to 87    zeros where it is not signed
//   152  40  zeros
// Its length keeps the content aligned for everything that lies in it.
inline constexpr std::size_t kPackHeader_bytes = 192;
using PackHeader = std::array<std::uint8_t, kPackHeader_bytes>;
using Checksum = std::array<std::uint8_t, 32>;

// What a sound header says.
struct PackSeal {
  std::uint64_t content_bytes = 0;
  Checksum checksum{};
  std::optional<PublicKey> signer;  // Its signature is good.
};

// The causes by which a program tells refused packs apart; people read the words.
inline constexpr std::errc kNoPack = std::errc::executable_format_error;  // Another kind of file.
inline constexpr std::errc kNewerPack =
    std::errc::function_not_supported;  // Of a version that is newer than this program's,
inline constexpr std::errc kOlderPack = std::errc::not_supported;  // or older.
inline constexpr std::errc kCutOffPack = std::errc::message_size;  // It ends too early or goes on too long.
inline constexpr std::errc kUnsignedPack = std::errc::operation_not_permitted;
inline constexpr std::errc kForeignPack =
    std::errc::permission_denied;  // Signed, by a key that is not trusted.

// Makes the header of a content, signed where `signer` is not null; both are borrowed for the call. Reads all of the
// content once, for its checksum: about a millisecond for each megabyte. The same content and key give the same bytes.
// Any thread.
PackHeader MakeHeader(std::span<const std::uint8_t> content, const SecretKey* signer);

// Reads a header of a file of `file_bytes`. `bytes` may be shorter than a header, and anything. Errors:
//   kNoPack, kNewerPack, kOlderPack, kCutOffPack   as above
//   file_too_large    more than kLargestPack_bytes
//   invalid_argument  wrongly signed, or not as MakeHeader writes it
// The words follow on a file's name: "is no show pack".
// The content is not looked at: its checksum is for the caller to compare. Pure.
Result<PackSeal> ReadHeader(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes);

// Adds up a checksum (BLAKE2b-256, RFC 7693) piece by piece, in any cut of the pieces. A copy goes on by itself from
// what was added so far. One thread; allocates nothing; never fails.
class Checksummer {
 public:
  Checksummer();
  // The next bytes, borrowed for the call.
  void Add(std::span<const std::uint8_t> bytes);
  // Of all that was added. To be called once: afterwards it is used up, and a new one is assigned for another sum.
  Checksum Finish();

 private:
  alignas(64) std::array<std::uint8_t, 384> state_;  // libsodium's, opaque.
};

}  // namespace kaori::show
