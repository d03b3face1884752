#include "hw-sim/hil/architecture.h"

#include <array>
#include <cstddef>

namespace kaori::hil {
namespace {

// In the order of Architecture.
constexpr std::array kPlatforms{
    Platform{
        .name = "amd64",
        .qemu = "qemu-system-x86_64",
        .machine = "q35",
        // PCs have RDRAND since 2012. Without it a kernel gathers randomness for a second first, for which Mesa
        // waits when it reads its settings.
        .processor = "Nehalem,+rdrand",
        .kernel = "bzImage",
        .firmware = "/usr/share/ovmf/OVMF.fd",
        .serial = "ttyS0"},
    Platform{.name = "arm64",
             .qemu = "qemu-system-aarch64",
             .machine = "virt",
             .processor = "cortex-a72",
             .kernel = "Image",
             .firmware = "/usr/share/qemu-efi-aarch64/QEMU_EFI.fd",
             .serial = "ttyAMA0"},
};

}  // namespace

const Platform& PlatformOf(Architecture architecture) {
  return kPlatforms.at(static_cast<std::size_t>(architecture));
}

std::optional<Architecture> ParseArchitecture(std::string_view name) {
  for (const Architecture architecture : {Architecture::kAmd64, Architecture::kArm64})
    if (PlatformOf(architecture).name == name) return architecture;
  return std::nullopt;
}

}  // namespace kaori::hil
