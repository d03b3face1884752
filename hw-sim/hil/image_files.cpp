#include "hw-sim/hil/image_files.h"

#include "drivers/base/read_file.h"
#include "hw-sim/hil/process.h"

namespace kaori::hil {
namespace {

// As appliance/authoring/bundle/bundle_maker.cpp packs them, and rootfs/image/tested.py reads them.
constexpr const char* kUpdateFiles[] = {
    "root.erofs",  "root.verity", "boot/EFI/Linux/kaori-a.efi", "boot/EFI/Linux/kaori-b.efi",
    "boot-a.vfat", "boot-b.vfat"};

}  // namespace

// "HASH  FILE", or a reason, which has no hash in front. A file of each kind of image is missing in the other.
std::map<std::string, std::string> UpdateFileHashes(const std::string& image, const std::string& log) {
  constexpr std::size_t kHash_letters = 64;
  std::map<std::string, std::string> hashes;
  for (const char* file : kUpdateFiles) {
    if (!RunToEnd({"sha256sum", image + "/" + file}, log)) continue;
    const std::string said = ReadFile(log).value_or("");
    if (said.find(' ') == kHash_letters) hashes[file] = said.substr(0, kHash_letters);
  }
  return hashes;
}

}  // namespace kaori::hil
