#include "hw-sim/hil/noise_slot.h"

#include <cstdint>
#include <string_view>

#include "hw-sim/hil/disk_copy.h"

namespace kaori::hil {
namespace {

// As rootfs/image/esp.py lays a kernel's file: in one piece of this size that begins on a whole MiB, with the kernel itself last.
constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;
constexpr std::uint64_t kKernelFile_bytes = 24 * kMiB;
// The beginning of a PE file, and what the command line of slot B's kernel alone says.
constexpr std::string_view kPeMagic = "MZ", kCommandLineOfB = "rauc.slot=B";

// Where slot B's kernel file begins on the disk. The command line stands in front of the kernel, in the file's first part.
Result<std::uint64_t> KernelOfB(const std::string& disk) {
  const auto boot = PartitionSpan(disk, "boot");
  if (!boot) return tl::unexpected(boot.error());
  const auto read = ReadPart(disk, *boot);
  if (!read) return tl::unexpected(read.error());
  const std::string_view bytes = *read;
  const std::size_t line = bytes.find(kCommandLineOfB);
  if (line == bytes.npos) return FailInput(disk + " has no kernel of slot B");
  std::uint64_t at = line / kMiB * kMiB;
  while (at > 0 && bytes.substr(at, kPeMagic.size()) != kPeMagic) at -= kMiB;
  if (at == 0 || at + kKernelFile_bytes > bytes.size())
    return FailInput(disk + " has slot B's kernel in no file of its own");
  return boot->at_bytes + at;
}

// From the check's own chance, so that a run can be repeated.
Result<void> PutNoise(const std::string& disk, std::uint64_t at_bytes, std::mt19937& chance) {
  std::string noise(kNoise_bytes, '\0');
  for (char& byte : noise) byte = static_cast<char>(chance());
  return WritePart(disk, at_bytes, noise);
}

}  // namespace

// The kernel's last MiB may be zeros that only fill its file.
Result<void> MakeSlotBNoise(const std::string& disk, std::mt19937& chance) {
  const auto kernel = KernelOfB(disk);
  if (!kernel) return tl::unexpected(kernel.error());
  for (const char* name : {"root-b", "verity-b"}) {
    const auto part = PartitionStart_bytes(disk, name);
    if (!part) return tl::unexpected(part.error());
    if (auto ok = PutNoise(disk, *part, chance); !ok) return ok;
  }
  return PutNoise(disk, *kernel + kKernelFile_bytes - 2 * kNoise_bytes, chance);
}

}  // namespace kaori::hil
