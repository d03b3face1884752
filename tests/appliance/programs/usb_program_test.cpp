// kaori-usb as udev starts it: its answer, and what it leaves for the status picture and the log.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "appliance/core/store/refused_usb.h"
#include "drivers/base/read_file.h"
#include "hw-sim/devices/misleading_descriptors.h"
#include "hw-sim/devices/usb_descriptors.h"
#include "tests/drivers/usb_readers.h"

namespace kaori::usb {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr sim::UsbInterface kTheMouse{.number = 0, .kind = 3, .subclass = 1, .protocol = 2},
    kTheStick{.number = 0, .kind = 8, .subclass = 6, .protocol = 0x50};

class UsbProgram : public ::testing::Test {
 protected:
  UsbProgram() : folder_(fs::path(::testing::TempDir()) / ("kaori-usb-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    for (const char* each : {"sys", "run/kaori-service", "run/kaori-profile"})
      fs::create_directories(folder_ / each);
    Put("log");
  }
  ~UsbProgram() override { fs::remove_all(folder_); }

  // What is plugged into the port, as sysfs has it.
  void Plug(const std::string& port, const sim::UsbBytes& configuration,
            const sim::UsbBytes& device = tests::UsbDeviceDescriptor()) {
    fs::create_directories(folder_ / "sys" / port);
    const auto file = tests::KernelReads(device, {configuration})->file;
    std::ofstream(folder_ / "sys" / port / "descriptors", std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
  }
  static sim::UsbBytes Alone(const sim::UsbInterface& one) {
    return sim::ConfigurationOf(1, sim::InterfaceDescriptor(one, 0));
  }
  void Put(const std::string& file, const std::string& text = "") { std::ofstream(folder_ / file) << text; }
  // The exit status.
  int Run(const std::string& words) const {
    return WEXITSTATUS(std::system((KAORI_USB " " + words + " 2>" + (folder_ / "stderr").string()).c_str()));
  }
  int Look(const std::string& port) const {
    return Run("look " + (folder_ / "sys" / port).string() + " " + (folder_ / "run").string() + " " +
               (folder_ / "log").string());
  }
  std::string Log() const { return ReadFile(folder_ / "log").value_or("?"); }
  fs::path said(const std::string& port) const { return folder_ / "run/kaori-usb" / port; }

  fs::path folder_;
};

TEST_F(UsbProgram, SaysYesOfAMouseAndNothingElse) {
  Plug("1-2", Alone(kTheMouse));
  EXPECT_EQ(Look("1-2"), 0);
  EXPECT_EQ(ReadFile(said("1-2")).value_or("?"), "");
  EXPECT_EQ(Log(), "");
}

TEST_F(UsbProgram, LeavesTheReasonOfALiarForAllToReadUntilItIsUnplugged) {
  Plug("1-2.4", sim::StorageBehindAShortDescriptor());
  EXPECT_EQ(Look("1-2.4"), 1);
  const auto refused = store::ParseRefusedUsb(ReadFile(said("1-2.4")).value_or(""));
  ASSERT_TRUE(refused);
  EXPECT_EQ(refused->english, "USB port 1-2.4: a storage device that also calls itself a mouse stays out");
  struct stat file {
  }, folder{};
  ::stat(said("1-2.4").c_str(), &file);
  ::stat(said("").c_str(), &folder);
  EXPECT_EQ(file.st_mode & 0777U, 0644U);
  EXPECT_EQ(folder.st_mode & 0777U, 0755U);
  EXPECT_THAT(Log(), HasSubstr("<5>kaori-usb: USB port 1-2.4: a storage device"));
  EXPECT_EQ(Run("forget 1-2.4 " + (folder_ / "run").string()), 0);
  EXPECT_FALSE(fs::exists(said("1-2.4")));
}

TEST_F(UsbProgram, AsksAnewEachTimeAndLogsWhatIsNew) {
  Plug("1-3", Alone(kTheStick));
  EXPECT_EQ(Look("1-3"), 1);
  EXPECT_EQ(Look("1-3"), 1);
  EXPECT_EQ(std::ranges::count(Log(), '\n'), 1) << "said twice";
  Put("run/kaori-service/open");
  EXPECT_EQ(Look("1-3"), 0);
  EXPECT_EQ(ReadFile(said("1-3")).value_or("?"), "");
  fs::remove(folder_ / "run/kaori-service/open");
  EXPECT_EQ(Look("1-3"), 1);
  EXPECT_EQ(std::ranges::count(Log(), '\n'), 2);
}

TEST_F(UsbProgram, KnowsAKiosk) {
  Plug("1-1", Alone({.number = 0, .kind = 3, .subclass = 1, .protocol = 1}));
  EXPECT_EQ(Look("1-1"), 0);
  Put("run/kaori-profile/kiosk");
  EXPECT_EQ(Look("1-1"), 1);
}

TEST_F(UsbProgram, KnowsTheBridgeThatWasThereFirstAndNoOther) {
  const auto bridge = tests::UsbDeviceDescriptor(0x10C4, 0xEA90);
  const auto lines = Alone({.number = 0, .kind = 3, .subclass = 0, .protocol = 0});
  Plug("1-3", lines, bridge);
  Plug("1-2.4", lines, bridge);
  Plug("1-1", Alone(kTheMouse));
  EXPECT_EQ(Look("1-1"), 0) << "which is none";
  EXPECT_EQ(Look("1-3"), 0);
  EXPECT_EQ(Look("1-2.4"), 1);
  EXPECT_THAT(ReadFile(said("1-2.4")).value_or(""), HasSubstr("that of port 1-3"));
  EXPECT_EQ(Run("forget 1-3 " + (folder_ / "run").string()), 0);
  EXPECT_EQ(Look("1-2.4"), 1) << "also while it is unplugged";
  EXPECT_EQ(Look("1-3"), 0);
}

TEST_F(UsbProgram, TakesNoBridgeThatComesAfterTheStart) {
  Plug("1-3", Alone({.number = 0, .kind = 3, .subclass = 0, .protocol = 0}),
       tests::UsbDeviceDescriptor(0x10C4, 0xEA90));
  Put("run/kaori-service/started");
  EXPECT_EQ(Look("1-3"), 1);
  EXPECT_EQ(Look("1-3"), 1) << "asked again";
}

TEST_F(UsbProgram, KeepsOutWhatHasNoDescriptorsOrFarTooMany) {
  EXPECT_EQ(Look("1-9"), 1);
  Plug("1-8", Alone(kTheMouse));
  std::ofstream(folder_ / "sys/1-8/descriptors", std::ios::app) << std::string(40'000, '\xFF');
  EXPECT_EQ(Look("1-8"), 1);
  EXPECT_THAT(ReadFile(said("1-8")).value_or(""), HasSubstr("cannot be read"));
}

TEST_F(UsbProgram, DecidesAlsoWhereNothingCanBeSaid) {
  Put("run/kaori-usb", "a file in the place of the folder");
  Plug("1-2", Alone(kTheMouse));
  Plug("1-3", Alone(kTheStick));
  EXPECT_EQ(Look("1-2"), 0);
  EXPECT_EQ(Look("1-3"), 1);
}

TEST_F(UsbProgram, TakesNoNameThatIsNoPort) {
  for (const char* words : {"", "look", "look /sys/../etc", "forget ..", "forget .", "forget passwd",
                            "peek 1-2", "look 1-2 a b c d"})
    EXPECT_EQ(Run(words), 2) << words;
  EXPECT_EQ(Run("--help >/dev/null"), 0);
}

// udev's worker is root; what reads a device's bytes is nobody, which owns nothing.
TEST_F(UsbProgram, HasNoRightsWhenItReadsWhatADeviceSays) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root has rights to give up";
  if (std::system("strace -o /dev/null " KAORI_USB " --help >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "there is no strace, or it may not watch";
  Plug("1-2", Alone(kTheMouse));
  const std::string trace = (folder_ / "trace").string();
  ASSERT_EQ(std::system(("strace -o " + trace + " " KAORI_USB " look " + (folder_ / "sys/1-2").string() +
                         " " + (folder_ / "run").string() + " " + (folder_ / "log").string())
                            .c_str()),
            0);
  const std::string calls = ReadFile(trace).value_or("");
  const std::size_t given_up = calls.find("setresuid(65534, 65534, 65534)");
  ASSERT_NE(given_up, std::string::npos);
  EXPECT_EQ(calls.find("open", given_up), std::string::npos) << "it opens nothing any more";
}

}  // namespace
}  // namespace kaori::usb
