// The box's address in a network: what the settings may say, which socket gets it, and whom the desk may talk to.
#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "appliance/programs/boot/network.h"
#include "appliance/programs/boot/profile.h"
#include "drivers/base/read_file.h"

namespace kaori::boot {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

std::string FaultOf(const std::string& value) {
  std::optional<NetworkAddress> address;
  std::string fault = ParseNetwork("address", value, address);
  EXPECT_EQ(address.has_value(), fault.empty()) << value;
  return fault;
}

TEST(Network, IsNoneUnlessTheSettingsNameAnAddress) {
  EXPECT_FALSE(ReadProfile("profile = \"stage\"\n").network);
  const auto profile = ReadProfile("[network]\naddress = \"10.101.90.20/24\"  # of the house\n");
  EXPECT_THAT(profile.fault, IsEmpty());
  EXPECT_EQ(profile.network, (NetworkAddress{0x0A655A14, 24}));
}

TEST(Network, OfAnAddressThatNoHostHasIsRefusedInWords) {
  for (const char* good :
       {"\"10.0.0.1/8\"", "\"192.168.1.254/24\"", "\"172.16.0.1/30\"", "\"169.254.3.4/16\""})
    EXPECT_EQ(FaultOf(good), "") << good;
  for (const char* odd :
       {"10.0.0.1/8", "\"10.0.0.1\"", "\"10.0.0/8\"", "\"10.0.0.1.2/8\"", "\"10.0.0.256/8\"",
        "\"10.0.0.01/8\"", "\"10.0.0.-1/8\"", "\"fe80::1/64\"", "\"dhcp\"", "\"\"", "\""})
    EXPECT_THAT(FaultOf(odd), HasSubstr("expected an address")) << odd;
  EXPECT_THAT(FaultOf("\"10.0.0.1/31\""), HasSubstr("8 to 30"));
  EXPECT_THAT(FaultOf("\"10.0.0.1/7\""), HasSubstr("8 to 30"));
  for (const char* nobody : {"\"10.1.1.0/24\"", "\"10.1.1.255/24\"", "\"127.0.0.1/8\"", "\"0.1.2.3/8\"",
                             "\"224.0.0.5/24\"", "\"255.255.255.254/24\""})
    EXPECT_THAT(FaultOf(nobody), HasSubstr("no address that a box can have")) << nobody;
}

TEST(Network, OfAFaultySettingIsNamedWithItsLineAndIsNone) {
  const auto profile = ReadProfile("[network]\nadress = \"10.0.0.1/8\"\n");
  EXPECT_EQ(profile.fault, "line 2: there is no setting adress of [network]");
  EXPECT_FALSE(profile.network);
}

TEST(Network, IsNamedByItsLowestAddress) {
  EXPECT_EQ(NetworkOf({0x0A655A14, 24}), "10.101.90.0/24");
  EXPECT_EQ(NetworkOf({0x0A655A14, 30}), "10.101.90.20/30");
  EXPECT_EQ(NetworkOf({0x0AFFFFFE, 8}), "10.0.0.0/8");
}

// /sys/class/net as the kernel lays it out.
class NetworkSockets : public ::testing::Test {
 protected:
  ~NetworkSockets() override { fs::remove_all(folder_); }
  void Add(const std::string& name, const std::string& bus, const std::string& type = "1") const {
    const fs::path device = folder_ / "devices" / name;
    fs::create_directories(device);
    fs::create_directories(folder_ / "bus" / bus);
    fs::create_directories(folder_ / "net" / name);
    std::ofstream(folder_ / "net" / name / "type") << type << "\n";
    if (bus.empty()) return;  // Not of a device: lo, a bridge.
    fs::create_directory_symlink(folder_ / "bus" / bus, device / "subsystem");
    fs::create_directory_symlink(device, folder_ / "net" / name / "device");
  }
  const fs::path folder_ = fs::temp_directory_path() / ("network-test-" + std::to_string(::getpid()));
};

TEST_F(NetworkSockets, GiveTheFirstCardThatIsNoUsbDevice) {
  Add("lo", "", "772");
  EXPECT_EQ(NetworkSocket(folder_ / "net").error().cause, std::errc::no_such_device);
  Add("eth0", "usb");
  Add("eth10", "pci");
  Add("wlan0", "pci", "801");
  EXPECT_EQ(NetworkSocket(folder_ / "net").value(), "eth10");
  Add("eth2", "virtio");
  EXPECT_EQ(NetworkSocket(folder_ / "net").value(), "eth2");
}

TEST_F(NetworkSockets, WithoutAFolderAreNone) {
  EXPECT_FALSE(NetworkSocket(folder_ / "nothing"));
}

TEST_F(NetworkSockets, LetTheDeskTalkToItsOwnNetworkAlone) {
  ASSERT_TRUE(LimitDesk({0x0A655A14, 24}, folder_ / "units"));
  EXPECT_EQ(ReadFile(folder_ / "units/kaori-desk.service.d/network.conf").value(),
            "[Service]\nIPAddressAllow=10.101.90.0/24\n");
}

}  // namespace
}  // namespace kaori::boot
