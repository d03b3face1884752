// What a PC's graphics lack is said from the kernel's own lines, and from what it has a driver for.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "appliance/programs/boot/graphics_fault.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(WantedFirmware, IsWhatADriverCannotDrawWithout) {
  EXPECT_THAT(
      WantedFirmware(
          "<6>[    1.2] amdgpu 0000:03:00.0: amdgpu: Fetched VBIOS from VFCT\n"
          "<4>[    1.3] amdgpu 0000:03:00.0: Direct firmware load for amdgpu/polaris10_mc.bin failed "
          "with error -2\n"
          "<4>[    1.3] amdgpu 0000:03:00.0: Direct firmware load for amdgpu/polaris10_mc.bin failed "
          "with error -2\n"
          "<3>[    1.4] i915 0000:00:02.0: [drm] *ERROR* GT0: GuC firmware i915/adlp_guc_70.bin: fetch "
          "failed -ENOENT"),
      ElementsAre("amdgpu/polaris10_mc.bin", "i915/adlp_guc_70.bin"));
}

TEST(WantedFirmware, IsNothingThatOnlySavesPowerPlaysFilmsOrIsNoGraphics) {
  EXPECT_THAT(WantedFirmware("Direct firmware load for i915/kbl_dmc_ver1_04.bin failed with error -2\n"
                             "HuC firmware i915/tgl_huc.bin: fetch failed -ENOENT\n"
                             "Direct firmware load for rtl_nic/rtl8168g-2.fw failed with error -2\n"
                             "Direct firmware load for amdgpu/cut"),
              IsEmpty());
  EXPECT_THAT(WantedFirmware(""), IsEmpty());
}

class Cards : public ::testing::Test {
 protected:
  Cards() : folder_(fs::path(::testing::TempDir()) / ("cards-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
  }
  ~Cards() override { fs::remove_all(folder_); }

  void Add(const std::string& place, const std::string& kind, bool driven) {
    fs::create_directories(folder_ / place);
    std::ofstream(folder_ / place / "class") << kind << "\n";
    std::ofstream(folder_ / place / "vendor") << "0x1002\n";
    std::ofstream(folder_ / place / "device") << "0x67df\n";
    if (driven) fs::create_directories(folder_ / place / "driver");
  }
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_;
};

TEST_F(Cards, WithoutADriverAreNamedByTheirNumbers) {
  Add("0000:00:1f.2", "0x010601", false);
  Add("0000:03:00.0", "0x030000", false);
  EXPECT_THAT(UndrivenCards(folder()), ElementsAre("1002:67df"));
}

TEST_F(Cards, BesideOneThatDrawsAreNobodysConcern) {
  Add("0000:00:02.0", "0x030000", true);
  Add("0000:03:00.0", "0x030200", false);
  EXPECT_THAT(UndrivenCards(folder()), IsEmpty());
}

TEST(GraphicsFaults, NameTheFileRatherThanTheCardThatWantsIt) {
  EXPECT_THAT(
      GraphicsFaults({"1002:67df"}, {"amdgpu/polaris10_mc.bin"}),
      ElementsAre("the graphics card wants the file amdgpu/polaris10_mc.bin, which is not in the image: the "
                  "processor draws instead"));
  EXPECT_THAT(
      GraphicsFaults({"1002:67df"}, {}),
      ElementsAre("the graphics card 1002:67df has no driver in the image: the processor draws instead"));
  EXPECT_THAT(GraphicsFaults({}, {}), IsEmpty());
}

}  // namespace
}  // namespace kaori::boot
