#include "appliance/programs/editor/store.h"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

#include "drivers/base/folder.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::editor {
namespace {

namespace fs = std::filesystem;

// Far more than an expression with all of its control points takes.
constexpr std::size_t kStoreMost_bytes = 1U << 20U;
constexpr std::string_view kStoreAside = ".faulty";

// "03-": the keys count from one. The name that follows is for people alone: only the number says which slot
// it is.
std::string PrefixOf(int slot) {
  return fmt::format("{:02}-", slot + 1);
}

// One that was kept aside before is not written over.
fs::path AsideOf(const fs::path& file) {
  const std::string first = file.string() + std::string(kStoreAside);
  fs::path aside = first;
  for (int number = 2; IsThere(aside); ++number) aside = first + std::to_string(number);
  return aside;
}

// The name that a file had before it was kept aside; empty where it was not.
fs::path BeforeAside(const fs::path& file) {
  const std::string path = file.string();
  const auto at = path.rfind(kStoreAside);
  return at == std::string::npos ? fs::path() : fs::path(path.substr(0, at));
}

// -1: it names no slot.
int SlotOf(const fs::path& file) {
  const std::string name = file.filename().string();
  if (file.extension() != ".toml") return -1;
  for (int slot = 0; slot < kSlots; ++slot)
    if (name.starts_with(PrefixOf(slot))) return slot;
  return -1;
}

// Sorted, so that of two files for one slot the same one is read each time. A folder that is not there holds
// nothing.
std::vector<fs::path> FilesOf(const fs::path& folder) {
  std::vector<fs::path> files = ListFolder(folder).value_or(std::vector<fs::path>{});
  std::erase_if(files, [](const fs::path& file) { return SlotOf(file) < 0; });
  return files;
}

// Files that were kept aside and could come back, under the names that they have now.
std::vector<fs::path> AsidesOf(const fs::path& folder) {
  std::vector<fs::path> files = ListFolder(folder).value_or(std::vector<fs::path>{});
  std::erase_if(files, [](const fs::path& file) { return SlotOf(BeforeAside(file)) < 0; });
  return files;
}

// Errors: those of ReadFile; those of ReadOwn, of which the first fault is told.
Result<Work> ReadWork(const fs::path& file, const Points& points, const face::Cast& cast) {
  const auto text = ReadFile(file, {.most_bytes = kStoreMost_bytes, .most_levels = kMostLevels});
  if (!text) return tl::unexpected(text.error());
  return ReadOwn(*text, file.string(), points, cast);
}

// Names are how people call an expression, so that two of one name could not be told apart.
bool HasName(const Slots& slots, const std::string& name) {
  return std::ranges::any_of(slots, [&](const auto& own) { return own && own->name == name; });
}

// `named` is what it is called, or was before it was kept aside.
Result<void> ReadInto(const fs::path& file, const fs::path& named, Slots& slots, const Points& points,
                      const face::Cast& cast) {
  auto work = ReadWork(file, points, cast);
  if (!work) return tl::unexpected(work.error());
  work->slot = SlotOf(named);
  auto& slot = slots[static_cast<std::size_t>(work->slot)];
  if (slot) return FailInput(fmt::format("{}: its place is taken by \"{}\"", file.string(), slot->name));
  if (HasName(slots, work->name))
    return FailInput(fmt::format("{}: another one is named \"{}\"", file.string(), work->name));
  slot = std::move(*work);
  return {};
}

// A file that is not there is no error.
Result<void> Remove(const fs::path& file) {
  std::error_code error;
  fs::remove(file, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "remove " + file.string());
  return {};
}

// Removes every file of the slot but `kept`, and gives the last error; those that can be removed are.
Result<void> RemoveAllBut(const fs::path& folder, int slot, const fs::path& kept) {
  Result<void> outcome;
  for (const fs::path& file : FilesOf(folder)) {
    if (SlotOf(file) != slot || file == kept) continue;
    if (auto removed = Remove(file); !removed) outcome = removed;
  }
  return outcome;
}

}  // namespace

// What was aside before is tried after all others, so that it gets only slots and names that are free; a file
// that was put aside just now is not tried again.
Stored ReadStore(const fs::path& folder, const Points& points, const face::Cast& cast) {
  Stored stored;
  std::error_code ignored;  // A file that cannot be renamed was named; it stays where it is.
  const auto before = AsidesOf(folder);
  for (const fs::path& file : FilesOf(folder)) {
    const auto read = ReadInto(file, file, stored.slots, points, cast);
    if (read) continue;
    stored.complaints.push_back(read.error().message() + "; it is kept aside");
    fs::rename(file, AsideOf(file), ignored);
  }
  for (const fs::path& aside : before)
    if (ReadInto(aside, BeforeAside(aside), stored.slots, points, cast))
      fs::rename(aside, BeforeAside(aside), ignored);
  return stored;
}

// The new file is whole before an old one of the same slot is removed: a crash in between leaves two, of
// which the next ReadStore keeps one aside.
Result<void> WriteToStore(const fs::path& folder, const Work& work, const Points& points) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return Fail(static_cast<std::errc>(error.value()), "make the folder " + folder.string());
  const fs::path file = folder / (PrefixOf(work.slot) + work.name + ".toml");
  auto written = WriteWholeFile(file, {AsBytes(WriteOwn(work, points))});
  if (!written) return written;
  return RemoveAllBut(folder, work.slot, file);
}

Result<void> RemoveFromStore(const fs::path& folder, int slot) {
  return RemoveAllBut(folder, slot, {});
}

}  // namespace kaori::editor
