#include "appliance/core/backup/ustar.h"

#include <algorithm>
#include <numeric>
#include <string_view>

#include <fmt/format.h>

namespace kaori::backup {
namespace {

// Fields, by offset and length, as the standard has them; numbers are octal digits and a zero byte.
struct Field {
  std::size_t at, bytes;
};
constexpr Field kName{0, 100}, kMode{100, 8}, kUser{108, 8}, kGroup{116, 8}, kSize{124, 12}, kTime{136, 12},
    kSumField{148, 8}, kType{156, 1}, kMagic{257, 8}, kPrefix{345, 155};
constexpr std::string_view kUstar(
    "ustar\0"
    "00",
    8);
constexpr char kRegular = '0';

void Put(Block& block, Field field, std::string_view text) {
  std::ranges::copy(text, block.begin() + static_cast<std::ptrdiff_t>(field.at));
}

void PutOctal(Block& block, Field field, std::uint64_t number) {
  Put(block, field, fmt::format("{:0{}o}", number, field.bytes - 1));
}

std::string_view Text(std::span<const std::uint8_t, kBlock_bytes> block, Field field) {
  return {reinterpret_cast<const char*>(block.data()) + field.at, field.bytes};
}

// The sum of all bytes, with blanks in place of the sum's own field.
std::uint32_t HeaderSum(std::span<const std::uint8_t, kBlock_bytes> block) {
  const auto own = block.subspan(kSumField.at, kSumField.bytes);
  const std::uint32_t all = std::accumulate(block.begin(), block.end(), std::uint32_t{0});
  return all - std::accumulate(own.begin(), own.end(), std::uint32_t{0}) +
         static_cast<std::uint32_t>(kSumField.bytes) * ' ';
}

// Octal digits up to a blank or a zero byte. Twelve of them fit by far.
std::optional<std::uint64_t> Octal(std::string_view text) {
  std::uint64_t number = 0;
  std::size_t digits = 0;
  for (; digits < text.size() && text[digits] >= '0' && text[digits] <= '7'; ++digits)
    number = number * 8 + static_cast<std::uint64_t>(text[digits] - '0');
  if (digits == 0 || (digits < text.size() && text[digits] != ' ' && text[digits] != '\0'))
    return std::nullopt;
  return number;
}

}  // namespace

// The sum is written with six digits, a zero byte and a blank, as tar(1) has always done it.
Block MakeBlock(const Member& member) {
  Block block{};
  Put(block, kName, std::string_view(member.path).substr(0, kName.bytes));
  PutOctal(block, kMode, 0644);
  PutOctal(block, kUser, 0);
  PutOctal(block, kGroup, 0);
  PutOctal(block, kSize, member.bytes);
  PutOctal(block, kTime, 0);
  Put(block, kType, std::string_view(&kRegular, 1));
  Put(block, kMagic, kUstar);
  Put(block, kSumField, fmt::format("{:06o}\0 ", HeaderSum(block)));
  return block;
}

// Links, folders, devices and extended headers are refused by their type: an archive of ours has none.
Result<std::optional<Member>> ReadBlock(std::span<const std::uint8_t, kBlock_bytes> block) {
  if (std::ranges::all_of(block, [](std::uint8_t byte) { return byte == 0; })) return std::nullopt;
  const auto sum = Octal(Text(block, kSumField)), bytes = Octal(Text(block, kSize));
  if (Text(block, kMagic) != kUstar || !sum || *sum != HeaderSum(block) || !bytes)
    return FailInput("has a damaged header");
  if (Text(block, kType).front() != kRegular || Text(block, kPrefix).front() != '\0')
    return FailInput("holds something that is no plain file");
  const std::string_view name = Text(block, kName);
  return Member{std::string(name.substr(0, name.find('\0'))), *bytes};
}

std::size_t Padding(std::uint64_t bytes) {
  return static_cast<std::size_t>((kBlock_bytes - bytes % kBlock_bytes) % kBlock_bytes);
}

}  // namespace kaori::backup
