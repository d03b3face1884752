// An update's file, NAME.kaoriupdate: a signed header, and behind it the packed parts of a system.
//
// The header, little-endian, 512 bytes:
//     0    8  mark "KAUPD\r\n\x1A": a transfer that rewrites line ends breaks it
//     8    4  form of this file, kForm
//    12    4  version of the system in it
//    16    4  the lowest version from which a box may come to it in one step
//    20   28  product, kProduct, filled up with zeros
//    48    8  length of the payload, which is the rest of the file
//    56   32  BLAKE2b-256 of the payload
//    88  224  four parts of 56 bytes each: root, verity, kernel of slot A, kernel of slot B
//             (packed bytes, bytes: 8 each; 8 zeros; BLAKE2b-256 of the unpacked part)
//   312   96  what is new, one line of ASCII, filled up with zeros
//   408    8  zeros
//   416   32  the signer's public key
//   448   64  Ed25519 of bytes 0 to 447
// The parts lie in the payload one behind the other, in this order, each one frame of zstd (RFC 8878).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "appliance/core/show/pack_container.h"
#include "appliance/core/show/pack_key.h"
#include "drivers/base/result.h"

namespace kaori::update {

inline constexpr std::size_t kHeader_bytes = 512;
using Header = std::array<std::uint8_t, kHeader_bytes>;

// Raised when older boxes could not read a bundle any more.
inline constexpr std::uint32_t kForm = 1;
// The last number is that of the disk's layout: a bundle for another layout does not fit.
inline constexpr std::string_view kProduct = "kaori-box-amd64-1";
inline constexpr std::size_t kLongestNews = 96;
// No part of a disk is larger than this; a forged length ends here.
inline constexpr std::uint64_t kLargestPart_bytes = std::uint64_t{1} << 30U;

// What a system is made of, in the payload's order.
enum class Part : std::uint8_t { kRoot, kVerity, kKernelA, kKernelB };
inline constexpr std::size_t kParts = 4;

// One part as it lies in the payload.
struct PackedPart {
  std::uint64_t packed_bytes = 0;
  // Unpacked, and its checksum.
  std::uint64_t bytes = 0;
  show::Checksum checksum{};
};

// What a header says.
struct Manifest {
  std::uint32_t version = 0;
  // The lowest version from which a box may come: of older ones it cannot read what they kept.
  std::uint32_t from = 0;
  std::string product{kProduct};
  // For people; printable ASCII.
  std::string news{};
  std::uint64_t payload_bytes = 0;
  show::Checksum payload{};
  std::array<PackedPart, kParts> parts{};
  // Its signature is good; whether it is trusted is for the caller to say.
  show::PublicKey signer{};

  const PackedPart& part(Part which) const { return parts[static_cast<std::size_t>(which)]; }
  // Where a part begins in the payload.
  std::uint64_t PackedAt(Part which) const;
};

// Signs the header of a manifest; its signer is the key's. What is new is cut to kLongestNews, behind a letter.
Header MakeHeader(const Manifest& manifest, const show::SecretKey& signer);

// Reads a header of a file of `file_bytes`. `bytes` may be shorter than a header, and anything. Errors, whose
// words follow on a file's name:
//   executable_format_error  another kind of file
//   function_not_supported   of a newer form than this program's
//   message_size             it ends too early, or goes on behind its end
//   invalid_argument         wrongly signed, or not as MakeHeader writes it
// The payload is not looked at. Pure.
Result<Manifest> ReadHeader(std::span<const std::uint8_t> bytes, std::uint64_t file_bytes);

}  // namespace kaori::update
