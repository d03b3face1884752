// The bench without a machine: what it says to one, understands of it, and reports.

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/qemu_command.h"
#include "hw-sim/hil/report.h"
#include "hw-sim/links/usbredir/usb_rig.h"
#include "tests/hil/agent/actions.h"
#include "tests/hil/agent/first_program.h"

namespace kaori::hil {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kShipped =
    R"(dm-mod.create="root,,,ro,0 8 verity 1 a b" root=/dev/dm-0 rootfstype=erofs ro init=/usr/lib/systemd/systemd quiet)";

TEST(BenchCommandLine, StartsTheAgentWhichBecomesWhatTheImageNames) {
  const std::string line = BenchCommandLine(kShipped);
  EXPECT_THAT(line, ::testing::StartsWith(kShipped)) << "what ships is kept; the last word of a name counts";
  EXPECT_EQ(agent::OnCommandLine(line, "kaori.root"), "/dev/dm-0");
  EXPECT_EQ(agent::OnCommandLine(line, "kaori.rootfstype"), "erofs");
  EXPECT_EQ(agent::OnCommandLine(line, "kaori.init"), "/usr/lib/systemd/systemd");
  EXPECT_LT(line.rfind("init=/usr/lib"), line.rfind("init=/usr/bin/kaori-hil-agent"));
}

TEST(BenchCommandLine, KnowsWhatIsUsualWhereTheImageSaysNothing) {
  EXPECT_EQ(agent::OnCommandLine(BenchCommandLine("quiet"), "kaori.init"), "/usr/lib/systemd/systemd");
  EXPECT_EQ(agent::OnCommandLine("quiet", "kaori.init"), "");
}

TEST(OnUsb, LetsTheKernelFindItsRootOnUsbAndChangesNothingElse) {
  EXPECT_EQ(OnUsb("a usbcore.authorized_default=0 quiet"), "a usbcore.authorized_default=1 quiet");
  EXPECT_EQ(OnUsb("quiet"), "quiet");
}

TEST(QemuCommand, PutsEachDeviceOnAPortOfItsOwn) {
  const auto command =
      QemuCommand({.image = "i", .bench_disk = "b", .folder = "/f"}, {}, "line", "i/kaori.disk");
  for (std::size_t n = 0; n < sim::kUsbSockets.size(); ++n)
    EXPECT_THAT(command, ::testing::Contains("usb-redir,chardev=usb" + std::to_string(n) +
                                             ",bus=xhci.0,port=" + std::to_string(n + 1)));
  EXPECT_THAT(command, ::testing::Contains("if=none,id=disk,format=raw,file=i/kaori.disk,snapshot=on"))
      << "nothing is written to it";
  EXPECT_THAT(command, ::testing::Contains("file=b,if=none,id=bench,format=raw,readonly=on"));
}

TEST(QemuCommand, OnUsbHasTheDiskOnAControllerOfItsOwn) {
  const kaori::hil::Setup on_usb{.disk_bus = DiskBus::kUsb, .other_stick = true};
  const auto command = QemuCommand({.image = "i", .bench_disk = "b", .folder = "/f"}, on_usb, "line", "d");
  EXPECT_THAT(command, ::testing::Contains("usb-storage,drive=disk,bus=medium.0,id=medium-disk"));
  EXPECT_THAT(command, ::testing::Contains("usb-storage,drive=stick,id=unauthorised,bus=xhci.0,port=8"));
  EXPECT_EQ(BenchDisk(on_usb), "/dev/vda") << "it is the only one on virtio";
  EXPECT_EQ(BenchDisk({}), "/dev/vdb");
}

TEST(QemuCommand, WithSecureBootHasTwoFlashChipsAndNoOtherFirmware) {
  const auto command = QemuCommand(
      {.image = "i", .folder = "/f"},
      {.agent = false, .firmware = true, .variables = "/f/kept", .secure_boot = true}, "line", "d");
  EXPECT_THAT(command, ::testing::Contains("if=pflash,unit=1,format=raw,file=/f/kept"));
  EXPECT_THAT(command, ::testing::Contains("q35,smm=on"));
  EXPECT_THAT(command, Not(::testing::Contains("-bios")));
  EXPECT_THAT(command, Not(::testing::Contains("-kernel")));
}

class Folder : public ::testing::Test {
 protected:
  Folder() : folder_(::testing::TempDir() + "bench-" + std::to_string(::getpid())) {
    std::filesystem::create_directories(folder_);
  }
  ~Folder() override { std::filesystem::remove_all(folder_); }
  std::string Path(const std::string& name) const { return folder_ + "/" + name; }
  std::string folder_;
};

using AgentActions = Folder;

TEST_F(AgentActions, ReadFilesOfTheRootTheyAreGiven) {
  std::ofstream(Path("serial")) << "7\n";
  const UniqueFd root(::open(folder_.c_str(), O_PATH | O_DIRECTORY));
  EXPECT_EQ(agent::ReadIn(root.get(), "/serial"), "7\n");
  const auto missing = agent::ReadIn(root.get(), "/nothing");
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().cause, std::errc::no_such_file_or_directory);
}

