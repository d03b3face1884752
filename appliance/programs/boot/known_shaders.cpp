#include "appliance/programs/boot/known_shaders.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "drivers/base/read_file.h"
#include "drivers/base/unique_fd.h"

namespace kaori::boot {
namespace {

// A name is a SHA-1. The layout of the file is that of Mesa's src/util/disk_cache.c (CACHE_INDEX_MAX_KEYS,
// and CACHE_KEY_SIZE of 20): 8 bytes for the size of the cache, then the keys.
constexpr std::size_t kName_bytes = 20;
constexpr std::size_t kHead_bytes = 8;
constexpr std::size_t kPlaces = std::size_t{1} << 16U;

using Name = std::array<char, kName_bytes>;

// Nothing for a line that is not 40 hexadecimal digits.
std::optional<Name> ParseName(std::string_view digits) {
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

// Where Mesa looks for a name: its first 16 bits are its place, so that of two names with the same bits only
// one is known.
off_t OffsetOf(const Name& name) {
  const std::size_t place =
      static_cast<std::uint8_t>(name[0]) | std::size_t{static_cast<std::uint8_t>(name[1])} << 8U;
  return static_cast<off_t>(kHead_bytes + place * kName_bytes);
}

// Cuts the first line off a text, without its end.
std::string_view CutLine(std::string_view& text) {
  const auto end = std::min(text.find('\n'), text.size());
  const auto line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

// The list is ours, but a folder that leaves the root would be written to by process 1.
bool IsBelowRoot(std::string_view folder) {
  return !folder.empty() && folder.front() != '/' && folder.find("..") == std::string_view::npos;
}

}  // namespace

// Names are written where they belong and the file is then made as long as Mesa expects it; what lies in
// between reads as zeros, which are no name.
bool TellKnownShaders(const std::filesystem::path& list, const std::filesystem::path& root) {
  const auto text = ReadFile(list);
  if (!text) return text.error().cause == std::errc::no_such_file_or_directory;
  std::string_view rest = *text;
  const std::string_view folder = CutLine(rest);
  if (!IsBelowRoot(folder)) return false;
  std::error_code failed;
  std::filesystem::create_directories(root / folder, failed);
  const UniqueFd index(
      ::open((root / folder / "index").c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644));
  while (!rest.empty()) {
    const auto name = ParseName(CutLine(rest));
    if (!name || ::pwrite(index.get(), name->data(), name->size(), OffsetOf(*name)) != ssize_t{kName_bytes})
      return false;
  }
  return ::ftruncate(index.get(), kHead_bytes + kPlaces * kName_bytes) == 0;  // Holes take no memory.
}

}  // namespace kaori::boot
