// The USB machine of the control surfaces before a host that asks everything, and much that is wrong.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "firmware/surface/dial_box.h"
#include "firmware/surface/usb_device.h"
#include "firmware/wire/stick_pod.h"
#include "tests/firmware/figures.h"
#include "tests/firmware/proof/ideal_hand.h"
#include "tests/firmware/proof/usb_host.h"

namespace kaori::surface {
namespace {

using proof::Cable;
using proof::Packet;
using proof::UsbHost;

UsbIdentity Identity() {
  return {.vendor = wire::kDialBoxVendor,
          .product = wire::kDialBoxProduct,
          .release_bcd = 0x0102,
          .name = "Dial and button box",
          .report_descriptor = wire::kDialBoxDescriptor,
          .takes_output = true,
          .chip_id = {0x01, 0x23, 0x45, 0x67, 0x89, 0xAB, 0xCD, 0xEF}};
}

class SurfaceUsb : public ::testing::Test {
 protected:
  SurfaceUsb() { host.Enumerate(); }
  ~SurfaceUsb() override {
    EXPECT_EQ(cable.broken, "");
    proof::Figure("usb_requests", host.requests);
  }
  bool Stalls(const proof::Request& request, const Packet& data = {}) {
    return !host.Control(request, data).has_value();
  }

