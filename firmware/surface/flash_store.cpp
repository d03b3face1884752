#include "firmware/surface/flash_store.h"

#include <algorithm>
#include <array>

#include "firmware/surface/sha256.h"
#include "firmware/wire/bytes.h"

namespace kaori::surface {
namespace {

constexpr std::uint32_t kStoreMagic = 0x3154534B;  // "KST1"
// As flash_store.h draws a copy: magic, generation and length before the bytes, the check behind them.
constexpr std::size_t kHeadBytes = 10;
constexpr std::size_t kTailBytes = 4;
static_assert(kHeadBytes + kMostStoredBytes + kTailBytes <= kPageBytes);

struct Copy {
  std::uint32_t generation;
  std::span<const std::uint8_t> bytes;
};

std::uint32_t CopyAt(std::uint32_t number) {
  return kStoreAt + number * kSectorBytes;
}

// A copy whose check fails was cut off while it was written, and is none. The length is looked at first: it
// says how far the check reaches.
std::optional<Copy> ReadCopy(const Flash& flash, std::uint32_t number) {
  const auto page = flash.Read(CopyAt(number), kPageBytes);
  const std::size_t length = wire::GetU16(page, 8);
  if (wire::GetU32(page, 0) != kStoreMagic || length > kMostStoredBytes) return std::nullopt;
  const Sha256Digest check = Sha256Of(page.first(kHeadBytes + length));
  if (!std::ranges::equal(page.subspan(kHeadBytes + length, kTailBytes), std::span(check).first(kTailBytes)))
    return std::nullopt;
  return Copy{wire::GetU32(page, 4), page.subspan(kHeadBytes, length)};
}

// The number of the newer copy; 0 where there is none.
std::uint32_t Newer(const std::optional<Copy>& first, const std::optional<Copy>& second) {
  if (!second) return 0;
  return !first || static_cast<std::int32_t>(second->generation - first->generation) > 0 ? 1 : 0;
}

}  // namespace

// Both copies are read and checked at each call; it is called when the power comes, and not while reports are
// made.
std::optional<std::span<const std::uint8_t>> Load(const Flash& flash) {
  const auto first = ReadCopy(flash, 0);
  const auto second = ReadCopy(flash, 1);
  const auto& newer = Newer(first, second) == 0 ? first : second;
  if (!newer) return std::nullopt;
  return newer->bytes;
}

// The same bytes again wear no flash. Generations are compared by their distance, so that they may wrap.
void Store(Flash& flash, std::span<const std::uint8_t> bytes) {
  bytes = bytes.first(std::min(bytes.size(), kMostStoredBytes));
  const auto first = ReadCopy(flash, 0);
  const auto second = ReadCopy(flash, 1);
  const std::uint32_t newer = Newer(first, second);
  const auto& last = newer == 0 ? first : second;
  if (last && std::ranges::equal(last->bytes, bytes)) return;

  std::array<std::uint8_t, kPageBytes> page{};
  wire::PutU32(page, 0, kStoreMagic);
  wire::PutU32(page, 4, last ? last->generation + 1 : 1);
  wire::PutU16(page, 8, static_cast<std::uint16_t>(bytes.size()));
  std::ranges::copy(bytes, page.begin() + kHeadBytes);
  const std::size_t checked = kHeadBytes + bytes.size();
  const Sha256Digest check = Sha256Of(std::span(page).first(checked));
  std::copy_n(check.begin(), kTailBytes, page.begin() + static_cast<std::ptrdiff_t>(checked));
  const std::uint32_t target = CopyAt(last ? 1 - newer : 0);
  flash.Erase(target);
  flash.Program(target, std::span(page).first(checked + kTailBytes));
}

}  // namespace kaori::surface
