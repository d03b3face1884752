#include "appliance/core/update/bundle.h"

#include <sodium.h>

#include <algorithm>
#include <string_view>

#include "drivers/base/utf8.h"

namespace kaori::update {
namespace {

constexpr std::string_view kMark = "KAUPD\r\n\x1A";
// Offsets, as bundle.h lists them.
constexpr std::size_t kFormAt = 8, kVersionAt = 12, kFromAt = 16, kProductAt = 20, kProduct_bytes = 28,
                      kLengthAt = 48, kChecksumAt = 56, kPartsAt = 88, kPart_bytes = 56, kNewsAt = 312,
                      kZerosAt = 408, kSignerAt = 416, kSignatureAt = 448;
static_assert(kSignatureAt + crypto_sign_BYTES == kHeader_bytes);
static_assert(kPartsAt + kParts * kPart_bytes == kNewsAt && kNewsAt + kLongestNews == kZerosAt);

using Bytes = std::span<const std::uint8_t>;

void PutNumber(std::uint64_t value, std::span<std::uint8_t> into) {
  for (std::uint8_t& byte : into) {
    byte = static_cast<std::uint8_t>(value);
    value >>= 8U;
  }
}

std::uint64_t NumberAt(Bytes bytes, std::size_t at, std::size_t length) {
  std::uint64_t value = 0;
  for (std::size_t i = length; i-- > 0;) value = value << 8U | bytes[at + i];
  return value;
}

std::uint32_t WordAt(Bytes bytes, std::size_t at) {
  return static_cast<std::uint32_t>(NumberAt(bytes, at, 4));
}

void PutText(std::string_view text, std::span<std::uint8_t> into) {
  std::ranges::copy(text.substr(0, into.size()), into.begin());
}

// Up to the first zero, as it can be shown and logged. No letter takes fewer bytes than columns, so that nothing is cut.
std::string TextAt(Bytes bytes, std::size_t at, std::size_t length) {
  const Bytes field = bytes.subspan(at, length);
  return utf8::Printable(std::string(field.begin(), std::ranges::find(field, 0)), length);
}

// The beginning of a text that has at most so many bytes and ends behind a letter.
std::string_view WholeLetters(std::string_view text, std::size_t most_bytes) {
  std::size_t end = 0;
  while (end < text.size()) {
    const std::size_t next = end + utf8::FirstLetter(text.substr(end)).bytes;
    if (next > most_bytes) break;
    end = next;
  }
  return text.substr(0, end);
}

// Each length is bounded before it is added to others, so that a forged one cannot overflow.
Result<void> CheckLengths(const Manifest& manifest, std::uint64_t file_bytes) {
  std::uint64_t packed = 0;
  for (const PackedPart& part : manifest.parts) {
    if (part.bytes > kLargestPart_bytes || part.packed_bytes > kLargestPart_bytes || part.bytes == 0)
      return FailInput("is damaged: a part of it has no such length");
    packed += part.packed_bytes;
  }
  if (packed != manifest.payload_bytes) return FailInput("is damaged: its parts are not its whole");
  if (packed + kHeader_bytes == file_bytes) return {};
  return FailInput("is no whole update: it should have " + std::to_string(packed + kHeader_bytes) +
                       " bytes and has " + std::to_string(file_bytes),
                   std::errc::message_size);
}

Result<void> CheckMark(Bytes bytes) {
  const bool begins = bytes.size() >= kMark.size() &&
                      std::ranges::equal(bytes.first(kMark.size()), kMark, [](std::uint8_t a, char b) {
                        return a == static_cast<std::uint8_t>(b);
                      });
  if (!begins) return FailInput("is no update", std::errc::executable_format_error);
  if (bytes.size() < kHeader_bytes)
    return FailInput("is no whole update: it ends in its header", std::errc::message_size);
  const std::uint32_t form = WordAt(bytes, kFormAt);
  if (form > kForm)
    return FailInput(
        "is an update of form " + std::to_string(form) + "; this box reads form " + std::to_string(kForm),
        std::errc::function_not_supported);
  return form == kForm ? Result<void>{} : FailInput("is damaged: its header is not sound");
}

PackedPart PartAt(Bytes bytes) {
  PackedPart part{.packed_bytes = NumberAt(bytes, 0, 8), .bytes = NumberAt(bytes, 8, 8)};
  std::ranges::copy(bytes.subspan(24, part.checksum.size()), part.checksum.begin());
  return part;
}

}  // namespace

std::uint64_t Manifest::PackedAt(Part which) const {
  std::uint64_t at = 0;
  for (std::size_t n = 0; n < static_cast<std::size_t>(which); ++n) at += parts[n].packed_bytes;
  return at;
}

// The signature covers all that stands before it, and by the checksum the payload. The mark is signed too: what
// was signed as a show is no update.
Header MakeHeader(const Manifest& manifest, const show::SecretKey& signer) {
  Header header{};
  const std::span<std::uint8_t> at(header);
  PutText(kMark, at.first(kMark.size()));
  PutNumber(kForm, at.subspan(kFormAt, 4));
  PutNumber(manifest.version, at.subspan(kVersionAt, 4));
  PutNumber(manifest.from, at.subspan(kFromAt, 4));
  PutText(manifest.product, at.subspan(kProductAt, kProduct_bytes));
  PutNumber(manifest.payload_bytes, at.subspan(kLengthAt, 8));
  std::ranges::copy(manifest.payload, at.subspan(kChecksumAt).begin());
  for (std::size_t n = 0; n < kParts; ++n) {
    const auto part = at.subspan(kPartsAt + n * kPart_bytes, kPart_bytes);
    PutNumber(manifest.parts[n].packed_bytes, part.first(8));
    PutNumber(manifest.parts[n].bytes, part.subspan(8, 8));
    std::ranges::copy(manifest.parts[n].checksum, part.subspan(24).begin());
  }
  PutText(WholeLetters(manifest.news, kLongestNews), at.subspan(kNewsAt, kLongestNews));
  std::ranges::copy(signer.public_key().bytes, at.subspan(kSignerAt).begin());
  crypto_sign_detached(header.data() + kSignatureAt, nullptr, header.data(), kSignatureAt,
                       signer.bytes().data());
  return header;
}

// The signature first: nothing that it does not cover is read, but for the mark.
Result<Manifest> ReadHeader(Bytes bytes, std::uint64_t file_bytes) {
  if (auto ok = CheckMark(bytes); !ok) return tl::unexpected(ok.error());
  Manifest manifest;
  std::ranges::copy(bytes.subspan(kSignerAt, manifest.signer.bytes.size()), manifest.signer.bytes.begin());
  if (crypto_sign_verify_detached(bytes.data() + kSignatureAt, bytes.data(), kSignatureAt,
                                  manifest.signer.bytes.data()) != 0)
    return FailInput("is wrongly signed: its signature does not fit");
  manifest.version = WordAt(bytes, kVersionAt);
  manifest.from = WordAt(bytes, kFromAt);
  manifest.product = TextAt(bytes, kProductAt, kProduct_bytes);
  manifest.news = TextAt(bytes, kNewsAt, kLongestNews);
  manifest.payload_bytes = NumberAt(bytes, kLengthAt, 8);
  std::ranges::copy(bytes.subspan(kChecksumAt, manifest.payload.size()), manifest.payload.begin());
  for (std::size_t n = 0; n < kParts; ++n)
    manifest.parts[n] = PartAt(bytes.subspan(kPartsAt + n * kPart_bytes, kPart_bytes));
  if (auto ok = CheckLengths(manifest, file_bytes); !ok) return tl::unexpected(ok.error());
  return manifest;
}

}  // namespace kaori::update
