// A gadget in a folder that stands for configfs, and its reports through a terminal that stands for its file.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "firmware/wire/dial_box.h"
#include "hw-sim/devices/input_devices.h"
#include "hw-sim/links/gadget/gadget_port.h"

namespace kaori::sim {
namespace {

using namespace std::chrono_literals;

class Gadget : public ::testing::Test {
 protected:
  Gadget() : folder_(::testing::TempDir() + "gadget-" + std::to_string(::getpid())) {
    std::filesystem::create_directories(folder_ + "/gadgets/box/functions/hid.0");
    std::filesystem::create_directories(folder_ + "/dev");
    std::ofstream(folder_ + "/gadgets/box/functions/hid.0/dev") << "237:4\n";
    host_ = UniqueFd(::posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK));
    ::grantpt(host_.get());
    ::unlockpt(host_.get());
    termios raw{};
    ::tcgetattr(host_.get(), &raw);
    ::cfmakeraw(&raw);
    ::tcsetattr(host_.get(), TCSANOW, &raw);
    std::filesystem::create_symlink(::ptsname(host_.get()), folder_ + "/dev/hidg4");
  }
  ~Gadget() override { std::filesystem::remove_all(folder_); }

  Result<HidGadget> Make() {
    return HidGadget::Make({folder_ + "/gadgets", folder_ + "/dev"}, "box", devices_.dial_box.device_name());
  }
  std::string Said(const std::string& file) const {
    std::ostringstream text;
    text << std::ifstream(folder_ + "/gadgets/box/" + file).rdbuf();
    return text.str();
  }

  ManualClock clock_;
  DeviceContext context_{clock_, {}};
  InputDevices devices_{context_, {64, 48, ports::PixelFormat::kYuyv}};
  std::string folder_;
  UniqueFd host_;
};

TEST_F(Gadget, SaysWhoItIsByTheFirmwaresOwnDescriptor) {
  const auto gadget = Make();
  ASSERT_TRUE(gadget) << gadget.error().message();
  EXPECT_EQ(Said("idVendor"), "0x1209");
  EXPECT_EQ(Said("idProduct"), "0x0001");
  EXPECT_EQ(Said("functions/hid.0/report_desc").size(), wire::kDialBoxDescriptor.size());
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ + "/gadgets/box/configs/c.1/hid.0"));
  EXPECT_EQ(Said("UDC"), "\n") << "the cable is not in yet";
}

TEST_F(Gadget, SaysWhyItsFileOfReportsIsNotFound) {
  const auto gadget = Make();
  ASSERT_TRUE(gadget);
  EXPECT_EQ(gadget->DeviceFile().value(), folder_ + "/dev/hidg4");
  const std::string numbers = folder_ + "/gadgets/box/functions/hid.0/dev";
  for (const char* wrong : {"237\n", "237:\n", "237:4"}) {
    std::ofstream(numbers) << wrong;
    EXPECT_EQ(gadget->DeviceFile().error().message(), numbers + ": expected two numbers, as 237:0");
  }
  std::filesystem::remove(numbers);
  EXPECT_EQ(gadget->DeviceFile().error().cause, std::errc::no_such_file_or_directory);
}

TEST_F(Gadget, IsMadeAgainOverWhatADeadSimulatorLeft) {
  auto left = Make();
  ASSERT_TRUE(left);
  EXPECT_TRUE(Make());
}

TEST_F(Gadget, SendsReportsAndTakesLamps) {
  GadgetPort port(std::move(*Make()), "dummy_udc.0", devices_.dial_box);
  ASSERT_TRUE(port.Plug());
  EXPECT_EQ(Said("UDC"), "dummy_udc.0");
  devices_.dial_box.Push(3);
  clock_.Advance(1ms);
  port.Pump(clock_.now());
  std::array<std::uint8_t, 64> report{};
  ASSERT_EQ(::read(host_.get(), report.data(), report.size()),
            static_cast<ssize_t>(wire::kDialBoxReportBytes));
  EXPECT_EQ(report[0], 1U << 3);
  const std::array<std::uint8_t, 4> lamps{0x21, 0, 0, 0x80};
  ASSERT_EQ(::write(host_.get(), lamps.data(), lamps.size()), 4);
  port.Pump(clock_.now());
  EXPECT_EQ(devices_.dial_box.lamps(), 0x80000021U);
}

TEST_F(Gadget, IsPulledByItsCable) {
  GadgetPort port(std::move(*Make()), "dummy_udc.0", devices_.dial_box);
  ASSERT_TRUE(port.Plug());
  port.Unplug();
  EXPECT_EQ(Said("UDC"), "\n");
  EXPECT_FALSE(port.plugged());
  EXPECT_FALSE(port.next_due(clock_.now()));
  EXPECT_TRUE(port.Plug()) << "and plugged again";
}

TEST_F(Gadget, WhoseFileCannotBeOpenedIsNotLeftBound) {
  GadgetPort port(std::move(*Make()), "dummy_udc.0", devices_.dial_box);
  std::filesystem::rename(folder_ + "/dev/hidg4", folder_ + "/dev/elsewhere");
  const auto plugged = port.Plug();
  ASSERT_FALSE(plugged);
  EXPECT_THAT(plugged.error().message(), ::testing::HasSubstr("hidg4"));
  EXPECT_EQ(Said("UDC"), "\n");
  std::filesystem::rename(folder_ + "/dev/elsewhere", folder_ + "/dev/hidg4");
  EXPECT_TRUE(port.Plug()) << "once the file is there";
}

TEST_F(Gadget, NamesTheFolderThatAKernelWithoutGadgetsLacks) {
  const auto made = HidGadget::Make({"/proc/no-gadgets", "/dev"}, "box", devices_.dial_box.device_name());
  ASSERT_FALSE(made);
  EXPECT_THAT(made.error().message(), ::testing::HasSubstr("/proc/no-gadgets/box"));
}

}  // namespace
}  // namespace kaori::sim
