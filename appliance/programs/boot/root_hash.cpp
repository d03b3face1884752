#include "appliance/programs/boot/root_hash.h"

#include <algorithm>
#include <cstddef>

#include "appliance/core/update/pending.h"

namespace kaori::boot {
namespace {

// A dm-verity table (kernel's Documentation/admin-guide/device-mapper/verity.rst) says "verity", then
// versions, devices and sizes, the digest's name, and the root hash.
constexpr std::string_view kTable = " verity ";
constexpr std::string_view kDigest = " blake2b-512 ";  // The hash follows.
// 512 bits in small hexadecimal digits, as veritysetup prints them.
constexpr std::size_t kDigits = 128;
// The word is RAUC's, by which it knows what runs; rootfs/image/pack.py writes it.
constexpr std::string_view kSlot = "rauc.slot=";

bool IsDigit(char letter) {
  return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f');
}

}  // namespace

// Whether the kernel really checks by this hash is not known here: the status shows what it was told.
std::string RootHashOf(std::string_view command_line) {
  const auto table = command_line.find(kTable);
  const auto digest = table == std::string_view::npos ? table : command_line.find(kDigest, table);
  if (digest == std::string_view::npos) return {};
  const auto hash = command_line.substr(digest + kDigest.size(), kDigits);
  if (hash.size() != kDigits || !std::ranges::all_of(hash, IsDigit)) return {};
  return std::string(hash);
}

bool IsTried(std::string_view note, std::string_view slot) {
  const auto pending = update::ParsePending(note);
  return pending && slot == (pending->slot == ports::Slot::kA ? "A" : "B");
}

std::string SlotOf(std::string_view command_line) {
  for (const std::string_view slot : {"A", "B"}) {
    const auto word = command_line.find(std::string(kSlot) + std::string(slot));
    if (word == std::string_view::npos || (word > 0 && command_line[word - 1] != ' ')) continue;
    const auto end = word + kSlot.size() + slot.size();
    if (end == command_line.size() || command_line[end] == ' ' || command_line[end] == '\n')
      return std::string(slot);
  }
  return {};
}

}  // namespace kaori::boot
