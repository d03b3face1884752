#include "appliance/programs/boot/machine_id.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <string_view>

#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::boot {
namespace {

constexpr std::size_t kIdDigits = 32;
constexpr unsigned kIdMode = 0444;
constexpr std::string_view kIdLetters = "0123456789abcdef";

// systemd refuses a number that is all zero, and takes none with capital letters.
bool IsMachineId(std::string_view text) {
  const auto is_digit = [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); };
  const auto is_zero = [](char c) { return c == '0'; };
  return text.size() == kIdDigits && std::ranges::all_of(text, is_digit) &&
         !std::ranges::all_of(text, is_zero);
}

// A random UUID of version 4 (RFC 4122, 4.4), which is what machine-id(5) asks for.
Result<std::string> NewMachineId() {
  std::array<std::uint8_t, kIdDigits / 2> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), GRND_INSECURE) != static_cast<ssize_t>(bytes.size()))
    return Fail(static_cast<std::errc>(errno), "ask the kernel for a random number");
  bytes[6] = static_cast<std::uint8_t>((bytes[6] & 0x0FU) | 0x40U);
  bytes[8] = static_cast<std::uint8_t>((bytes[8] & 0x3FU) | 0x80U);
  std::string text;
  for (const std::uint8_t byte : bytes) {
    text += kIdLetters[byte >> 4U];
    text += kIdLetters[byte & 0x0FU];
  }
  return text;
}

}  // namespace

Result<std::string> KeptMachineId(const std::filesystem::path& file) {
  std::string kept = ReadFile(file, {.most_bytes = kIdDigits + 1}).value_or("");
  if (!kept.empty() && kept.back() == '\n') kept.pop_back();
  if (IsMachineId(kept)) return kept;
  auto made = NewMachineId();
  if (!made) return made;
  if (auto ok = WriteWholeFile(file, {AsBytes(*made + "\n")}, kIdMode); !ok)
    return tl::unexpected(ok.error());
  return made;
}

std::string NameOfBox(const std::string& wanted, const std::string& machine_id) {
  constexpr std::size_t kShownDigits = 8;
  if (!wanted.empty()) return wanted;
  return machine_id.empty() ? "kaori" : "kaori-" + machine_id.substr(0, kShownDigits);
}

}  // namespace kaori::boot
