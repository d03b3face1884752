// The cable to a virtual machine, with a machine at its other end that speaks the same protocol by its own
// library.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/epoll.h>
#include <unistd.h>

#include <filesystem>

#include "firmware/wire/dial_box.h"
#include "firmware/wire/stick_pod.h"
#include "hw-sim/devices/misleading_descriptors.h"
#include "hw-sim/devices/unknown_device.h"
#include "hw-sim/links/usbredir/usb_rig.h"
#include "tests/hw-sim/usb_machine.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;
using ::testing::ElementsAre;

class UsbLink : public ::testing::Test {
 protected:
  UsbLink() : folder_(::testing::TempDir() + "usb-link-" + std::to_string(::getpid())) {
    std::filesystem::create_directories(folder_);
    rig_ = std::move(*UsbRig::Open(folder_, clock_));
  }
  ~UsbLink() override { std::filesystem::remove_all(folder_); }

  std::string Path(std::string_view name) const { return UsbSocketPath(folder_, name); }

  // Both ends, until all that was said is answered; no time goes by.
  void Talk(UsbMachine& machine) {
    for (int n = 0; n < 8; ++n) {
      rig_->Pump();
      machine.Step();
    }
  }
  void Later(Duration by, UsbMachine& machine) {
    clock_.Advance(by);
    Talk(machine);
  }
  // Plugs, and enumerates as far as a program that listens.
  void Enumerate(std::string_view name, UsbMachine& machine) {
    ASSERT_TRUE(rig_->Plug(name));
    Talk(machine);
    machine.Configure(1);
    machine.Listen(UsbHid::kIn);
    Talk(machine);
  }

  ManualClock clock_;
  std::string folder_;
  std::unique_ptr<UsbRig> rig_;
};

TEST_F(UsbLink, SaysWhatADeviceHasBeforeItIsConnected) {
  UsbMachine machine(Path("dial-box"));
  ASSERT_TRUE(rig_->Plug("dial-box"));
  Talk(machine);
  EXPECT_THAT(machine.order, ElementsAre("interfaces", "endpoints", "connect"));
  EXPECT_EQ(machine.device.vendor_id, wire::kDialBoxVendor);
  EXPECT_EQ(machine.device.product_id, wire::kDialBoxProduct);
  EXPECT_EQ(machine.device.speed, usb_redir_speed_high);
  EXPECT_EQ(machine.interfaces.interface_count, 1U);
  EXPECT_EQ(machine.interfaces.interface_class[0], 3);
  EXPECT_EQ(machine.endpoints.type[0x10 | 1], usb_redir_type_interrupt);
  EXPECT_EQ(machine.endpoints.interval[0x10 | 1], 1);
  EXPECT_EQ(machine.endpoints.max_packet_size[0x10 | 1], 64);
  EXPECT_EQ(machine.endpoints.type[1], usb_redir_type_interrupt) << "lamps go out";
  EXPECT_EQ(machine.endpoints.type[2], usb_redir_type_invalid);
}

// The protocol's table has 32 places, and the descriptors of this device 81.
TEST_F(UsbLink, SaysOfManySettingsTheFirstOfEachInterface) {
  UnknownDevice device(0x1209, 1, StorageBehindManySettings());
  ASSERT_TRUE(rig_->Hold("pointer", &device));
  UsbMachine machine(Path("pointer"));
  ASSERT_TRUE(rig_->Plug("pointer"));
  Talk(machine);
  EXPECT_THAT(machine.order, ElementsAre("interfaces", "endpoints", "connect"));
  EXPECT_EQ(machine.interfaces.interface_count, 2U);
  EXPECT_EQ(machine.interfaces.interface_class[0], 1);
  EXPECT_EQ(machine.interfaces.interface_class[1], 8);
  static_cast<void>(rig_->Unplug("pointer"));
  static_cast<void>(rig_->Hold("pointer", nullptr));
}

TEST_F(UsbLink, SaysItAllAgainBeforeAConfigurationIsSet) {
  UsbMachine machine(Path("stick-left"));
  ASSERT_TRUE(rig_->Plug("stick-left"));
  Talk(machine);
  machine.order.clear();
  machine.Configure(1);
  Talk(machine);
  EXPECT_THAT(machine.order, ElementsAre("interfaces", "endpoints"));
  EXPECT_EQ(machine.configuration_status, usb_redir_success);
  EXPECT_TRUE(rig_->port("stick-left")->configured());
}

