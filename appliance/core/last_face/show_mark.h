// By which a show is known to what was kept while it played: its last face, its show log.
#pragma once

#include <cstdint>
#include <filesystem>

#include "appliance/core/last_face/last_face.h"
#include "drivers/base/read_file.h"
#include "drivers/base/result.h"

namespace kaori::last_face {

// The mark of a pack: a checksum of its beginning. Blocks for the disk. Errors: those of ReadBeginning.
inline Result<std::uint64_t> ShowMark(const std::filesystem::path& pack) {
  return ReadBeginning(pack, kShowMark_bytes).map([](const auto& text) { return Fnv1a(text); });
}

}  // namespace kaori::last_face
