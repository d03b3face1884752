// HID devices of the rig, through real sockets: what the driver reads is what left the device.
#include <algorithm>
#include <random>

#include "tests/hw-sim/link_fixture.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

using LinkHid = LinkFixture;

TEST_F(LinkHid, ListsWhatIsPluggedInOnceItHasSaidHello) {
  EXPECT_EQ(bus->Ports()->size(), 0u);  // Called, and not yet answered.
  rig->Pump();
  EXPECT_EQ(*bus->Ports(),
            (std::vector<std::string>{"dial-box", "keyboard", "pointer", "stick-left", "stick-right"}));
}

TEST_F(LinkHid, SaysWhoItIs) {
  const auto channel = Channel("stick-right");
  ASSERT_NE(channel, nullptr);
  const auto& identity = channel->identity();
  EXPECT_EQ(identity.port, "stick-right");
  EXPECT_EQ(identity.vendor, wire::kStickPodVendor);
  EXPECT_EQ(identity.product, wire::kStickPodProduct);
  EXPECT_EQ(identity.name, "Kaori stick pod");
  EXPECT_TRUE(std::ranges::equal(identity.descriptor, wire::kStickPodDescriptor));
}

TEST_F(LinkHid, AReportArrivesWithItsBytesAndItsTime) {
  const auto channel = Channel("dial-box");
  ASSERT_NE(channel, nullptr);
  Step(5ms);
  rig->dial_box().Turn(0, 0.5);
  rig->dial_box().Push(8);
  Step(0ms);
  wire::DialBoxReport expected{1u << 8, {}};
  expected.turned[0] = 128;
  const auto bytes = wire::Encode(expected);
  const auto reports = ReadAll(*channel);
  ASSERT_EQ(reports.size(), 1u);
  EXPECT_EQ(reports[0], (StampedReport{clock.now(), {bytes.begin(), bytes.end()}}));
}

TEST_F(LinkHid, LampsArriveAtTheBox) {
  const auto channel = Channel("dial-box");
  ASSERT_NE(channel, nullptr);
  ASSERT_TRUE(channel->Write(std::array<std::uint8_t, 5>{0, 0x0F, 0, 0, 0x80}));
  rig->Pump();
  EXPECT_EQ(rig->dial_box().lamps(), 0x8000000Fu);
  EXPECT_EQ(channel->Write({}).error().cause, std::errc::invalid_argument);
}

TEST_F(LinkHid, AnUnpluggedDeviceIsGoneForItsChannelAndForTheBus) {
  const auto channel = Channel("stick-left");
  ASSERT_NE(channel, nullptr);
  ASSERT_TRUE(rig->Unplug("stick-left"));
  std::array<std::uint8_t, 64> buffer;
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::no_such_device);
  EXPECT_EQ(channel->Write(std::array<std::uint8_t, 2>{}).error().cause, std::errc::no_such_device);
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::no_such_device);
  const auto ports = bus->Ports();
  EXPECT_EQ(std::ranges::count(*ports, "stick-left"), 0);
  EXPECT_EQ(bus->Open("stick-left").error().cause, std::errc::no_such_device);
}

TEST_F(LinkHid, ADeviceThatVanishesInAReportComesBackWhole) {
  auto channel = Channel("dial-box");
  ASSERT_NE(channel, nullptr);
  ASSERT_TRUE(rig->VanishInReport("dial-box", 7));
  std::array<std::uint8_t, 64> buffer;
  const auto torn = channel->Read(buffer);
  ASSERT_TRUE(torn);
  EXPECT_EQ(torn->bytes, 7u);
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::no_such_device);
  ASSERT_TRUE(rig->Plug("dial-box"));
  channel = Channel("dial-box");
  ASSERT_NE(channel, nullptr);
  rig->dial_box().Turn(3, 1);
  rig->Pump();
  EXPECT_EQ(ReadAll(*channel).size(), 1u);
}

TEST_F(LinkHid, FaultsAreSentAsTheyAre) {
  const auto channel = Channel("keyboard");
  ASSERT_NE(channel, nullptr);
  const std::array<std::uint8_t, 3> junk{1, 2, 3};
  ASSERT_TRUE(rig->SendRaw("keyboard", junk));
  ASSERT_TRUE(rig->SendTorn("keyboard", 5));
  ASSERT_TRUE(rig->SendRaw("keyboard", {}));
  const auto reports = ReadAll(*channel);
  ASSERT_EQ(reports.size(), 3u);
  EXPECT_EQ(reports[0].bytes, (std::vector<std::uint8_t>{1, 2, 3}));
  EXPECT_EQ(reports[1].bytes.size(), 5u);
  EXPECT_TRUE(reports[2].bytes.empty());
  EXPECT_EQ(rig->SendRaw("camera", junk).error().cause, std::errc::invalid_argument);
  ASSERT_TRUE(rig->Unplug("stick-left"));
  EXPECT_EQ(rig->SendRaw("stick-left", {}).error().cause, std::errc::not_connected);
}

TEST_F(LinkHid, AReportLongerThanTheBufferIsCutOff) {
  const auto channel = Channel("keyboard");
  ASSERT_NE(channel, nullptr);
  ASSERT_TRUE(rig->SendRaw("keyboard", std::vector<std::uint8_t>(200, 7)));
  std::array<std::uint8_t, 64> buffer;
  EXPECT_EQ(channel->Read(buffer)->bytes, 64u);
}

