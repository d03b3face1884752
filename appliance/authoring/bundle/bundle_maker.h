// Makes an update's file of the parts of an image.
#pragma once

#include <array>
#include <filesystem>
#include <string>

#include "appliance/core/update/bundle.h"
#include "appliance/core/update/compression.h"
#include "drivers/base/result.h"

namespace kaori::authoring {

// The files of an image's folder (rootfs/image/build), in the order of update::Part. Of a board's image the partition of each slot
// stands for its kernel, with what the board's maker has it start by.
std::array<std::filesystem::path, update::kParts> PartFiles(const std::filesystem::path& image);

// The version of an image, by the file in its root that the box reads as well. Errors: those of ReadFile;
// invalid_argument.
Result<std::uint32_t> VersionOf(const std::filesystem::path& image);

// The kind of machine that an image is for, by the same file; a PC's where it names none. Errors: those of ReadFile.
Result<std::string> ProductOf(const std::filesystem::path& image);

// What is packed is what lies in the files now: whoever tested another image than this one signs what nobody saw. Both kernels
// go along, since it is not known in which slot a box runs.
//
// Packs and signs; takes a minute for 300 MB quickly, and 600 MB of memory. `manifest` says version, from and news. The file is
// there as a whole or not at all. Errors: those of ReadFile and WriteWholeFile.
Result<void> MakeBundle(update::Manifest manifest,
                        const std::array<std::filesystem::path, update::kParts>& parts,
                        const show::SecretKey& signer, const std::filesystem::path& file,
                        update::Packing packing);

}  // namespace kaori::authoring