TEST_F(UsbLink, CallsUntilAMachineIsThere) {
  ASSERT_TRUE(rig_->Plug("keyboard"));
  rig_->Pump();
  EXPECT_FALSE(rig_->port("keyboard")->connected());
  UsbMachine machine(Path("keyboard"));
  Later(100ms, machine);
  EXPECT_TRUE(machine.called());
  EXPECT_THAT(machine.order, ElementsAre("interfaces", "endpoints", "connect"));
}

TEST_F(UsbLink, ComesBackToAMachineThatWasAway) {
  UsbMachine machine(Path("dial-box"));
  Enumerate("dial-box", machine);
  machine.HangUp();
  machine.order.clear();
  rig_->Pump();
  EXPECT_FALSE(rig_->port("dial-box")->listened());
  Later(100ms, machine);
  EXPECT_THAT(machine.order, ElementsAre("interfaces", "endpoints", "connect"));
}

TEST_F(UsbLink, GivesTheReportDescriptorThatTheFirmwareHas) {
  UsbMachine machine(Path("stick-right"));
  ASSERT_TRUE(rig_->Plug("stick-right"));
  Talk(machine);
  const auto id = machine.Ask({0x81, 0x06, 0x2200, 0, 512});
  Talk(machine);
  const auto& answer = machine.answers.at(id);
  EXPECT_EQ(answer.status, usb_redir_success);
  EXPECT_EQ(answer.length, wire::kStickPodDescriptor.size());
  EXPECT_THAT(answer.data, ::testing::ElementsAreArray(wire::kStickPodDescriptor));
}

TEST_F(UsbLink, CutsAnAnswerToWhatWasAskedFor) {
  UsbMachine machine(Path("dial-box"));
  ASSERT_TRUE(rig_->Plug("dial-box"));
  Talk(machine);
  const auto id = machine.Ask({0x80, 0x06, 0x0100, 0, 8});
  Talk(machine);
  EXPECT_EQ(machine.answers.at(id).data.size(), 8U);
}

TEST_F(UsbLink, StallsWhatNobodyKnows) {
  UsbMachine machine(Path("dial-box"));
  ASSERT_TRUE(rig_->Plug("dial-box"));
  Talk(machine);
  const auto qualifier = machine.Ask({0x80, 0x06, 0x0600, 0, 10});
  const auto vendor = machine.Ask({0xC0, 0x51, 0, 0, 4});
  Talk(machine);
  EXPECT_EQ(machine.answers.at(qualifier).status, usb_redir_stall);
  EXPECT_EQ(machine.answers.at(vendor).status, usb_redir_stall);
}

TEST_F(UsbLink, SendsReportsToWhoListensAndToNobodyElse) {
  UsbMachine machine(Path("stick-left"));
  Enumerate("stick-left", machine);
  rig_->devices().left_stick.Move(0.5F, 0);
  Later(1ms, machine);
  ASSERT_EQ(machine.reports.size(), 1U);
  machine.StopListening(UsbHid::kIn);
  Talk(machine);
  rig_->devices().left_stick.Move(0.7F, 0);
  Later(10ms, machine);
  EXPECT_EQ(machine.reports.size(), 1U);
}

TEST_F(UsbLink, TellsANewHostOnceWhatIsNotAtRest) {
  UsbMachine machine(Path("stick-left"));
  rig_->devices().left_stick.Move(0.5F, 0);
  Enumerate("stick-left", machine);
  Later(1ms, machine);
  ASSERT_EQ(machine.reports.size(), 1U);
  Later(1s, machine);
  EXPECT_EQ(machine.reports.size(), 1U) << "whoever missed it must ask";
}

TEST_F(UsbLink, SaysNothingOfADeviceAtRest) {
  UsbMachine machine(Path("stick-left"));
  Enumerate("stick-left", machine);
  Later(1s, machine);
  EXPECT_TRUE(machine.reports.empty());
}