  DialBox box{{.major = 1, .minor = 2, .counts_per_turn = 256, .hardware = 1}, nullptr};
  Cable cable;
  UsbDevice device{Identity(), box, cable};
  UsbHost host{device, cable};
};

TEST_F(SurfaceUsb, SaysWhoItIs) {
  const auto answer = host.Control({0x80, 6, 0x0100, 0, 64});
  ASSERT_TRUE(answer);
  EXPECT_EQ(*answer, (Packet{18, 1, 0, 2, 0, 0, 0, 64, 0x09, 0x12, 1, 0, 0x02, 0x01, 1, 2, 3, 1}));
  EXPECT_EQ(host.Control({0x80, 6, 0x0100, 0, 8})->size(), 8u) << "as hosts ask first";
  EXPECT_EQ(host.Control({0x80, 6, 0x0300, 0, 255}), (Packet{4, 3, 9, 4}));
  const auto serial = host.Control({0x80, 6, 0x0303, 0x0409, 255});
  ASSERT_TRUE(serial);
  std::string text;
  for (std::size_t n = 2; n < serial->size(); n += 2) text += static_cast<char>((*serial)[n]);
  EXPECT_EQ(text, "0123456789ABCDEF");
  EXPECT_EQ(host.Control({0x80, 6, 0x0302, 0x0409, 255})->size(), 2 + 2 * Identity().name.size());
}

TEST_F(SurfaceUsb, ItsConfigurationIsOneThatLinuxReads) {
  const auto answer = host.Control({0x80, 6, 0x0200, 0, 255});
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->size(), 41u);
  EXPECT_EQ((*answer)[2], 41) << "wTotalLength";
  EXPECT_EQ((*answer)[8], 150) << "300 mA";
  EXPECT_EQ(Packet(answer->begin() + 18, answer->begin() + 27),
            (Packet{9, 0x21, 0x11, 0x01, 0, 1, 0x22, wire::kDialBoxDescriptor.size(), 0}));
  EXPECT_EQ(Packet(answer->begin() + 27, answer->end()),
            (Packet{7, 5, 0x81, 3, 64, 0, 1, 7, 5, 0x01, 3, 64, 0, 1}));
  EXPECT_EQ(host.Control({0x80, 6, 0x0200, 0, 9})->size(), 9u);
}

TEST_F(SurfaceUsb, GivesHidsDescriptorsAtTheInterface) {
  const auto report = host.Control({0x81, 6, 0x2200, 0, 1024});
  ASSERT_TRUE(report);
  EXPECT_TRUE(std::ranges::equal(*report, wire::kDialBoxDescriptor));
  EXPECT_EQ(host.Control({0x81, 6, 0x2100, 0, 9})->size(), 9u);
  EXPECT_TRUE(Stalls({0x81, 6, 0x2201, 0, 64})) << "there is one report descriptor";
  EXPECT_TRUE(Stalls({0x80, 6, 0x2200, 0, 64})) << "it is not the device's";
  EXPECT_TRUE(Stalls({0x81, 6, 0x2200, 1, 64})) << "there is one interface";
}

TEST_F(SurfaceUsb, TakesItsAddressAfterTheStatusAndNotBefore) {
  device.HandleReset();
  EXPECT_EQ(cable.address, 0);
  device.HandleSetup(host.Bytes({0x00, 5, 42, 0, 0}));
  EXPECT_EQ(cable.address, 0);
  device.HandleControlSent();
  EXPECT_EQ(cable.address, 42);
}

TEST_F(SurfaceUsb, AnswersEveryRequestOfChapterNine) {
  EXPECT_EQ(host.Control({0x80, 0, 0, 0, 2}), (Packet{0, 0}));     // GET_STATUS of the device,
  EXPECT_EQ(host.Control({0x81, 0, 0, 0, 2}), (Packet{0, 0}));     // the interface,
  EXPECT_EQ(host.Control({0x82, 0, 0, 0x80, 2}), (Packet{0, 0}));  // endpoint 0,
  EXPECT_EQ(host.Control({0x82, 0, 0, 0x81, 2}), (Packet{0, 0}));  // and both others.
  EXPECT_EQ(host.Control({0x82, 0, 0, 0x01, 2}), (Packet{0, 0}));
  EXPECT_EQ(host.Control({0x80, 8, 0, 0, 1}), (Packet{1}));   // GET_CONFIGURATION
  EXPECT_EQ(host.Control({0x81, 10, 0, 0, 1}), (Packet{0}));  // GET_INTERFACE
  EXPECT_TRUE(host.Control({0x01, 11, 0, 0, 0}));             // SET_INTERFACE
  EXPECT_TRUE(host.Control({0x02, 1, 0, 0x80, 0}));           // CLEAR_FEATURE of endpoint 0
  EXPECT_TRUE(host.Control({0x80, 0, 0, 0, 0})) << "no byte is wanted";
  EXPECT_EQ(host.Control({0xA1, 2, 0, 0, 1}), (Packet{0}));  // GET_IDLE
  EXPECT_TRUE(host.Control({0x21, 10, 0, 0, 0}));            // SET_IDLE
}

TEST_F(SurfaceUsb, StallsWhatItDoesNotHave) {
  const std::vector<proof::Request> unknown{
      {0x80, 6, 0x0600, 0, 10},                          // Device qualifier: it has no high speed.
      {0x80, 6, 0x0304, 0, 64},                          // String 4.
      {0x80, 6, 0x0201, 0, 64},                          // A second configuration.
      {0x00, 9, 2, 0, 0},                                // The same, set.
      {0x00, 7, 0x0100, 0, 0},                           // SET_DESCRIPTOR
      {0x00, 3, 1, 0, 0},                                // Remote wakeup.
      {0x00, 3, 2, 0, 0},                                // Test mode.
      {0x00, 5, 128, 0, 0},                              // An address beyond 127.
      {0x01, 11, 1, 0, 0},                               // An alternate setting.
      {0x01, 11, 0, 1, 0},                               // Of another interface.
      {0x02, 3, 0, 0x80, 0},                             // Endpoint 0 cannot be halted.
      {0x02, 3, 0, 0x82, 0},                             // There is no endpoint 2.
      {0x82, 0, 0, 0x02, 2},    {0x82, 12, 0, 0x81, 2},  // SYNCH_FRAME
      {0xA1, 3, 0, 0, 1},                                // GET_PROTOCOL: no boot protocol.
      {0x21, 11, 0, 0, 0},                               // SET_PROTOCOL
      {0x21, 10, 0x0400, 0, 0},                          // Reports each 16 ms.
      {0xA1, 1, 0x0101, 0, 20},                          // Reports have no numbers.
      {0xA1, 1, 0x0400, 0, 20},                          // There is no fourth kind.
      {0xA1, 1, 0x0100, 1, 20},                          // No second interface.
      {0xC0, 1, 0, 0, 8},                                // A vendor's request.
      {0x40, 1, 0, 0, 0},       {0xFF, 0xFF, 0xFFFF, 0xFFFF, 0xFFFF}};
  for (const auto& request : unknown) {
    EXPECT_TRUE(Stalls(request)) << int{request.type} << ' ' << int{request.request} << ' ' << request.value;
    EXPECT_TRUE(host.Control({0x80, 0, 0, 0, 2})) << "the next request is answered";
  }
}

TEST_F(SurfaceUsb, GivesReportsOfEachKind) {
  for (int n = 0; n < 3; ++n) box.Tick(0x10);
  const auto input = host.Control({0xA1, 1, 0x0100, 0, 64});
  ASSERT_TRUE(input);
  EXPECT_EQ(input->size(), wire::kDialBoxReportBytes);
  EXPECT_EQ((*input)[0], 0x10);
  EXPECT_EQ(host.Control({0xA1, 1, 0x0200, 0, 64})->size(), wire::kDialBoxLampBytes);
  const auto feature = host.Control({0xA1, 1, 0x0300, 0, 64});
  ASSERT_TRUE(feature);
  EXPECT_EQ(Packet(feature->begin(), feature->begin() + 4), (Packet{1, 0, 2, 0}));
  EXPECT_EQ(feature->size(), wire::kSurfaceFeatureBytes);
}

TEST_F(SurfaceUsb, TakesLampsBothWaysAndRefusesOtherLengths) {
  EXPECT_TRUE(host.Control({0x21, 9, 0x0200, 0, 4}, {1, 2, 3, 4}));
  EXPECT_EQ(box.lamps(), 0x04030201u);
  device.HandleOutput(Packet{5, 0, 0, 0});
  EXPECT_EQ(box.lamps(), 5u);
  device.HandleOutput(Packet{7, 7});
  EXPECT_TRUE(Stalls({0x21, 9, 0x0200, 0, 5}, {1, 2, 3, 4, 5}));
  EXPECT_TRUE(Stalls({0x21, 9, 0x0200, 0, 0}));
  EXPECT_TRUE(Stalls({0x21, 9, 0x0100, 0, 20}, Packet(20)));
  EXPECT_TRUE(Stalls({0x21, 9, 0x0300, 0, 65}, Packet(65)));
  EXPECT_TRUE(Stalls({0x21, 9, 0x0300, 0, 64}, Packet(64, 0xEE))) << "no such operation";
  EXPECT_TRUE(Stalls({0x21, 9, 0x0200, 0, 4}, {1, 2})) << "less than was announced";
  EXPECT_EQ(box.lamps(), 5u);
}

TEST_F(SurfaceUsb, CommandsOfTheFeatureReportAreDone) {
  const auto send = [&](wire::SurfaceOperation operation, std::uint8_t number) {
    const auto bytes = wire::Encode(wire::SurfaceCommand{.operation = operation, .number = number});
    return host.Control({0x21, 9, 0x0300, 0, 64}, Packet(bytes.begin(), bytes.end())).has_value();
  };
  EXPECT_TRUE(send(wire::SurfaceOperation::kLampTest, 1));
  EXPECT_EQ(box.Tick(0), 0xFFFFFFFFu);
  EXPECT_TRUE(send(wire::SurfaceOperation::kLampTest, 0));
  EXPECT_EQ(box.Tick(0), 0u);
  EXPECT_FALSE(send(wire::SurfaceOperation::kBrightness, 16));
  EXPECT_TRUE(send(wire::SurfaceOperation::kBrightness, 7));
  EXPECT_FALSE(send(wire::SurfaceOperation::kBegin, 0)) << "it has no flash here";
  EXPECT_FALSE(box.wants_restart());
  EXPECT_TRUE(send(wire::SurfaceOperation::kRestart, 0));
  EXPECT_TRUE(box.wants_restart());
}

TEST_F(SurfaceUsb, ReportsGoOutOnChangeAloneAndOneAtATime) {
  EXPECT_FALSE(host.Poll());
  box.Look(0);
  box.Look(1);
  device.Poll();
  ASSERT_TRUE(cable.input);
  box.Look(3);
  device.Poll();
  EXPECT_EQ((*cable.input)[4], 1) << "the host has not fetched it: what came since waits";
  cable.input.reset();
  const auto second = host.Poll();
  ASSERT_TRUE(second);
  EXPECT_EQ((*second)[4], 1);
  EXPECT_FALSE(host.Poll());
}

TEST_F(SurfaceUsb, AHaltedEndpointIsSilentUntilTheHaltIsEnded) {
  box.Look(0);
  EXPECT_TRUE(host.Control({0x02, 3, 0, 0x81, 0}));
  EXPECT_EQ(host.Control({0x82, 0, 0, 0x81, 2}), (Packet{1, 0}));
  box.Look(1);
  EXPECT_FALSE(host.Poll());
  EXPECT_TRUE(host.Control({0x02, 1, 0, 0x81, 0}));
  EXPECT_FALSE(cable.halted_in);
  EXPECT_TRUE(host.Poll());
}

TEST_F(SurfaceUsb, WithoutAConfigurationThereAreNoReportsAndNoInterface) {
  EXPECT_TRUE(host.Control({0x00, 9, 0, 0, 0}));
  EXPECT_FALSE(cable.open);
  box.Look(0);
  box.Look(1);
  EXPECT_FALSE(host.Poll());
  EXPECT_TRUE(Stalls({0xA1, 1, 0x0100, 0, 20}));
  EXPECT_TRUE(Stalls({0x82, 0, 0, 0x81, 2}));
  EXPECT_TRUE(Stalls({0x01, 11, 0, 0, 0}));
  EXPECT_TRUE(host.Control({0x00, 9, 1, 0, 0}));
  EXPECT_TRUE(host.Poll()) << "what was turned meanwhile is told";
}

TEST_F(SurfaceUsb, ASetupInTheMiddleOfATransferBeginsAnew) {
  device.HandleSetup(host.Bytes({0x81, 6, 0x2200, 0, 1024}));
  ASSERT_TRUE(cable.armed_in);
  EXPECT_EQ(host.Control({0x80, 8, 0, 0, 1}), (Packet{1})) << "the packet of before was taken back";
  device.HandleSetup(host.Bytes({0x21, 9, 0x0200, 0, 4}));
  EXPECT_EQ(host.Control({0x80, 0, 0, 0, 2}), (Packet{0, 0}));
  device.HandleControlReceived(Packet{1, 2, 3, 4});
  EXPECT_EQ(box.lamps(), 0u) << "data of a transfer that is over";
}

TEST_F(SurfaceUsb, AnAnswerThatFillsItsPacketsAndIsShorterThanAskedEndsWithAnEmptyOne) {
  device.HandleSetup(host.Bytes({0xA1, 1, 0x0300, 0, 128}));
  ASSERT_TRUE(cable.armed_in);
  EXPECT_EQ(cable.armed_in->size(), 64u);
  cable.armed_in.reset();
  device.HandleControlSent();
  ASSERT_TRUE(cable.armed_in);
  EXPECT_TRUE(cable.armed_in->empty());
  cable.armed_in.reset();
  device.HandleControlSent();
  EXPECT_TRUE(cable.armed_out);
}

TEST_F(SurfaceUsb, ASuspendedBusGetsNoReportsAndResumesWithWhatWasHeld) {
  device.HandleSuspend();
  for (int n = 0; n < 3; ++n) box.Tick(2);
  EXPECT_FALSE(host.Poll());
  device.HandleResume();
  const auto report = host.Poll();
  ASSERT_TRUE(report);
  EXPECT_EQ((*report)[0], 2);
}

TEST(AnUnruledHost, CannotBringTheMachineOutOfItsRules) {
  proof::Dice dice(9);
  DialBox box({}, nullptr);
  Cable cable;
  UsbDevice device(Identity(), box, cable);
  UsbHost host(device, cable);
  for (int n = 0; n < 200'000; ++n) {
    const auto byte = [&] {
      return static_cast<std::uint8_t>(dice.OneIn(3) ? dice.Throw(256) : dice.Throw(12));
    };
    const proof::Request request{
        .type = static_cast<std::uint8_t>(
            dice.OneIn(4) ? byte() : (dice.Throw(2) << 7) | (dice.Throw(2) << 5) | dice.Throw(3)),
        .request = byte(),
        .value = static_cast<std::uint16_t>(byte() | byte() << 8),
        .index = static_cast<std::uint16_t>(dice.OneIn(2) ? 0 : byte()),
        .length = static_cast<std::uint16_t>(dice.Throw(200))};
    if (dice.OneIn(50)) host.Enumerate();
    if (dice.OneIn(5)) device.HandleSetup(host.Bytes(request));
    host.Control(request, Packet(dice.Throw(200), byte()));
    if (dice.OneIn(9)) host.Poll();
    ASSERT_EQ(cable.broken, "") << int{request.type} << ' ' << int{request.request} << ' ' << request.value
                                << ' ' << request.index << ' ' << request.length;
  }
}

}  // namespace
}  // namespace kaori::surface
