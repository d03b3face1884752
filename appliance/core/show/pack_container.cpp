#include "appliance/core/show/pack_container.h"

#include <sodium.h>

#include <algorithm>
#include <cstring>
#include <string_view>

namespace kaori::show {
namespace {

// The last three bytes are as in PNG's signature (RFC 2083, 12.11): a transfer that rewrites line ends breaks
// the first two, and the third ends a file that is typed on a DOS screen.
constexpr std::string_view kMark = "KAORI\r\n\x1A";
// FlatBuffers' identifier, at byte 4 of a content. Version 1 had no header, so that it stood at byte 4 of the
// file.
constexpr std::string_view kContentMark = "KAOR";
// Offsets into the header, as pack_container.h lists them.
constexpr std::size_t kVersionAt = 8;
constexpr std::size_t kSignedAt = 12;
constexpr std::size_t kLengthAt = 16;
constexpr std::size_t kChecksumAt = 24;
constexpr std::size_t kSignerAt = 56;
constexpr std::size_t kSignatureAt = 88;
constexpr std::size_t kZerosAt = 152;
static_assert(kSignatureAt + crypto_sign_BYTES == kZerosAt);
// pack_container.h holds libsodium's state as bytes, so that it need not include sodium.h.
static_assert(sizeof(crypto_generichash_state) == 384);

using Bytes = std::span<const std::uint8_t>;

// Little-endian, as many bytes as `into` has; NumberAt is the inverse.
void PutNumber(std::uint64_t value, std::span<std::uint8_t> into) {
  for (std::uint8_t& byte : into) {
    byte = static_cast<std::uint8_t>(value);
    value >>= 8U;
  }
}

std::uint64_t NumberAt(Bytes bytes) {
  std::uint64_t value = 0;
  for (std::size_t i = bytes.size(); i-- > 0;) value = (value << 8U) | bytes[i];
  return value;
}

bool Begins(Bytes bytes, std::string_view mark) {
  return bytes.size() >= mark.size() && std::memcmp(bytes.data(), mark.data(), mark.size()) == 0;
}

bool AllZero(Bytes bytes) {
  return std::ranges::all_of(bytes, [](std::uint8_t b) { return b == 0; });
}

// The order goes from the most useful message to the least: a pack of an old version is told apart from a
// file that is none, and a file that ends early from one of another version.
Result<void> CheckMark(Bytes bytes) {
  if (bytes.size() >= 8 && Begins(bytes.subspan(4), kContentMark))
    return FailInput("is a show pack of version 1; this box plays version 2: pack it again", kOlderPack);
  if (!Begins(bytes, kMark)) return FailInput("is no show pack", kNoPack);
  if (bytes.size() < kPackHeader_bytes)
    return FailInput("is no whole show pack: it ends in its header", kCutOffPack);
  const std::uint64_t version = NumberAt(bytes.subspan(kVersionAt, 4));
  if (version == kPackVersion) return {};
  return FailInput("is a show pack of version " + std::to_string(version) + "; this box plays version " +
                       std::to_string(kPackVersion),
                   version > kPackVersion ? kNewerPack : kOlderPack);
}

// Both lengths are bounded before they are added up, so that a forged one cannot overflow.
Result<void> CheckLength(std::uint64_t content_bytes, std::uint64_t file_bytes) {
  if (file_bytes > kLargestPack_bytes || content_bytes > kLargestPack_bytes)
    return FailInput("is larger than " + std::to_string(kLargestPack_bytes >> 20U) + " MB, and no show is",
                     std::errc::file_too_large);
  if (content_bytes + kPackHeader_bytes == file_bytes) return {};
  return FailInput("is no whole show pack: it should have " +
                       std::to_string(content_bytes + kPackHeader_bytes) + " bytes and has " +
                       std::to_string(file_bytes),
                   kCutOffPack);
}

// A signature that is there must be good, asked for or not: a wrong one is damage. An unsigned header has
// zeros where a signature would be, so that every header has one form only and no byte of it can be changed
// unseen. Whether the signer is one to be trusted is for the caller to say.
Result<std::optional<PublicKey>> ReadSigner(Bytes header) {
  const std::uint64_t is_signed = NumberAt(header.subspan(kSignedAt, 4));
  if (is_signed > 1 || !AllZero(header.subspan(kZerosAt)))
    return FailInput("is damaged: its header is not sound");
  if (is_signed == 0) {
    if (AllZero(header.subspan(kSignerAt, kZerosAt - kSignerAt))) return std::optional<PublicKey>();
    return FailInput("is damaged: its header is not sound");
  }
  PublicKey signer;
  std::ranges::copy(header.subspan(kSignerAt, signer.bytes.size()), signer.bytes.begin());
  if (crypto_sign_verify_detached(header.data() + kSignatureAt, header.data(), kSignatureAt,
                                  signer.bytes.data()) != 0)
    return FailInput("is wrongly signed: its signature does not fit");
  return std::optional(signer);
}

}  // namespace

// The signature covers version, length, checksum and signer (bytes 0 to 87), and by the checksum the content.
PackHeader MakeHeader(Bytes content, const SecretKey* signer) {
  PackHeader header{};
  const std::span<std::uint8_t> at(header);
  std::ranges::copy(kMark, header.begin());
  PutNumber(kPackVersion, at.subspan(kVersionAt, 4));
  PutNumber(signer != nullptr ? 1 : 0, at.subspan(kSignedAt, 4));
  PutNumber(content.size(), at.subspan(kLengthAt, 8));
  Checksummer sum;
  sum.Add(content);
  std::ranges::copy(sum.Finish(), at.subspan(kChecksumAt).begin());
  if (signer == nullptr) return header;
  std::ranges::copy(signer->public_key().bytes, at.subspan(kSignerAt).begin());
  crypto_sign_detached(header.data() + kSignatureAt, nullptr, header.data(), kSignatureAt,
                       signer->bytes().data());
  return header;
}

// CheckMark lets only bytes through that have a whole header, so that all fields behind it can be read.
Result<PackSeal> ReadHeader(Bytes bytes, std::uint64_t file_bytes) {
  if (auto ok = CheckMark(bytes); !ok) return tl::unexpected(ok.error());
  PackSeal seal;
  seal.content_bytes = NumberAt(bytes.subspan(kLengthAt, 8));
  if (auto ok = CheckLength(seal.content_bytes, file_bytes); !ok) return tl::unexpected(ok.error());
  auto signer = ReadSigner(bytes.first(kPackHeader_bytes));
  if (!signer) return tl::unexpected(signer.error());
  seal.signer = *signer;
  std::ranges::copy(bytes.subspan(kChecksumAt, seal.checksum.size()), seal.checksum.begin());
  return seal;
}

Checksummer::Checksummer() {
  static const int fastest = sodium_init();  // Finds the fastest code for this machine.
  (void)fastest;
  crypto_generichash_init(reinterpret_cast<crypto_generichash_state*>(state_.data()), nullptr, 0,
                          sizeof(Checksum));
}

void Checksummer::Add(Bytes bytes) {
  crypto_generichash_update(reinterpret_cast<crypto_generichash_state*>(state_.data()), bytes.data(),
                            bytes.size());
}

Checksum Checksummer::Finish() {
  Checksum sum{};
  crypto_generichash_final(reinterpret_cast<crypto_generichash_state*>(state_.data()), sum.data(),
                           sum.size());
  return sum;
}

}  // namespace kaori::show
