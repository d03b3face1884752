// What the contract of HidChannel leaves to the local link: peers that do everything wrong.
#include <fcntl.h>
#include <gtest/gtest.h>

#include <array>

#include "drivers/base/packet_socket.h"
#include "drivers/hid/local_bus.h"
#include "drivers/hid/local_channel.h"
#include "firmware/wire/link_packets.h"
#include "tests/drivers/link_peer.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori {
namespace {

using tests::LinkPeer;
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
  LinkPeer peer(folder.path() + "/hid.peer");
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  ASSERT_TRUE(peer.Accept());
  const Bytes hello = HidHello();
  peer.Send(std::span(hello).first(9));
  EXPECT_TRUE(bus->Ports()->empty());
  EXPECT_EQ(bus->Open("peer").error().cause, std::errc::no_such_device);
  EXPECT_FALSE(peer.Accept());  // And is not called again and again.
}

TEST(LocalHidBus, ListsADeviceThatIsPluggedInAnewAfterATornHello) {
  const sim::TempFolder folder;
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  {
    LinkPeer peer(folder.path() + "/hid.peer");
    EXPECT_TRUE(bus->Ports()->empty());
    ASSERT_TRUE(peer.Accept());
    peer.HangUp();
    EXPECT_TRUE(bus->Ports()->empty());
  }
  LinkPeer honest(folder.path() + "/hid.peer");
  EXPECT_TRUE(bus->Ports()->empty());
  ASSERT_TRUE(honest.Accept());
  honest.Send(HidHello());
  EXPECT_EQ(bus->Ports()->size(), 1u);
}

TEST(LocalHidBus, IgnoresWhatIsNoSocketAndWhatItsOwnerLeftBehind) {
  const sim::TempFolder folder;
  std::filesystem::create_directory(folder.path() + "/hid.folder");
  { LinkPeer dead(folder.path() + "/hid.dead"); }
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  EXPECT_TRUE(bus->Ports()->empty());
  EXPECT_EQ(bus->Open("dead").error().cause, std::errc::no_such_device);
}

TEST(LocalHidBus, ConnectsAgainToADeviceThatWasTooBusy) {
  const sim::TempFolder folder;
  LinkPeer busy(folder.path() + "/hid.busy");
  std::vector<UniqueFd> connections;
  for (auto one = ConnectToPeer(folder.path() + "/hid.busy"); one;
       one = ConnectToPeer(folder.path() + "/hid.busy"))
    connections.push_back(std::move(*one));
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  EXPECT_EQ(*bus->Ports(), std::vector<std::string>{"busy"});
  EXPECT_EQ(bus->Open("busy").error().cause, std::errc::device_or_resource_busy);
  while (busy.Accept()) {
  }
  EXPECT_EQ(bus->Open("busy").error().cause, std::errc::device_or_resource_busy);
  ASSERT_TRUE(busy.Accept());
  busy.Send(HidHello());
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
  LinkPeer peer(folder + "/hid.peer");
  ASSERT_TRUE(bus->Ports());
  ASSERT_TRUE(peer.Accept());
  peer.Send(HidHello());
  EXPECT_EQ(bus->Ports()->size(), 1u);
}

TEST(LocalHidChannel, CallsAPacketWithoutAStampAnError) {
  const sim::TempFolder folder;
  LinkPeer peer(folder.path() + "/hid.peer");
  const auto bus = *hid::LocalHidBus::Watch(folder.path());
  ASSERT_TRUE(peer.Accept());
  peer.Send(HidHello());
  ASSERT_TRUE(bus->Ports());
  const auto channel = *bus->Open("peer");
  peer.Send(Bytes{1, 2, 3});
  std::array<std::uint8_t, 64> buffer;
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::io_error);
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::resource_unavailable_try_again);
  peer.HangUp();
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::no_such_device);
}

}  // namespace
}  // namespace kaori
