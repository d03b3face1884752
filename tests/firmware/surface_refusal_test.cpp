// A surface on a chip that is too old: what it says, and that it does nothing else.
#include <gtest/gtest.h>

#include <string>

#include "firmware/board/rp2040/stepping.h"
#include "firmware/surface/refusal.h"
#include "firmware/surface/usb_device.h"
#include "firmware/wire/dial_box.h"
#include "tests/firmware/proof/usb_host.h"

namespace kaori::surface {
namespace {

using proof::Packet;
using wire::ChipStepping;

class SurfaceRefusal : public ::testing::Test {
 protected:
  SurfaceRefusal() { host.Enumerate(); }
  ~SurfaceRefusal() override { EXPECT_EQ(cable.broken, ""); }
  bool Takes(wire::SurfaceOperation operation) {
    const auto bytes = wire::Encode(wire::SurfaceCommand{.operation = operation, .number = 1, .data = {}});
    return host.Control({0x21, 9, 0x0300, 0, 64}, {bytes.begin(), bytes.end()}).has_value();
  }

  Refusal refusal{{.major = 1, .minor = 2, .hardware = 1, .stepping = ChipStepping::kB1}};
  proof::Cable cable;
  UsbDevice device{RefusedIdentity({.vendor = wire::kDialBoxVendor,
                                    .product = wire::kDialBoxProduct,
                                    .name = "Dial and button box",
                                    .report_descriptor = wire::kDialBoxDescriptor,
                                    .takes_output = true}),
                   refusal, cable};
  proof::UsbHost host{device, cable};
};

TEST(ChipStepping, IsToldByTheChipsNumberAndItsRom) {
  using rp2040::SteppingOf;
  EXPECT_EQ(SteppingOf(0x10002927, 1), ChipStepping::kB0);
  EXPECT_EQ(SteppingOf(0x10002927, 2), ChipStepping::kB1);
  EXPECT_EQ(SteppingOf(0x20002927, 3), ChipStepping::kB2);
  EXPECT_EQ(SteppingOf(0x30002927, 4), ChipStepping::kB2) << "a later one";
  EXPECT_FALSE(rp2040::IsFit(ChipStepping::kB0));
  EXPECT_FALSE(rp2040::IsFit(ChipStepping::kB1));
  EXPECT_TRUE(rp2040::IsFit(ChipStepping::kB2));
}

TEST_F(SurfaceRefusal, SaysSoByItsNameAndIsNoPlayersDevice) {
  const auto name = host.Control({0x80, 6, 0x0302, 0x0409, 255});
  ASSERT_TRUE(name);
  std::string text;
  for (std::size_t n = 2; n < name->size(); n += 2) text += static_cast<char>((*name)[n]);
  EXPECT_EQ(text, "RP2040 older than B2: refused");
  EXPECT_EQ(host.Control({0x81, 6, 0x2200, 0, 255}),
            (Packet{wire::kRefusalDescriptor.begin(), wire::kRefusalDescriptor.end()}));
  EXPECT_EQ((*host.Control({0x80, 6, 0x0200, 0, 255}))[13], 1) << "there is no OUT endpoint";
  EXPECT_EQ((*host.Control({0x80, 6, 0x0100, 0, 18}))[10], 1) << "the product stays, for kaori-surface";
}

TEST_F(SurfaceRefusal, SaysSoInItsFeatureReport) {
  const auto report = host.Control({0xA1, 1, 0x0300, 0, 64});
  ASSERT_TRUE(report);
  const auto status = wire::DecodeSurfaceStatus(std::span(*report).first<wire::kSurfaceFeatureBytes>());
  EXPECT_EQ(status.state, wire::SurfaceState::kRefuses);
  EXPECT_EQ(status.stepping, ChipStepping::kB1);
  EXPECT_EQ(status.firmware_minor, 2);
  EXPECT_EQ(host.Control({0xA1, 1, 0x0100, 0, 20}), std::nullopt) << "there is no input report";
}

TEST_F(SurfaceRefusal, BlinksTheOddAndTheEvenLampsInTurn) {
  for (std::uint32_t tick = 0; tick < 2 * Refusal::kTicksPerSecond; ++tick) {
    const bool is_odd = tick / (Refusal::kTicksPerSecond / 2) % 2 == 0;
    ASSERT_EQ(refusal.Tick(), is_odd ? 0x55555555U : 0xAAAAAAAAU) << "tick " << tick;
  }
  EXPECT_TRUE(Takes(wire::SurfaceOperation::kLampTest));
  EXPECT_EQ(refusal.Tick(), 0xFFFFFFFFU);
}

TEST_F(SurfaceRefusal, TakesNoUpdateAndNoConfirmationButARestart) {
  for (const auto operation : {wire::SurfaceOperation::kBegin, wire::SurfaceOperation::kKeep,
                               wire::SurfaceOperation::kCalibrate, wire::SurfaceOperation::kData})
    EXPECT_FALSE(Takes(operation));
  EXPECT_FALSE(refusal.wants_restart());
  EXPECT_TRUE(Takes(wire::SurfaceOperation::kRestart));
  EXPECT_TRUE(refusal.wants_restart());
  EXPECT_EQ(host.Poll(), std::nullopt);
}

}  // namespace
}  // namespace kaori::surface
