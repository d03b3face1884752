// A box that starts from a USB disk knows which devices on USB are that disk's, and cuts off the others.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "appliance/programs/boot/usb_medium.h"
#include "drivers/base/read_file.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class Usb : public ::testing::Test {
 protected:
  Usb() : folder_(fs::path(::testing::TempDir()) / ("usb-medium-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(blocks());
    for (const std::string bus : {"usb1", "usb2"}) {
      Write(devices() / bus / "authorized", "1\n");
      Write(devices() / bus / "authorized_default", "1\n");
    }
    for (const std::string device : {"1-3", "2-1", "2-1.4", "2-2"})
      Write(devices() / device / "authorized", "1\n");
    fs::create_directories(devices() / "2-1:1.0");
  }
  ~Usb() override { fs::remove_all(folder_); }

  fs::path blocks() const { return folder_ / "class/block"; }
  fs::path devices() const { return folder_ / "bus"; }

  void VerifyRootOn(const std::string& partition) {
    fs::create_directories(folder_ / "devices" / partition);
    fs::create_directories(blocks() / "dm-0/slaves");
    fs::create_symlink(folder_ / "devices" / partition, blocks() / "dm-0/slaves/sda2");
  }
  static void Write(const fs::path& file, const std::string& text) {
    fs::create_directories(file.parent_path());
    std::ofstream(file) << text;
  }
  char Authorised(const std::string& device) const {
    return ReadFile(devices() / device / "authorized").value_or("?")[0];
  }

 private:
  fs::path folder_;
};

TEST_F(Usb, TheMediumIsEachDeviceOnTheWayToTheRootsDisk) {
  VerifyRootOn("pci0000:00/0000:00:14.0/usb2/2-1/2-1.4/2-1.4:1.0/host0/target0:0:0/0:0:0:0/block/sda/sda2");
  EXPECT_THAT(UsbMedium(blocks()), ElementsAre("usb2", "2-1", "2-1.4"));
}

TEST_F(Usb, ADiskInsideThePcIsNone) {
  EXPECT_THAT(UsbMedium(blocks()), IsEmpty()) << "there is no root at all";
  VerifyRootOn("pci0000:00/0000:00:1f.2/ata1/host0/target0:0:0/0:0:0:0/block/sda/sda2");
  EXPECT_THAT(UsbMedium(blocks()), IsEmpty());
}

TEST_F(Usb, WhatIsNotTheMediumIsCutOffAndNothingMoreIsLetIn) {
  EXPECT_THAT(DeauthoriseOthers(devices(), {"usb2", "2-1", "2-1.4"}), ElementsAre("1-3", "2-2"));
  EXPECT_EQ(Authorised("1-3"), '0');
  EXPECT_EQ(Authorised("2-2"), '0');
  EXPECT_EQ(Authorised("2-1"), '1');
  EXPECT_EQ(Authorised("2-1.4"), '1');
  EXPECT_EQ(Authorised("usb1"), '1') << "a bus cannot be cut off";
  for (const std::string bus : {"usb1", "usb2"})
    EXPECT_EQ(ReadFile(devices() / bus / "authorized_default").value_or("?")[0], '0');
}

TEST_F(Usb, WhereBusesLetInNothingAllIsLeftAsItIs) {
  for (const std::string bus : {"usb1", "usb2"}) Write(devices() / bus / "authorized_default", "0\n");
  EXPECT_THAT(DeauthoriseOthers(devices(), {}), IsEmpty());
  EXPECT_EQ(Authorised("1-3"), '1');
}

}  // namespace
}  // namespace kaori::boot
