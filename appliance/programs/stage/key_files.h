// Pictures of keys that a show brings, as files where the surfaces' driver looks for them.
#pragma once

#include <filesystem>
#include <span>

#include "appliance/core/show/pack_keys.h"
#include "drivers/base/result.h"

namespace kaori::stage {

// "72/0123456789abcdef-lit.jpg", or "72/blank.jpg" of a key that calls nothing; empty for a shape that no deck has. Nothing of
// a pack's own text is in it. Pure.
std::filesystem::path KeyFileName(const show::KeyPicture& key);

// Writes FOLDER/72/SUM.jpg and its like, as DeckPictures reads them, and removes those of a show before. FOLDER lies in
// memory. Each file is replaced whole. A picture of a shape that no deck has is passed over. Errors: those of the file system.
Result<void> LayOutKeys(std::span<const show::KeyPicture> keys, const std::filesystem::path& folder);

}  // namespace kaori::stage
