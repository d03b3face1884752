#include "drivers/decode/report_items.h"

#include <array>
#include <string_view>

#include <fmt/format.h>

namespace kaori::decode {
namespace {

// HID 1.11, section 6.2.2.3: the prefix of a long item.
constexpr std::uint8_t kLongItem = 0xFE;
// A long item's head: prefix, data size, tag.
constexpr std::size_t kLongItemHead = 3;
constexpr std::array<std::uint8_t, 4> kShortItemBytes = {0, 1, 2, 4};  // By the two lowest bits.

// Items of 1, 2 and 4 bytes are little-endian two's complement where they are signed.
std::int32_t WidenSign(std::uint32_t value, std::uint8_t data_bytes) {
  if (data_bytes == 1) return static_cast<std::int8_t>(value);
  if (data_bytes == 2) return static_cast<std::int16_t>(value);
  return static_cast<std::int32_t>(value);
}

}  // namespace

tl::unexpected<Error> FailAt(std::size_t offset_bytes, std::string_view reason) {
  return FailInput(fmt::format("report descriptor, byte {}: {}", offset_bytes, reason));
}

// Nothing: the descriptor's end. Never reads beyond the span, whatever lengths the items claim.
Result<std::optional<Item>> ItemReader::Next() {
  // Long items are bounded by their own length, so the loop ends.
  while (at_ < descriptor_.size() && descriptor_[at_] == kLongItem) {
    if (auto ok = SkipLongItem(); !ok) return tl::unexpected(ok.error());
  }
  if (at_ >= descriptor_.size()) return std::nullopt;
  const std::uint8_t data_bytes = kShortItemBytes[descriptor_[at_] & 3u];
  // The prefix byte and its data must both be there.
  if (descriptor_.size() - at_ <= data_bytes) return FailAt(at_, "the descriptor ends inside an item");
  return ParseShortItem(data_bytes);
}

Result<void> ItemReader::SkipLongItem() {
  const std::size_t left = descriptor_.size() - at_;
  if (left < kLongItemHead || left < kLongItemHead + descriptor_[at_ + 1])
    return FailAt(at_, "the descriptor ends inside a long item");
  at_ += kLongItemHead + descriptor_[at_ + 1];
  return {};
}

// The caller has checked that all of the item's data are there.
Item ItemReader::ParseShortItem(std::uint8_t data_bytes) {
  const std::uint8_t prefix = descriptor_[at_];
  std::uint32_t value = 0;
  for (std::size_t n = data_bytes; n > 0; --n) value = (value << 8) | descriptor_[at_ + n];
  // HID 1.11, section 6.2.2.2: size in bits 0 and 1, type in bits 2 and 3, tag in bits 4 to 7.
  const Item item{.type = static_cast<ItemType>((prefix >> 2) & 3u),
                  .tag = static_cast<std::uint8_t>(prefix >> 4),
                  .data_bytes = data_bytes,
                  .unsigned_value = value,
                  .signed_value = WidenSign(value, data_bytes),
                  .offset_bytes = at_};
  at_ += 1u + data_bytes;
  return item;
}

}  // namespace kaori::decode
