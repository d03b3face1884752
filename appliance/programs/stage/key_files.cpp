#include "appliance/programs/stage/key_files.h"

#include <algorithm>
#include <set>
#include <string>

#include <fmt/format.h>

#include "drivers/base/folder.h"
#include "drivers/base/whole_file.h"
#include "drivers/decode/stream_deck.h"

namespace kaori::stage {

namespace fs = std::filesystem;

// The call is a number, and the rest is chosen here: whatever a pack says, no path leads out of the folder.
fs::path KeyFileName(const show::KeyPicture& key) {
  const auto* const shape = std::ranges::find(decode::kDeckShapes, key.key_px, &decode::DeckShape::key_px);
  if (shape == decode::kDeckShapes.end()) return {};
  const std::string stem = key.call == 0 ? "blank" : fmt::format("{:016x}", key.call);
  return fs::path(std::to_string(key.key_px)) /
         fmt::format("{}{}{}", stem, key.is_lit ? "-lit" : "", shape->suffix());
}

// What is left over is removed last, so that a key which is drawn meanwhile finds the old picture or the new one.
Result<void> LayOutKeys(std::span<const show::KeyPicture> keys, const fs::path& folder) {
  std::set<fs::path> written;
  for (const show::KeyPicture& key : keys) {
    const fs::path name = KeyFileName(key);
    if (name.empty()) continue;
    std::error_code error;
    fs::create_directories((folder / name).parent_path(), error);
    if (error) return Fail(static_cast<std::errc>(error.value()), "make a folder for pictures of keys");
    if (auto ok = WriteWholeFile(folder / name, {key.file}); !ok) return ok;
    written.insert(folder / name);
  }
  for (const decode::DeckShape& shape : decode::kDeckShapes) {
    const auto files = ListFolder(folder / std::to_string(shape.key_px));
    if (!files) continue;  // There never were any.
    std::error_code none;
    for (const fs::path& file : *files)
      if (!written.contains(file)) fs::remove(file, none);
  }
  return {};
}

}  // namespace kaori::stage