TEST_F(AgentActions, WriteIntoFilesThatAreThereAndMakeNone) {
  std::ofstream(Path("freeze")) << "0";
  const UniqueFd root(::open(folder_.c_str(), O_PATH | O_DIRECTORY));
  EXPECT_TRUE(agent::WriteIn(root.get(), "/freeze", "1"));
  EXPECT_EQ(agent::ReadIn(root.get(), "/freeze"), "1\n");
  EXPECT_FALSE(agent::WriteIn(root.get(), "/nothing", "1"));
}

TEST_F(AgentActions, SignalNobodyWhereNobodyHasTheName) {
  EXPECT_EQ(agent::ProcessesOf("no-such-program"), "");
  std::string own_name;
  std::getline(std::ifstream("/proc/self/comm"), own_name);
  EXPECT_THAT(agent::ProcessesOf(own_name), ::testing::HasSubstr(std::to_string(::getpid())));
  EXPECT_EQ(agent::SignalAll("no-such-program", "15"), "0");
  EXPECT_FALSE(agent::SignalAll("no-such-program", "hard"));
}

using Pictures = Folder;

void WritePng(const std::string& path, const std::function<std::array<std::uint8_t, 3>(int, int)>& colour) {
  constexpr int kSide = 64;
  std::vector<std::uint8_t> rgb;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x)
      for (const std::uint8_t part : colour(x, y)) rgb.push_back(part);
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = kSide;
  image.format = PNG_FORMAT_RGB;
  ASSERT_NE(png_image_write_to_file(&image, path.c_str(), 0, rgb.data(), 0, nullptr), 0);
}

TEST_F(Pictures, OfBlackAndOfAConsoleShowNoFace) {
  WritePng(Path("black.png"), [](int, int) { return std::array<std::uint8_t, 3>{0, 0, 0}; });
  EXPECT_FALSE(ShowsAFace(*LookAt(Path("black.png"))));
  WritePng(Path("console.png"), [](int x, int y) {
    const auto grey = static_cast<std::uint8_t>((x * 7 + y * 3) % 5 == 0 ? 170 : 0);
    return std::array<std::uint8_t, 3>{grey, grey, grey};
  });
  EXPECT_FALSE(ShowsAFace(*LookAt(Path("console.png"))));
}

TEST_F(Pictures, OfManyShadesMayShowOne) {
  WritePng(Path("shades.png"), [](int x, int y) {
    return std::array<std::uint8_t, 3>{static_cast<std::uint8_t>(x * 4), static_cast<std::uint8_t>(y * 4),
                                       90};
  });
  EXPECT_TRUE(ShowsAFace(*LookAt(Path("shades.png"))));
  EXPECT_FALSE(LookAt(Path("none.png")));
}

using Comparison = Folder;

// A PPM of one colour above and another below.
std::string Ppm(int width_px, int height_px, unsigned char above, unsigned char below) {
  std::string ppm = "P6\n" + std::to_string(width_px) + " " + std::to_string(height_px) + "\n255\n";
  for (int y = 0; y < height_px; ++y)
    ppm += std::string(3 * static_cast<std::size_t>(width_px),
                       static_cast<char>(y < height_px / 2 ? above : below));
  return ppm;
}

TEST_F(Comparison, IsZeroForOnePictureInTwoSizesAndOneForBlackAgainstWhite) {
  std::ofstream(Path("small.ppm")) << Ppm(60, 40, 10, 200);
  std::ofstream(Path("large.ppm")) << Ppm(480, 240, 10, 200);
  std::ofstream(Path("black.ppm")) << Ppm(60, 40, 0, 0);
  std::ofstream(Path("white.ppm")) << Ppm(60, 40, 255, 255);
  EXPECT_EQ(MeanDifference(Path("small.ppm"), Path("large.ppm")), 0);
  EXPECT_EQ(MeanDifference(Path("black.ppm"), Path("white.ppm")), 1);
  std::ofstream(Path("torn.ppm")) << Ppm(60, 40, 0, 0).substr(0, 600);
  EXPECT_FALSE(MeanDifference(Path("black.ppm"), Path("torn.ppm")));
}

TEST_F(Comparison, HasControlsThatItFindsWrong) {
  std::ofstream(Path("face.ppm")) << Ppm(60, 40, 10, 200);
  ASSERT_TRUE(WriteUpsideDown(Path("face.ppm"), Path("down.png")));
  ASSERT_TRUE(WriteBlack(Path("face.ppm"), Path("black.png")));
  EXPECT_GT(*MeanDifference(Path("face.ppm"), Path("down.png")), 0.5);
  EXPECT_GT(*MeanDifference(Path("face.ppm"), Path("black.png")), 0.3);
}

