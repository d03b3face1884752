#include "appliance/programs/shows/stick.h"

#include <algorithm>
#include <string_view>

#include "drivers/base/utf8.h"

namespace kaori::shows {
namespace {

namespace fs = std::filesystem;

// Columns: a longer name is cut, so that a line of the list holds it with its number and its remark.
constexpr std::size_t kLongestName = 40;
constexpr std::size_t kMostLookedAt =
    4096;  // Entries of the folder; a damaged one may seem to have any number.

// FAT keeps capitals or not, as whoever wrote the name did.
// The extension is given with its point and in small letters.
bool EndsIn(const fs::path& file, std::string_view extension) {
  std::string end = file.extension().string();
  for (char& c : end)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return end == extension;
}

// One pass, without opening any of the files: kinds and lengths are those of the folder's entries. A file
// whose length cannot be read is listed with none, and refused when it is taken.
Result<std::vector<Offer>> List(const fs::path& stick, std::string_view extension) {
  std::error_code error;
  std::vector<Offer> offers;
  std::size_t seen = 0;
  for (fs::directory_iterator it(stick, error), end; !error && it != end && seen < kMostLookedAt;
       it.increment(error), ++seen) {
    const fs::path& file = it->path();
    std::error_code odd;
    if (!EndsIn(file, extension) || file.filename().string().starts_with('.')) continue;
    if (!fs::is_regular_file(it->symlink_status(odd))) continue;
    const std::uint64_t bytes = it->file_size(odd);
    offers.push_back({.file = file,
                      .name = utf8::Printable(file.stem().string(), kLongestName),
                      .bytes = odd ? 0 : bytes});
  }
  if (error) return Fail(static_cast<std::errc>(error.value()), "read the stick " + stick.string());
  // The order of a folder on FAT is that of writing, which means nothing to whoever chooses.
  std::ranges::sort(offers, {}, &Offer::name);
  return offers;
}

}  // namespace

Result<std::vector<Offer>> ListShows(const fs::path& stick) {
  return List(stick, ".kaori");
}

Result<std::vector<Offer>> ListUpdates(const fs::path& stick) {
  return List(stick, ".kaoriupdate");
}

Result<std::vector<Offer>> ListKeys(const fs::path& stick) {
  return List(stick, ".pub");
}

Result<std::vector<Offer>> ListSettings(const fs::path& stick) {
  return List(stick, ".toml");
}

Result<std::vector<Offer>> ListBackups(const fs::path& stick) {
  return List(stick, ".kaorishow");
}

}  // namespace kaori::shows
