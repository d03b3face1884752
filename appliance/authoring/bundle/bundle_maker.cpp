#include "appliance/authoring/bundle/bundle_maker.h"

#include <optional>
#include <string_view>
#include <vector>

#include "appliance/core/update/compression.h"
#include "drivers/base/number.h"
#include "drivers/base/read_file.h"
#include "drivers/base/whole_file.h"

namespace kaori::authoring {
namespace {

// The box reads the same file, in its verified root, before it takes an update: what a bundle says is what its image says.
constexpr std::string_view kVersionFile = "root/usr/share/kaori/version";

show::Checksum ChecksumOf(std::span<const std::uint8_t> bytes) {
  show::Checksummer sum;
  sum.Add(bytes);
  return sum.Finish();
}

}  // namespace

std::array<std::filesystem::path, update::kParts> PartFiles(const std::filesystem::path& image) {
  if (std::filesystem::exists(image / "boot-a.vfat"))
    return {image / "root.erofs", image / "root.verity", image / "boot-a.vfat", image / "boot-b.vfat"};
  return {image / "root.erofs", image / "root.verity", image / "boot/EFI/Linux/kaori-a.efi",
          image / "boot/EFI/Linux/kaori-b.efi"};
}

// A line of its own behind the two that every image has.
Result<std::string> ProductOf(const std::filesystem::path& image) {
  constexpr std::string_view kWord = "\nproduct ";
  const auto text = ReadFile(image / kVersionFile);
  if (!text) return tl::unexpected(text.error());
  const auto at = text->find(kWord);
  if (at == text->npos) return std::string(update::kProduct);
  const std::string_view rest = std::string_view(*text).substr(at + kWord.size());
  return std::string(rest.substr(0, rest.find('\n')));
}

Result<std::uint32_t> VersionOf(const std::filesystem::path& image) {
  constexpr std::string_view kWord = "version ";
  const auto file = image / kVersionFile;
  const auto text = ReadFile(file);
  if (!text) return tl::unexpected(text.error());
  const std::string_view line = std::string_view(*text).substr(0, text->find('\n'));
  const auto version = line.starts_with(kWord) ? ParseNumber<std::uint32_t>(line.substr(kWord.size()))
                                               : std::optional<std::uint32_t>();
  if (!version) return FailInput(file.string() + ": it names no version");
  return *version;
}

Result<void> MakeBundle(update::Manifest manifest,
                        const std::array<std::filesystem::path, update::kParts>& parts,
                        const show::SecretKey& signer, const std::filesystem::path& file,
                        update::Packing packing) {
  std::vector<std::uint8_t> payload;
  for (std::size_t n = 0; n < update::kParts; ++n) {
    const auto content = ReadFile(parts[n], {.most_bytes = update::kLargestPart_bytes});
    if (!content) return tl::unexpected(content.error());
    const auto packed = update::Pack(AsBytes(*content), packing);
    if (!packed) return tl::unexpected(packed.error());
    manifest.parts[n] = {
        .packed_bytes = packed->size(), .bytes = content->size(), .checksum = ChecksumOf(AsBytes(*content))};
    payload.insert(payload.end(), packed->begin(), packed->end());
  }
  manifest.payload = ChecksumOf(payload);
  manifest.payload_bytes = payload.size();
  const update::Header header = update::MakeHeader(manifest, signer);
  return WriteWholeFile(file, {header, payload});
}

}  // namespace kaori::authoring