Report Sample() {
  Report report{.image = "out/image", .root_hash = "ab12", .boot_s = 30, .checks = {}};
  report.checks.push_back(
      {"face",
       "The face is on the screen",
       {.said = "92 % lit", .pictures = {{"face-0.png", "The first face"}}, .took_s = 1.5}});
  report.checks.push_back(
      {"replugs",
       "Roles stay",
       {.verdict = Verdict::kFailed, .said = "1 < 2 & \"so\" on", .figures = {{"swaps", 1}}}});
  report.checks.push_back({"sound", "Sound", {.verdict = Verdict::kSkipped, .said = "no card"}});
  return report;
}

TEST(BenchReport, TellsMachinesWhatFailedAndWhy) {
  const std::string xml = AsJUnit(Sample());
  EXPECT_THAT(xml, HasSubstr(R"(tests="3" failures="1" skipped="1" time="1.5")"));
  EXPECT_THAT(xml, HasSubstr(R"(<failure message="1 &lt; 2 &amp; &quot;so&quot; on"/>)"));
  EXPECT_THAT(xml, HasSubstr(R"(<skipped message="no card"/>)"));
}

TEST(BenchReport, ShowsPeoplePicturesAndFigures) {
  const std::string page = AsPage(Sample());
  EXPECT_THAT(page, HasSubstr("The box failed on the bench"));
  EXPECT_THAT(page, HasSubstr(R"(<img src="face-0.png" alt="The first face")"));
  EXPECT_THAT(page, HasSubstr("swaps"));
  EXPECT_THAT(page, Not(HasSubstr("1 < 2")));
}

class BenchFigures : public Folder {
 protected:
  // What the file holds once the checks' figures have been laid into it.
  std::string Merged(const Report& report) const {
    EXPECT_TRUE(MergeFigures(report, Path("boot.json")));
    std::ostringstream text;
    text << std::ifstream(Path("boot.json")).rdbuf();
    return text.str();
  }
};

TEST_F(BenchFigures, OfChecksThatPassedAreLaidBesideThoseOfOthers) {
  std::ofstream(Path("boot.json")) << R"({"first_light_over_stock": 0.1, "hung_s": 9})";
  Report report = Sample();
  report.checks.push_back({"hung", "Programs come back", {.figures = {{"hung_s", 2}}}});
  const std::string text = Merged(report);
  EXPECT_THAT(text, HasSubstr("\"first_light_over_stock\": 0.1"));
  EXPECT_THAT(text, HasSubstr("\"first_frames_s\": 30.0"));
  EXPECT_THAT(text, HasSubstr("\"hung_s\": 2.0"));
}

TEST_F(BenchFigures, OfACheckThatFailsAreRemovedThoseOfARunBeforeToo) {
  std::ofstream(Path("boot.json")) << R"({"swaps": 9})";
  EXPECT_THAT(Merged(Sample()), Not(HasSubstr("swaps"))) << "no list says whose it was";
  Report report = Sample();
  report.checks = {{"replugs", "Roles stay", {.figures = {{"replugs", 200}, {"swaps", 0}}}}};
  EXPECT_THAT(Merged(report), HasSubstr("\"replugs\": 200.0"));
  Finding& replugs = report.checks[0].finding;
  replugs = {.verdict = Verdict::kSkipped};
  EXPECT_THAT(Merged(report), HasSubstr("\"replugs\": 200.0")) << "it was not tried";
  replugs.verdict = Verdict::kFailed;
  EXPECT_THAT(Merged(report), Not(HasSubstr("replugs"))) << "it did not come so far as to say any";
}

TEST_F(BenchFigures, AreNotLaidOverWhatIsNoObject) {
  std::ofstream(Path("boot.json")) << "seven";
  EXPECT_FALSE(MergeFigures(Sample(), Path("boot.json")));
}

TEST(BenchChecks, HaveNamesOfTheirOwnAndAChosenPart) {
  std::vector<std::string> names;
  int chosen = 0;
  for (const Check& check : AllChecks()) {
    names.push_back(check.name);
    chosen += check.chosen ? 1 : 0;
  }
  std::ranges::sort(names);
  EXPECT_EQ(std::ranges::adjacent_find(names), names.end());
  EXPECT_GE(chosen, 8);
}

TEST(BenchChecks, HaveANegativeControl) {
  for (const Check& check : AllChecks())
    EXPECT_NE(check.fails_without.empty(), !check.control) << check.name << " has none, or two";
}

TEST(BenchChecks, OfOneSetupStandTogether) {
  std::vector<hil::Setup> setups;
  for (const Check& check : AllChecks())
    if (setups.empty() || setups.back() != check.setup) setups.push_back(check.setup);
  for (std::size_t n = 0; n < setups.size(); ++n)
    EXPECT_EQ(std::count(setups.begin(), setups.end(), setups[n]), 1) << "a box is started anew for nothing";
}

TEST(BenchChecks, OfTheChosenPartWantTheImageAndNothingElse) {
  for (const Check& check : AllChecks())
    EXPECT_TRUE(!check.chosen || check.setup == hil::Setup{}) << check.name;
}

}  // namespace
}  // namespace kaori::hil
