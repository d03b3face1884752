#include "appliance/core/showlog/change.h"

#include <algorithm>
#include <bit>

namespace kaori::showlog {
namespace {

// Words of one mask.
constexpr std::size_t kGroup = 8;
constexpr std::size_t kMostSkipped = 254;  // In one byte; 255 says that the count goes on.

// The sign goes to the lowest bit, so that a small step down is as short as one up.
std::uint32_t Folded(std::uint32_t difference) {
  return difference << 1U ^ (difference >> 31U != 0 ? ~0U : 0U);
}
std::uint32_t Unfolded(std::uint32_t folded) {
  return folded >> 1U ^ ((folded & 1U) != 0 ? ~0U : 0U);
}

// 1 to 4.
std::size_t BytesOf(std::uint32_t folded) {
  return std::max(1U, (static_cast<std::uint32_t>(std::bit_width(folded)) + 7) / 8);
}

// Writes mask, lengths and differences of one group of up to eight words; 0 bytes where nothing changed.
std::size_t WriteGroup(std::span<const std::uint32_t> before, std::span<const std::uint32_t> now,
                       std::uint8_t* into) {
  std::uint8_t mask = 0;
  std::size_t changed = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (now[i] != before[i]) {
      mask = static_cast<std::uint8_t>(mask | 1U << i);
      ++changed;
    }
  if (mask == 0) return 0;
  into[0] = mask;
  std::uint8_t* const lengths = into + 1;
  std::size_t at = 1 + (changed + 3) / 4;
  std::fill(lengths, into + at, std::uint8_t{0});
  std::size_t nth = 0;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if ((mask & 1U << i) == 0) continue;
    const std::uint32_t folded = Folded(now[i] - before[i]);
    const std::size_t bytes = BytesOf(folded);
    lengths[nth / 4] = static_cast<std::uint8_t>(lengths[nth / 4] | (bytes - 1) << (2 * (nth % 4)));
    for (std::size_t b = 0; b < bytes; ++b) into[at++] = static_cast<std::uint8_t>(folded >> (8 * b));
    ++nth;
  }
  return at;
}

// Gives the bytes behind the group; nothing where they end before it does.
// The last group may have fewer than eight words: bits for words that it has not are refused.
std::optional<std::size_t> ReadGroup(std::span<const std::uint8_t> from, std::span<std::uint32_t> words) {
  if (from.empty()) return std::nullopt;
  const std::uint8_t mask = from[0];
  const auto changed = static_cast<std::size_t>(std::popcount(mask));
  std::size_t at = 1 + (changed + 3) / 4;
  if (from.size() < at || mask >> words.size() != 0) return std::nullopt;
  std::size_t nth = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if ((mask & 1U << i) == 0) continue;
    const std::size_t bytes = (from[1 + nth / 4] >> (2 * (nth % 4)) & 3U) + 1U;
    if (from.size() < at + bytes) return std::nullopt;
    std::uint32_t folded = 0;
    for (std::size_t b = 0; b < bytes; ++b) folded |= std::uint32_t{from[at++]} << (8 * b);
    words[i] += Unfolded(folded);
    ++nth;
  }
  return at;
}

}  // namespace

// Groups at the end that did not change are not counted: the 0 stands for them.
std::size_t WriteChange(std::span<const std::uint32_t> before, std::span<const std::uint32_t> now,
                        std::span<std::uint8_t> into) {
  std::size_t at = 0, skipped = 0;
  for (std::size_t word = 0; word < now.size(); word += kGroup) {
    const std::size_t length = std::min(kGroup, now.size() - word);
    const auto old = before.subspan(word, length), fresh = now.subspan(word, length);
    if (std::ranges::equal(old, fresh)) {
      ++skipped;
      continue;
    }
    for (; skipped >= kMostSkipped; skipped -= kMostSkipped) into[at++] = 255;
    into[at++] = static_cast<std::uint8_t>(skipped + 1);
    skipped = 0;
    at += WriteGroup(old, fresh, into.data() + at);
  }
  into[at++] = 0;
  return at;
}

// `from` may hold anything: what it counts is compared with the words that there are before one is touched.
// Bytes that end without the 0 were torn.
std::optional<std::size_t> ReadChange(std::span<const std::uint8_t> from, std::span<std::uint32_t> words) {
  std::size_t at = 0, word = 0;
  while (at < from.size()) {
    const std::uint8_t count = from[at++];
    if (count == 0) return at;
    if (count == 255) {
      word += kMostSkipped * kGroup;
      continue;
    }
    word += (count - 1U) * kGroup;
    if (word >= words.size()) return std::nullopt;
    const std::size_t length = std::min(kGroup, words.size() - word);
    const auto bytes = ReadGroup(from.subspan(at), words.subspan(word, length));
    if (!bytes) return std::nullopt;
    at += *bytes;
    word += kGroup;
  }
  return std::nullopt;
}

}  // namespace kaori::showlog
