// The drivers' end of the local link's HID devices against a peer that does everything wrong.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <array>

#include "drivers/base/packet_socket.h"
#include "drivers/hid/local_bus.h"
#include "drivers/hid/local_channel.h"
#include "firmware/wire/link_packets.h"
#include "tests/drivers/liar.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori {
namespace {

using tests::Liar;
using Bytes = std::vector<std::uint8_t>;

Bytes HidHello() {
  const auto head = wire::Encode(wire::HidHello{1, 2, 3, 2});
  Bytes hello(head.begin(), head.end());
  for (const char c : {'b', 'o', 'x', '\x05', '\x01'}) hello.push_back(static_cast<std::uint8_t>(c));
  return hello;
}

TEST(LocalHello, IsReadOnlyWhole) {
  const Bytes hello = HidHello();
  const auto identity = hid::ReadHello("p", hello);
  ASSERT_TRUE(identity);
  EXPECT_EQ(identity->name, "box");
  EXPECT_EQ(identity->descriptor, (Bytes{5, 1}));
  for (std::size_t n = 0; n < hello.size(); ++n)
    EXPECT_FALSE(hid::ReadHello("p", std::span(hello).first(n))) << n;
  Bytes longer = hello;
  longer.push_back(0);
  EXPECT_FALSE(hid::ReadHello("p", longer));
  Bytes other = hello;
  other[0] ^= 1;
  EXPECT_FALSE(hid::ReadHello("p", other));
}

TEST(LocalHidBus, DoesNotListADeviceWithATornHello) {
  const sim::TempFolder folder;
  Liar liar(folder.path() + "/hid.liar");
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  ASSERT_TRUE(liar.Accept());
  const Bytes hello = HidHello();
  liar.Say(std::span(hello).first(9));
  EXPECT_TRUE(bus->Ports()->empty());
  EXPECT_EQ(bus->Open("liar").error().cause, std::errc::no_such_device);
  EXPECT_FALSE(liar.Accept());  // And is not called again and again.
}

TEST(LocalHidBus, ListsADeviceThatIsPluggedInAnewAfterATornHello) {
  const sim::TempFolder folder;
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  {
    Liar liar(folder.path() + "/hid.liar");
    EXPECT_TRUE(bus->Ports()->empty());
    ASSERT_TRUE(liar.Accept());
    liar.HangUp();
    EXPECT_TRUE(bus->Ports()->empty());
  }
  Liar honest(folder.path() + "/hid.liar");
  EXPECT_TRUE(bus->Ports()->empty());
  ASSERT_TRUE(honest.Accept());
  honest.Say(HidHello());
  EXPECT_EQ(bus->Ports()->size(), 1u);
}

TEST(LocalHidBus, IgnoresWhatIsNoSocketAndWhatItsOwnerLeftBehind) {
  const sim::TempFolder folder;
  std::filesystem::create_directory(folder.path() + "/hid.folder");
  { Liar dead(folder.path() + "/hid.dead"); }
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  EXPECT_TRUE(bus->Ports()->empty());
  EXPECT_EQ(bus->Open("dead").error().cause, std::errc::no_such_device);
}

TEST(LocalHidBus, CallsADeviceAgainThatWasTooBusyToAnswer) {
  const sim::TempFolder folder;
  Liar busy(folder.path() + "/hid.busy");
  std::vector<UniqueFd> crowd;
  for (auto one = ConnectToPeer(folder.path() + "/hid.busy"); one;
       one = ConnectToPeer(folder.path() + "/hid.busy"))
    crowd.push_back(std::move(*one));
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  EXPECT_EQ(*bus->Ports(), std::vector<std::string>{"busy"});
  EXPECT_EQ(bus->Open("busy").error().cause, std::errc::device_or_resource_busy);
  while (busy.Accept()) {
  }
  EXPECT_EQ(bus->Open("busy").error().cause, std::errc::device_or_resource_busy);
  ASSERT_TRUE(busy.Accept());
  busy.Say(HidHello());
  EXPECT_EQ(bus->Ports()->size(), 1u);
  EXPECT_TRUE(bus->Open("busy"));
}

TEST(LocalHidBus, LooksForItsFolderUntilItCanBeMadeAgain) {
  const sim::TempFolder parent;
  const std::string folder = parent.path() + "/deep/links";
  const auto bus = *hid::LocalHidBus::Watch(folder);
  std::filesystem::remove_all(parent.path() + "/deep");
  UniqueFd obstacle(::open((parent.path() + "/deep").c_str(), O_CREAT | O_CLOEXEC, 0600));
  for (int n = 0; n < 3; ++n) EXPECT_FALSE(bus->Ports());
  std::filesystem::remove(parent.path() + "/deep");
  ASSERT_TRUE(bus->Ports());
  Liar liar(folder + "/hid.liar");
  ASSERT_TRUE(bus->Ports());
  ASSERT_TRUE(liar.Accept());
  liar.Say(HidHello());
  EXPECT_EQ(bus->Ports()->size(), 1u);
}

TEST(LocalHidChannel, CallsAPacketWithoutAStampAnError) {
  const sim::TempFolder folder;
  Liar liar(folder.path() + "/hid.liar");
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  ASSERT_TRUE(liar.Accept());
  liar.Say(HidHello());
  ASSERT_TRUE(bus->Ports());
  const auto channel = *bus->Open("liar");
  liar.Say(Bytes{1, 2, 3});
  std::array<std::uint8_t, 64> buffer;
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::io_error);
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::resource_unavailable_try_again);
  liar.HangUp();
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::no_such_device);
}

}  // namespace
}  // namespace kaori
