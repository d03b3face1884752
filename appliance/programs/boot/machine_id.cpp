#include "appliance/programs/boot/machine_id.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <string_view>

#include "drivers/base/checksum.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::boot {
namespace {

constexpr std::size_t kIdDigits = 32;
constexpr std::size_t kMarkDigits = 16;
constexpr unsigned kIdMode = 0444;
constexpr std::string_view kIdLetters = "0123456789abcdef";

bool AreDigits(std::string_view text) {
  return std::ranges::all_of(text, [](char c) { return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f'); });
}

bool IsMark(std::string_view text) {
  return text.size() == kMarkDigits && AreDigits(text);
}

// systemd refuses a number that is all zero, and takes none with capital letters.
bool IsMachineId(std::string_view text) {
  const auto is_zero = [](char c) { return c == '0'; };
  return text.size() == kIdDigits && AreDigits(text) && !std::ranges::all_of(text, is_zero);
}

// A file of one line, without its end; empty where it is missing.
std::string LineOf(const std::filesystem::path& file, std::size_t most_bytes) {
  std::string line = ReadFile(file, {.most_bytes = most_bytes}).value_or("");
  if (!line.empty() && line.back() == '\n') line.pop_back();
  return line;
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

// One number alone: a firmware's update that fills in another one makes no other PC.
std::string MachineMark(const std::filesystem::path& sys) {
  constexpr std::size_t kMost_bytes = 4096;
  for (const char* const name : {"class/dmi/id/product_uuid", "firmware/devicetree/base/serial-number",
                                 "class/dmi/id/board_serial", "class/dmi/id/product_serial"}) {
    const std::string number = LineOf(sys / name, kMost_bytes);
    if (number.empty()) continue;
    const std::uint64_t sum = Fnv1a(number, Fnv1a(name));
    std::string digits;
    for (int bit = 60; bit >= 0; bit -= 4) digits += kIdLetters[sum >> static_cast<unsigned>(bit) & 0x0FU];
    return digits;
  }
  return {};
}

// The mark comes last: a start that is cut off between the two makes a new number once more.
Result<std::string> KeptMachineId(const std::filesystem::path& file, const std::string& machine) {
  const std::filesystem::path marks = file.string() + ".pc";
  Result<std::string> number = LineOf(file, kIdDigits + 1);
  const std::string mark = LineOf(marks, kMarkDigits + 1);
  const bool is_copied = IsMark(mark) && !machine.empty() && mark != machine;
  if (!IsMachineId(*number) || is_copied) {
    number = NewMachineId();
    if (!number) return number;
    if (auto ok = WriteWholeFile(file, {AsBytes(*number + "\n")}, kIdMode); !ok)
      return tl::unexpected(ok.error());
  }
  // A full disk costs nobody the number that is there.
  if (!machine.empty() && mark != machine)
    static_cast<void>(WriteWholeFile(marks, {AsBytes(machine + "\n")}, kIdMode));
  return number;
}

std::string NameOfBox(const std::string& wanted, const std::string& machine_id) {
  constexpr std::size_t kShownDigits = 8;
  if (!wanted.empty()) return wanted;
  return machine_id.empty() ? "kaori" : "kaori-" + machine_id.substr(0, kShownDigits);
}

}  // namespace kaori::boot
