#include "drivers/loader/box_disk.h"

#include <filesystem>
#include <utility>

#include "drivers/base/root_disk.h"
#include "drivers/loader/block_file.h"
#include "drivers/loader/systemd_boot.h"

namespace kaori::loader {
namespace {

using Partition = std::unique_ptr<ports::BlockDevice>;

// The node of a partition beside the root, or the file in its place. A partition of that name on another disk, such as a stick with
// the same image, is never meant.
Result<Partition> OpenPartition(const BoxDisk& disk, const std::string& name, Claim claim) {
  if (!disk.folder.empty()) return OpenBlockFile(std::filesystem::path(disk.folder) / name, claim);
  const auto device = PartitionBesideRoot("/sys/class/block", name);
  if (!device) return Fail(std::errc::no_such_device, "find the partition " + name + " beside the root");
  return OpenBlockFile("/dev/" + *device, claim);
}

// A Raspberry Pi has a partition for each slot's kernel. An update overwrites it as a whole, with the firmware's files in it.
Result<SlotPartitions> WithPartitionOfKernel(const BoxDisk& disk, const std::string& name,
                                             SlotPartitions slot) {
  auto own = OpenPartition(disk, name, Claim::kAlone);
  if (!own) return tl::unexpected(own.error());
  slot.boot = std::move(*own);
  slot.kernel = {.at_bytes = 0, .bytes = slot.boot->bytes()};
  if (slot.kernel.bytes == kKernel_bytes) return slot;
  return Fail(std::errc::bad_message, "the partition " + name + " has another size than an image gives it");
}

}  // namespace

// Everything is opened before anything is looked at, so that a disk of an earlier layout is refused by the name of what it lacks.
Result<SlotPartitions> OpenOtherSlot(const BoxDisk& disk, ports::Slot running) {
  const auto other = ports::Other(running);
  const std::string letter = other == ports::Slot::kA ? "a" : "b";
  auto root = OpenPartition(disk, "root-" + letter, Claim::kAlone),
       verity = OpenPartition(disk, "verity-" + letter, Claim::kAlone),
       boot = OpenPartition(disk, "boot", Claim::kShared);
  for (const auto* each : {&root, &verity, &boot})
    if (!*each) return tl::unexpected(each->error());
  const auto has_autoboot = HasAutoboot(**boot);
  if (!has_autoboot) return tl::unexpected(has_autoboot.error());
  SlotPartitions slot{std::move(*root), std::move(*verity), std::move(*boot), {}};
  if (*has_autoboot) return WithPartitionOfKernel(disk, "boot-" + letter, std::move(slot));
  const auto kernel = FindKernel(*slot.boot, other);
  if (!kernel) return tl::unexpected(kernel.error());
  slot.kernel = *kernel;
  return slot;
}

// The partition is opened for both anew: a choice outlives the writing of a slot.
Result<std::unique_ptr<ports::BootChoice>> OpenBootChoice(const BoxDisk& disk, ports::Slot running) {
  auto boot = OpenPartition(disk, "boot", Claim::kShared);
  if (!boot) return tl::unexpected(boot.error());
  const auto has_autoboot = HasAutoboot(**boot);
  if (!has_autoboot) return tl::unexpected(has_autoboot.error());
  if (*has_autoboot) return std::make_unique<Tryboot>(std::move(*boot), running, disk.argument);
  return std::make_unique<SystemdBoot>(std::move(*boot), running, disk.variables);
}

}  // namespace kaori::loader
