// Machines of several processors on the bench: what differs, and what stays.
#include <gmock/gmock.h>

#include "hw-sim/hil/qemu_command.h"

namespace kaori::hil {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::IsSupersetOf;
using ::testing::Not;

TEST(QemuCommand, IsThatOfTheImageSProcessor) {
  const QemuOptions options{.architecture = Architecture::kArm64, .image = "i", .folder = "/f"};
  const auto loaded = QemuCommand(options, {}, "line", "d");
  EXPECT_EQ(loaded.front(), "qemu-system-aarch64");
  EXPECT_THAT(loaded, IsSupersetOf({"virt", "cortex-a72", "i/Image"}));
  EXPECT_THAT(loaded, Not(Contains("q35")));
  EXPECT_THAT(loaded, Contains("unix:/f/lines,server=on,wait=off")) << "its GPIO lines can be set";
  const auto on_sata = QemuCommand(
      options, {.firmware = true, .watchdog_resets = true, .disk_bus = DiskBus::kSata}, "line", "d");
  EXPECT_THAT(on_sata, IsSupersetOf({"/usr/share/qemu-efi-aarch64/QEMU_EFI.fd", "ahci,id=ide", "i6300esb"}));
  EXPECT_THAT(on_sata, Not(Contains(HasSubstr("ICH9")))) << "it is no PC";
  EXPECT_THAT(LoggedCommandLine(options, "root=a"), HasSubstr("console=ttyAMA0"));
}

TEST(QemuCommand, OfAPcIsAsItWas) {
  const QemuOptions options{.image = "i", .folder = "/f"};
  const auto command =
      QemuCommand(options, {.watchdog_resets = true, .disk_bus = DiskBus::kSata}, "line", "d");
  EXPECT_EQ(command.front(), "qemu-system-x86_64");
  EXPECT_THAT(command, IsSupersetOf({"q35", "Nehalem,+rdrand", "i/bzImage", "ICH9-LPC.noreboot=off",
                                     "ide-hd,drive=disk"}));
  EXPECT_THAT(command, Not(Contains("ahci,id=ide"))) << "the chip set has it";
  EXPECT_THAT(command, Not(Contains("-qtest"))) << "it has no lines to set";
}

TEST(Architecture, IsNamedAsDebianNamesIt) {
  EXPECT_EQ(ParseArchitecture("arm64"), Architecture::kArm64);
  EXPECT_EQ(ParseArchitecture("amd64"), Architecture::kAmd64);
  EXPECT_FALSE(ParseArchitecture("riscv64"));
}

}  // namespace
}  // namespace kaori::hil
