#include "drivers/loader/systemd_boot.h"

#include <array>
#include <string_view>

#include "drivers/loader/boot_partition.h"

namespace kaori::loader {
namespace {

using Sector = std::array<std::uint8_t, kSettings_bytes>;

// rootfs/image/esp.py writes this line, and the letter of a slot behind it.
constexpr std::string_view kLine = "\ndefault kaori-";
constexpr std::string_view kLineEnd = ".efi\n";

// loader.conf, and where it and its one changing letter lie.
struct Settings {
  Extent place;
  Sector content{};
  std::size_t letter_at = 0;
};

// The one letter that names a slot. A second line "default" is refused: the loader takes the last of them, and a change of the
// first would change nothing.
Result<Settings> ReadSettings(ports::BlockDevice& partition) {
  const auto place = FindSettings(partition);
  if (!place) return tl::unexpected(place.error());
  Settings settings{.place = *place};
  if (auto ok = partition.Read(place->at_bytes, settings.content); !ok) return tl::unexpected(ok.error());
  const std::string_view text(reinterpret_cast<const char*>(settings.content.data()),
                              settings.content.size());
  const std::size_t at = text.find(kLine);
  const auto rest = at == text.npos ? std::string_view() : text.substr(at + kLine.size());
  const bool is_ours = rest.size() > kLineEnd.size() && (rest[0] == 'a' || rest[0] == 'b') &&
                       rest.substr(1).starts_with(kLineEnd) && text.find("\ndefault ", at + 1) == text.npos;
  if (!is_ours) return Fail(std::errc::bad_message, "read which slot loader.conf names");
  settings.letter_at = at + kLine.size();
  return settings;
}

std::uint8_t LetterOf(ports::Slot slot) {
  return slot == ports::Slot::kA ? 'a' : 'b';
}

}  // namespace

Result<ports::Slot> SystemdBoot::Default() {
  return ReadSettings(*partition_).map([](const Settings& settings) {
    return settings.content[settings.letter_at] == LetterOf(ports::Slot::kA) ? ports::Slot::kA
                                                                             : ports::Slot::kB;
  });
}

Result<void> SystemdBoot::TryOnce(ports::Slot slot) {
  return WriteOneShot(variables_, slot == ports::Slot::kA ? "kaori-a.efi" : "kaori-b.efi");
}

// A sector is on a disk as a whole or not at all, so that this one step is the whole change.
Result<void> SystemdBoot::Confirm(ports::Slot slot) {
  auto settings = ReadSettings(*partition_);
  if (!settings) return tl::unexpected(settings.error());
  if (settings->content[settings->letter_at] == LetterOf(slot)) return {};
  settings->content[settings->letter_at] = LetterOf(slot);
  if (auto ok = partition_->Write(settings->place.at_bytes, settings->content); !ok) return ok;
  if (auto ok = partition_->Flush(); !ok) return ok;
  Sector read{};
  if (auto ok = partition_->Read(settings->place.at_bytes, read); !ok) return ok;
  return read == settings->content ? Result<void>{} : Fail(std::errc::io_error, "read loader.conf back");
}

}  // namespace kaori::loader
