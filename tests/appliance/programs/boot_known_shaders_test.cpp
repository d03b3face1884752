// What Mesa is told about shaders that it has.
#include "appliance/programs/boot/known_shaders.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace kaori::boot {
namespace {

const std::string kName = "0201" + std::string(36, 'a');

class KnownShaders : public ::testing::Test {
 protected:
  KnownShaders() {
    std::filesystem::remove_all(root_);
    std::filesystem::create_directories(root_);
  }

  bool Tell(const std::string& list) {
    std::ofstream(root_ / "list") << list;
    return TellKnownShaders(root_ / "list", root_);
  }
  std::string Index() const {
    std::ifstream file(root_ / "mesa/llvmpipe/index", std::ios::binary);
    return {std::istreambuf_iterator(file), {}};
  }

  std::filesystem::path root_ =
      std::filesystem::path(::testing::TempDir()) / ("known-shaders-" + std::to_string(::getpid()));
};

TEST_F(KnownShaders, StandInThePlacesThatTheirFirstBytesSay) {
  ASSERT_TRUE(Tell("mesa/llvmpipe\n" + kName + "\n"));
  const std::string index = Index();
  ASSERT_EQ(index.size(), 8U + 65536 * 20);
  const std::size_t place = 8 + 0x0102 * 20;
  EXPECT_EQ(index.substr(place, 3), "\x02\x01\xAA");
  EXPECT_EQ(index.find_first_not_of('\0'), place);
  EXPECT_EQ(index.find_last_not_of('\0'), place + 19);
}

TEST_F(KnownShaders, AreNotToldFromATornList) {
  for (const std::string torn : {"", "mesa\n02", "mesa\nzz01", "../mesa\n", "/mesa\n"})
    EXPECT_FALSE(Tell(torn)) << torn;
}

TEST_F(KnownShaders, AreNoneWithoutAList) {
  EXPECT_TRUE(TellKnownShaders(root_ / "none", root_));
  EXPECT_TRUE(std::filesystem::is_empty(root_));
}

}  // namespace
}  // namespace kaori::boot