TEST_F(UsbLink, LightsTheLampsThatTheMachineSends) {
  UsbMachine machine(Path("dial-box"));
  Enumerate("dial-box", machine);
  const auto id = machine.SendInterrupt(UsbHid::kOut, {0x05, 0, 0, 0x80});
  Talk(machine);
  EXPECT_EQ(rig_->devices().dial_box.lamps(), 0x80000005U);
  EXPECT_THAT(machine.interrupts_done, ElementsAre(id));
}

TEST_F(UsbLink, LightsTheLampsOfAControlTransferToo) {
  UsbMachine machine(Path("dial-box"));
  Enumerate("dial-box", machine);
  const auto id = machine.Ask({0x21, 0x09, 0x0200, 0, 4}, {1, 2, 0, 0});
  Talk(machine);
  EXPECT_EQ(machine.answers.at(id).status, usb_redir_success);
  EXPECT_EQ(rig_->devices().dial_box.lamps(), 0x0201U);
}

TEST_F(UsbLink, IsPulledAndPluggedByTheTestAndStartsDark) {
  UsbMachine machine(Path("dial-box"));
  Enumerate("dial-box", machine);
  machine.SendInterrupt(UsbHid::kOut, {0xFF, 0, 0, 0});
  Talk(machine);
  ASSERT_TRUE(rig_->Unplug("dial-box"));
  Talk(machine);
  EXPECT_EQ(machine.order.back(), "disconnect");
  EXPECT_EQ(rig_->devices().dial_box.lamps(), 0U);
  ASSERT_TRUE(rig_->Plug("dial-box"));
  Talk(machine);
  EXPECT_EQ(machine.order.back(), "connect");
  EXPECT_TRUE(rig_->port("dial-box")->connected());
  EXPECT_FALSE(rig_->port("dial-box")->configured());
}

TEST_F(UsbLink, AnswersNothingForADeviceThatIsOut) {
  UsbMachine machine(Path("dial-box"));
  Enumerate("dial-box", machine);
  ASSERT_TRUE(rig_->Unplug("dial-box"));
  const auto id = machine.Ask({0x80, 0x06, 0x0100, 0, 18});
  Talk(machine);
  EXPECT_EQ(machine.answers.at(id).status, usb_redir_stall);
}

TEST_F(UsbLink, CrossesTheSticksForAControlOfTheBench) {
  UsbMachine machine(Path("stick-left"));
  rig_->CrossSticks(true);
  Enumerate("stick-left", machine);
  rig_->devices().right_stick.Move(-1, 0);
  Later(1ms, machine);
  ASSERT_EQ(machine.reports.size(), 1U);
  const std::span<const std::uint8_t, wire::kStickPodReportBytes> report(machine.reports[0]);
  EXPECT_EQ(wire::DecodeStickPod(report).x, -32767);
}

TEST_F(UsbLink, CancelsABulkTransferThatWaits) {
  UsbMachine machine(Path("camera"));
  ASSERT_TRUE(rig_->Plug("camera"));
  rig_->devices().camera.Stall(true);
  Talk(machine);
  machine.Configure(1);
  const auto id = machine.AskBulk(UvcCamera::kIn, 16384);
  Talk(machine);
  EXPECT_TRUE(machine.bulk.empty());
  machine.Cancel(id);
  Talk(machine);
  EXPECT_EQ(machine.bulk_status.at(id), usb_redir_cancelled);
}

TEST_F(UsbLink, FillsBulkTransfersInTheirOrder) {
  UsbMachine machine(Path("camera"));
  ASSERT_TRUE(rig_->Plug("camera"));
  Talk(machine);
  machine.Configure(1);
  Talk(machine);
  std::vector<std::uint64_t> asked;
  for (int n = 0; n < 3; ++n) asked.push_back(machine.AskBulk(UvcCamera::kIn, 16384));
  for (int n = 0; n < 20; ++n) Talk(machine);
  ASSERT_EQ(machine.bulk.size(), 3U);
  for (std::size_t n = 0; n < asked.size(); ++n) EXPECT_EQ(machine.bulk[n].first, asked[n]);
  EXPECT_EQ(machine.bulk[0].second.size(), 16384U);
}

TEST_F(UsbLink, NamesASocketThatIsNotThere) {
  const auto plugged = rig_->Plug("footpedal");
  ASSERT_FALSE(plugged);
  EXPECT_EQ(plugged.error().message(), "no USB socket is called footpedal");
}

}  // namespace
}  // namespace kaori::sim
