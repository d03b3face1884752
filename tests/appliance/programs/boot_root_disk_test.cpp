// Which disk the box keeps its data on, as the kernel lists them.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "drivers/base/root_disk.h"

namespace kaori {
namespace {

namespace fs = std::filesystem;

class BlockDevices : public ::testing::Test {
 protected:
  BlockDevices() : folder_(fs::path(::testing::TempDir()) / ("block-devices-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(blocks());
  }
  ~BlockDevices() override { fs::remove_all(folder_); }

  fs::path blocks() const { return folder_ / "class/block"; }

  void AddPartition(const std::string& disk, const std::string& partition, const std::string& name) {
    const fs::path place = folder_ / "devices" / disk / partition;
    fs::create_directories(place);
    std::ofstream(place / "uevent") << "MAJOR=254\nDEVNAME=" << partition << "\nPARTNAME=" << name << "\n";
    fs::create_symlink(place, blocks() / partition);
  }
  void VerifyRootOn(const std::string& disk, const std::string& partition) {
    const fs::path slaves = folder_ / "devices/virtual/dm-0/slaves";
    fs::create_directories(slaves);
    fs::create_symlink(folder_ / "devices" / disk / partition, slaves / partition);
    fs::create_symlink(folder_ / "devices/virtual/dm-0", blocks() / "dm-0");
  }

 private:
  fs::path folder_;
};

TEST_F(BlockDevices, TheDataPartitionIsTheOneBesideTheRoot) {
  AddPartition("sda", "sda6", "data");
  AddPartition("vda", "vda2", "root-a");
  AddPartition("vda", "vda6", "data");
  AddPartition("vdb", "vdb6", "data");
  VerifyRootOn("vda", "vda2");
  EXPECT_EQ(PartitionBesideRoot(blocks(), "data"), "vda6");
}

TEST_F(BlockDevices, AnotherDisksDataIsNotTaken) {
  AddPartition("sda", "sda6", "data");
  AddPartition("vda", "vda2", "root-a");
  AddPartition("vda", "vda3", "database");
  VerifyRootOn("vda", "vda2");
  EXPECT_EQ(PartitionBesideRoot(blocks(), "data"), std::nullopt);
}

TEST_F(BlockDevices, WithoutAVerifiedRootThereIsNone) {
  AddPartition("vda", "vda6", "data");
  EXPECT_EQ(PartitionBesideRoot(blocks(), "data"), std::nullopt);
  EXPECT_EQ(PartitionBesideRoot("/nowhere", "data"), std::nullopt);
}

}  // namespace
}  // namespace kaori
