// Pictures for surfaces with screens in their keys, which a pack may carry beside its show.
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "appliance/core/show/pack.h"

namespace kaori::show {

// A file as a key takes it (decode::DeckShape), for one call in one of its two states.
// Copied out of the pack's memory.
struct KeyPicture {
  int key_px = 0;          // The side of the key: which shape it is for.
  std::uint64_t call = 0;  // roles::SumOfCall; 0: of a key that calls nothing.
  bool is_lit = false;
  // JPEG, or a Windows bitmap for keys of 80 px; nothing here decodes it.
  std::vector<std::uint8_t> file;
  friend bool operator==(const KeyPicture&, const KeyPicture&) = default;
};

// More of them, or larger ones, are in no pack of ours; a box writes them into its memory.
inline constexpr std::size_t kMostKeyPictures = 8192;
inline constexpr std::size_t kMostKeyPicture_bytes = std::size_t{64} << 10U;
inline constexpr std::size_t kMostKeyPictures_bytes = std::size_t{24} << 20U;

// A show, and the pictures that its pack has; none is usual.
struct ShowWithKeys {
  Show show;
  std::vector<KeyPicture> keys;
};

// As LoadPack, with the pictures, which are copied out of the pack; blocks for the file, which is read once for both.
// Any thread. Errors: as LoadPack; also invalid_argument (more than the bounds above).
Result<ShowWithKeys> LoadPackWithKeys(const std::filesystem::path& file, const LoadOptions& options = {});

// As SavePack, with the pictures. Programs of before play the show and pass them over.
Result<void> SavePackWithKeys(const ShowWithKeys& whole, const std::filesystem::path& file,
                              const SecretKey* signer = nullptr);

}  // namespace kaori::show
