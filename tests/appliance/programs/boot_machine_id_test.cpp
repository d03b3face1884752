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
  const auto made = KeptMachineId(file());
  ASSERT_TRUE(made);
  EXPECT_THAT(*made, ::testing::MatchesRegex("[0-9a-f]{12}4[0-9a-f]{3}[89ab][0-9a-f]{15}"));
  EXPECT_EQ(KeptMachineId(file()), *made);
}

TEST_F(MachineId, DiffersFromBoxToBox) {
  EXPECT_NE(KeptMachineId(file()).value(), KeptMachineId(folder_ / "another").value());
}

TEST_F(MachineId, IsTakenAsItIs) {
  const std::string given(32, 'a');
  Write(given + "\n");
  EXPECT_EQ(KeptMachineId(file()), given);
}

TEST_F(MachineId, ThatIsDamagedIsMadeAnew) {
  for (const std::string& damaged :
       {std::string("6b616f72"), std::string(32, '0'), std::string(32, 'A'), std::string(33, 'a'),
        std::string(31, 'a') + "\xFF", std::string(100'000, 'a')}) {
    Write(damaged);
    const auto made = KeptMachineId(file());
    ASSERT_TRUE(made) << damaged.size();
    EXPECT_NE(*made, damaged);
    EXPECT_EQ(KeptMachineId(file()), *made);
    fs::remove(file());
  }
}

TEST_F(MachineId, ThatCannotBeKeptIsAnErrorThatNamesTheFile) {
  const auto made = KeptMachineId(folder_ / "missing" / "machine-id");
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message(), ::testing::HasSubstr("machine-id"));
}

TEST(BoxName, IsAsTheSettingsSayOrTellsBoxesApartByTheirNumbers) {
  const std::string number = "1a2b3c4d5e6f40112233445566778899";
  EXPECT_EQ(NameOfBox("left-lobby", number), "left-lobby");
  EXPECT_EQ(NameOfBox("", number), "kaori-1a2b3c4d");
  EXPECT_EQ(NameOfBox("", ""), "kaori");
}

}  // namespace
}  // namespace kaori::boot
