#include "appliance/programs/boot/known_shaders.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <system_error>

namespace kaori::boot {
namespace {

constexpr std::size_t kName_bytes = 20;
constexpr std::size_t kHead_bytes = 8;
constexpr std::size_t kPlaces = std::size_t{1} << 16U;

using Name = std::array<char, kName_bytes>;

std::optional<Name> ParseName(const std::string& digits) {
  if (digits.size() != 2 * kName_bytes) return std::nullopt;
  Name name{};
  for (std::size_t i = 0; i < name.size(); ++i) {
    const char* from = digits.data() + 2 * i;
    std::uint8_t byte = 0;
    if (std::from_chars(from, from + 2, byte, 16).ptr != from + 2) return std::nullopt;
    name[i] = static_cast<char>(byte);
  }
  return name;
}

std::streamoff PlaceOf(const Name& name) {
  const std::size_t place =
      static_cast<std::uint8_t>(name[0]) | std::size_t{static_cast<std::uint8_t>(name[1])} << 8U;
  return static_cast<std::streamoff>(kHead_bytes + place * kName_bytes);
}

}  // namespace

bool TellKnownShaders(const std::filesystem::path& list, const std::filesystem::path& root) {
  std::error_code failed;
  if (!std::filesystem::exists(list, failed)) return !failed;
  std::ifstream lines(list);
  std::string line;
  // Below the root: a path that leads out of it is none.
  if (!std::getline(lines, line) || line.empty() || line.front() == '/' || line.find("..") != std::string::npos)
    return false;
  const std::filesystem::path folder = root / line;
  std::filesystem::create_directories(folder, failed);
  std::ofstream known(folder / "index", std::ios::binary);
  while (known && std::getline(lines, line)) {
    const auto name = ParseName(line);
    if (!name) return false;
    known.seekp(PlaceOf(*name)).write(name->data(), name->size());
  }
  known.close();
  std::filesystem::resize_file(folder / "index", kHead_bytes + kPlaces * kName_bytes, failed);
  return known.good() && !failed;
}

}  // namespace kaori::boot
