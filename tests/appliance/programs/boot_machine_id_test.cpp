// The number by which a box is told from every other one.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "appliance/programs/boot/machine_id.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;

class MachineId : public ::testing::Test {
 protected:
  MachineId() : folder_(fs::path(::testing::TempDir()) / ("machine-id-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~MachineId() override { fs::remove_all(folder_); }

  fs::path file() const { return folder_ / "machine-id"; }
  void Write(const std::string& text) { std::ofstream(file()) << text; }

  fs::path folder_;
};

TEST_F(MachineId, IsMadeAtTheFirstStartAndKept) {
  const auto made = KeptMachineId(file(), "");
  ASSERT_TRUE(made);
  EXPECT_THAT(*made, ::testing::MatchesRegex("[0-9a-f]{12}4[0-9a-f]{3}[89ab][0-9a-f]{15}"));
  EXPECT_EQ(KeptMachineId(file(), ""), *made);
}

TEST_F(MachineId, DiffersFromBoxToBox) {
  EXPECT_NE(KeptMachineId(file(), "").value(), KeptMachineId(folder_ / "another", "").value());
}

TEST_F(MachineId, IsTakenAsItIs) {
  const std::string given(32, 'a');
  Write(given + "\n");
  EXPECT_EQ(KeptMachineId(file(), ""), given);
}

TEST_F(MachineId, ThatIsDamagedIsMadeAnew) {
  for (const std::string& damaged :
       {std::string("6b616f72"), std::string(32, '0'), std::string(32, 'A'), std::string(33, 'a'),
        std::string(31, 'a') + "\xFF", std::string(100'000, 'a')}) {
    Write(damaged);
    const auto made = KeptMachineId(file(), "");
    ASSERT_TRUE(made) << damaged.size();
    EXPECT_NE(*made, damaged);
    EXPECT_EQ(KeptMachineId(file(), ""), *made);
    fs::remove(file());
  }
}

TEST_F(MachineId, ThatCannotBeKeptIsAnErrorThatNamesTheFile) {
  const auto made = KeptMachineId(folder_ / "missing" / "machine-id", "");
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message(), ::testing::HasSubstr("machine-id"));
}

TEST_F(MachineId, OfACopiedDiskIsMadeAnewInTheOtherPC) {
  const auto first = KeptMachineId(file(), "0123456789abcdef");
  ASSERT_TRUE(first);
  EXPECT_EQ(KeptMachineId(file(), "0123456789abcdef"), *first);
  EXPECT_EQ(KeptMachineId(file(), ""), *first) << "a PC that says nothing of itself";
  const auto second = KeptMachineId(file(), "00000000abcdef01");
  ASSERT_TRUE(second);
  EXPECT_NE(*second, *first);
  EXPECT_EQ(KeptMachineId(file(), "00000000abcdef01"), *second);
}

TEST_F(MachineId, OfBeforeIsKeptByAnUpdateThatLooksAtThePC) {
  const auto before = KeptMachineId(file(), "");
  EXPECT_EQ(KeptMachineId(file(), "0123456789abcdef"), *before);
  EXPECT_NE(KeptMachineId(file(), "00000000abcdef01"), *before);
}

TEST_F(MachineId, StaysWhereTheMarkOfThePCIsDamagedOrCannotBeKept) {
  const auto first = KeptMachineId(file(), "0123456789abcdef");
  for (const char* const damaged : {"", "0123", "0123456789abcdeX", "0123456789abcdef0"}) {
    std::ofstream(folder_ / "machine-id.pc") << damaged;
    fs::permissions(folder_ / "machine-id.pc", fs::perms::owner_all);
    EXPECT_EQ(KeptMachineId(file(), "00000000abcdef01"), *first) << damaged;
    fs::remove(folder_ / "machine-id.pc");
  }
  fs::create_directories(folder_ / "machine-id.pc/in the way");
  EXPECT_EQ(KeptMachineId(file(), "0123456789abcdef"), *first);
}

TEST_F(MachineId, ThePCIsToldFromOthersByItsSerialNumbers) {
  EXPECT_EQ(MachineMark(folder_), "") << "a PC that says nothing of itself";
  fs::create_directories(folder_ / "class/dmi/id");
  std::ofstream(folder_ / "class/dmi/id/board_serial") << "Default string\n";
  const std::string plain = MachineMark(folder_);
  EXPECT_THAT(plain, ::testing::MatchesRegex("[0-9a-f]{16}"));
  EXPECT_EQ(MachineMark(folder_), plain);
  std::ofstream(folder_ / "class/dmi/id/product_uuid") << "4c4c4544-0044-4810-8031-b4c04f4d3332\n";
  EXPECT_NE(MachineMark(folder_), plain);
  std::ofstream(folder_ / "class/dmi/id/product_uuid") << "4c4c4544-0044-4810-8031-b4c04f4d3333\n";
  EXPECT_NE(MachineMark(folder_), plain);
}

TEST(BoxName, IsAsTheSettingsSayOrTellsBoxesApartByTheirNumbers) {
  const std::string number = "1a2b3c4d5e6f40112233445566778899";
  EXPECT_EQ(NameOfBox("left-lobby", number), "left-lobby");
  EXPECT_EQ(NameOfBox("", number), "kaori-1a2b3c4d");
  EXPECT_EQ(NameOfBox("", ""), "kaori");
}

}  // namespace
}  // namespace kaori::boot
