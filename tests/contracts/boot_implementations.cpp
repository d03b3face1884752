// The disk and its loader: systemd-boot's files and its variable, and those of a Raspberry Pi's firmware, played by the test as
// these read them; the simulated ones; and a file in place of a disk's node.
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "drivers/base/read_file.h"
#include "drivers/loader/block_file.h"
#include "drivers/loader/systemd_boot.h"
#include "drivers/loader/tryboot.h"
#include "hw-sim/devices/boot_loader.h"
#include "hw-sim/devices/simulated_disk.h"
#include "tests/contracts/block_device_contract.h"
#include "tests/contracts/boot_choice_contract.h"
#include "tests/drivers/fat_fixture.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::contracts {
namespace {

class FileSubject final : public BlockDeviceSubject {
 public:
  FileSubject() {
    const std::string file = folder_.path() + "/disk";
    std::ofstream(file).flush();
    std::filesystem::resize_file(file, kBytes);
    device_ = loader::OpenBlockFile(file).value();
  }
  ports::BlockDevice& device() override { return *device_; }

 private:
  sim::TempFolder folder_;
  std::unique_ptr<ports::BlockDevice> device_;
};

class SimulatedDiskSubject final : public BlockDeviceSubject {
 public:
  ports::BlockDevice& device() override { return *device_; }

 private:
  sim::SimulatedDisk disk_{4 * kBytes};
  std::unique_ptr<ports::BlockDevice> device_ = disk_.Partition(kBytes, kBytes);
};

INSTANTIATE_TEST_SUITE_P(
    Disks, BlockDeviceContract,
    ::testing::Values(Implementation<BlockDeviceSubject>{"File",
                                                         [] { return std::make_unique<FileSubject>(); }},
                      Implementation<BlockDeviceSubject>{
                          "Simulated", [] { return std::make_unique<SimulatedDiskSubject>(); }}),
    NameOf<BlockDeviceSubject>);

// The loader takes the variable's entry where there is one, and removes it; else what loader.conf names.
class SystemdBootSubject final : public BootChoiceSubject {
 public:
  SystemdBootSubject() {
    tests::FatFixture fat(disk_.content());
    std::filesystem::create_directory(variables_);
    Start(ports::Slot::kA);
  }
  ports::BootChoice& choice() override { return *choice_; }
  void SwitchOn() override {
    constexpr std::string_view kVariable = "LoaderEntryOneShot-4a67b082-0a4c-41cf-b6c7-440b29bb8c4f";
    const auto once = ReadFile(variables_ / kVariable);
    std::filesystem::remove(variables_ / kVariable);
    const auto settings = disk_.content().begin() + tests::FatFixture::kSettings;
    const std::string text(settings, settings + 512);
    const bool is_b = once ? (*once)[4 + 12] == 'b' : text.find("\ndefault kaori-b.efi\n") != text.npos;
    Start(is_b ? ports::Slot::kB : ports::Slot::kA);
  }
  void ForgetVariables() override { std::filesystem::remove_all(variables_); }

 private:
  void Start(ports::Slot running) {
    choice_.emplace(disk_.Partition(0, tests::FatFixture::kBytes), running, variables_);
  }

  sim::TempFolder folder_;
  std::filesystem::path variables_ = folder_.path() + "/efivars";
  sim::SimulatedDisk disk_{tests::FatFixture::kBytes};
  std::optional<loader::SystemdBoot> choice_;
};

// The firmware of a Raspberry Pi takes the last boot_partition of autoboot.txt whose section counts: [all] always, [tryboot] after a
// restart with that argument, which it forgets. The text and its place are written out here once more, as the firmware has them.
class TrybootSubject final : public BootChoiceSubject {
 public:
  TrybootSubject() {
    tests::FatFixture(disk_.content())
        .AddAutoboot("[all]\ntryboot_a_b=1\nboot_partition=2\n[tryboot]\nboot_partition=3\n");
    std::ofstream(argument_).flush();
    Start(ports::Slot::kA);
  }
  ports::BootChoice& choice() override { return *choice_; }
  void SwitchOn() override {
    const bool tries = ReadFile(argument_).value_or("").find(" tryboot") != std::string::npos;
    if (std::filesystem::exists(argument_)) std::ofstream(argument_).flush();
    std::istringstream lines(reinterpret_cast<const char*>(&disk_.content()[tests::FatFixture::kAutoboot]));
    bool counts = false;
    char partition = '0';
    for (std::string line; std::getline(lines, line);) {
      if (line.starts_with("[")) counts = line == "[all]" || (tries && line == "[tryboot]");
      if (counts && line.starts_with("boot_partition=")) partition = line.back();
    }
    ASSERT_TRUE(partition == '2' || partition == '3');
    Start(partition == '2' ? ports::Slot::kA : ports::Slot::kB);
  }
  void ForgetVariables() override { std::filesystem::remove(argument_); }

 private:
  void Start(ports::Slot running) {
    choice_.emplace(disk_.Partition(0, tests::FatFixture::kBytes), running, argument_);
  }

  sim::TempFolder folder_;
  std::filesystem::path argument_ = folder_.path() + "/reboot-param";
  sim::SimulatedDisk disk_{tests::FatFixture::kBytes};
  std::optional<loader::Tryboot> choice_;
};

class SimulatedLoaderSubject final : public BootChoiceSubject {
 public:
  ports::BootChoice& choice() override { return loader_; }
  void SwitchOn() override { loader_.SwitchOn(); }
  void ForgetVariables() override { loader_.ForgetVariables(); }

 private:
  sim::BootLoader loader_;
};

INSTANTIATE_TEST_SUITE_P(Loaders, BootChoiceContract,
                         ::testing::Values(
                             Implementation<BootChoiceSubject>{
                                 "SystemdBoot", [] { return std::make_unique<SystemdBootSubject>(); }},
                             Implementation<BootChoiceSubject>{
                                 "Tryboot", [] { return std::make_unique<TrybootSubject>(); }},
                             Implementation<BootChoiceSubject>{
                                 "Simulated", [] { return std::make_unique<SimulatedLoaderSubject>(); }}),
                         NameOf<BootChoiceSubject>);

}  // namespace
}  // namespace kaori::contracts