TEST_F(LinkHid, ASlowReaderLosesNothing) {
  const auto channel = Channel("dial-box");
  ASSERT_NE(channel, nullptr);
  constexpr int kTurns = 5000;  // Far more than a socket holds.
  std::int64_t counts = 0;
  const auto count = [&] {
    for (const auto& report : ReadAll(*channel))
      counts += wire::DecodeDialBox(std::span<const std::uint8_t, wire::kDialBoxReportBytes>(report.bytes))
                    .turned[0];
  };
  for (int n = 0; n < kTurns; ++n) {
    rig->dial_box().Turn(0, 1.0 / 256);
    Step(1ms);
  }
  for (int n = 0; n < kTurns && counts < kTurns; ++n) {
    count();
    Step(1ms);
  }
  EXPECT_EQ(counts, kTurns);
}

TEST_F(LinkHid, ANewerDriverReplacesTheOlder) {
  const auto older = Channel("dial-box");
  auto second_bus = hid::LocalHidBus::Watch(folder.path());
  rig->Pump();
  ASSERT_TRUE((*second_bus)->Ports());
  const auto newer = (*second_bus)->Open("dial-box");
  ASSERT_TRUE(newer);
  rig->dial_box().Turn(0, 1);
  rig->Pump();
  EXPECT_EQ(ReadAll(**newer).size(), 1u);
  std::array<std::uint8_t, 64> buffer;
  EXPECT_EQ(older->Read(buffer).error().cause, std::errc::no_such_device);
}

TEST_F(LinkHid, ADriverThatComesBackIsToldWhatIsHeld) {
  auto channel = Channel("stick-left");
  rig->left_stick().Move(0.5F, 0);
  rig->Pump();
  channel.reset();
  rig->Pump();
  EXPECT_FALSE(rig->connected("stick-left"));
  EXPECT_EQ(bus->Open("stick-left").error().cause, std::errc::device_or_resource_busy);
  rig->Pump();
  auto again = bus->Open("stick-left");
  ASSERT_TRUE(again) << again.error().message();
  Step(1ms);
  EXPECT_EQ(ReadAll(**again).size(), 1u);
}

TEST_F(LinkHid, SurvivesTwoHundredCablesPulledAtRandom) {
  std::mt19937 random(1993);
  const std::array<std::string, 4> names{"dial-box", "stick-left", "stick-right", "keyboard"};
  const int before = OpenDescriptors();
  for (int n = 0; n < 200; ++n) {
    const std::string& name = names[random() % names.size()];
    ASSERT_TRUE(rig->plugged(name) ? rig->Unplug(name) : rig->Plug(name));
    if (random() % 3 != 0) rig->Pump();
    if (random() % 3 != 0) {
      ASSERT_TRUE(bus->Ports());
    }
    const auto channel = random() % 2 == 0 ? bus->Open(name) : Result<std::unique_ptr<ports::HidChannel>>{};
    clock.Advance(1ms);
  }
  for (const std::string& name : names) ASSERT_TRUE(rig->Plug(name));
  for (const std::string& name : names) {
    auto channel = Channel(name);
    if (!channel) channel = Channel(name);  // One that was opened and dropped is called again.
    ASSERT_NE(channel, nullptr) << name;
    rig->dial_box().Turn(0, 1);
    rig->keyboard().Press(4);
    rig->left_stick().Twist(rig->left_stick().twist() + 0.25F);
    rig->right_stick().Twist(rig->right_stick().twist() + 0.25F);
    Step(2ms);
    EXPECT_GE(ReadAll(*channel).size(), 1u) << name;
    rig->keyboard().Release(4);
  }
  for (const std::string& name : names) ASSERT_TRUE(rig->Unplug(name));
  ASSERT_TRUE(bus->Ports());
  for (const std::string& name : names) ASSERT_TRUE(rig->Plug(name));
  rig->Pump();
  EXPECT_LE(OpenDescriptors(), before + 4);  // The bus holds one greeted call for each device.
}

TEST_F(LinkHid, ARestartedSimulatorIsFoundAgain) {
  auto channel = Channel("dial-box");
  rig.reset();
  std::array<std::uint8_t, 64> buffer;
  EXPECT_EQ(channel->Read(buffer).error().cause, std::errc::no_such_device);
  EXPECT_TRUE(bus->Ports()->empty());
  rig = *Rig::Open({.folder = folder.path()}, clock);
  channel = Channel("dial-box");
  EXPECT_NE(channel, nullptr);
}

TEST_F(LinkHid, AFolderThatVanishedIsFoundAgain) {
  rig.reset();
  std::filesystem::remove_all(folder.path());
  EXPECT_TRUE(bus->Ports()->empty());
  rig = *Rig::Open({.folder = folder.path()}, clock);
  EXPECT_NE(Channel("dial-box"), nullptr);
}

TEST_F(LinkHid, TwoSimulatorsDoNotShareAFolder) {
  const auto second = Rig::Open({.folder = folder.path()}, clock);
  ASSERT_FALSE(second);
  EXPECT_EQ(second.error().cause, std::errc::device_or_resource_busy);
}

TEST_F(LinkHid, NamesThatAreNoPortAreRefused) {
  EXPECT_EQ(rig->Plug("stick-middle").error().cause, std::errc::invalid_argument);
  EXPECT_EQ(rig->Unplug("").error().cause, std::errc::invalid_argument);
}

}  // namespace
}  // namespace kaori::sim
