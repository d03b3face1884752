// The bench's own tools: programs it starts, screens in memory, disks with other settings, what it reports.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "hw-sim/devices/voice_file.h"
#include "hw-sim/hil/disk_copy.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/process.h"
#include "hw-sim/hil/qemu_command.h"
#include "hw-sim/hil/report.h"
#include "hw-sim/hil/x_screen.h"
#include "tests/hil/agent/actions.h"
#include "tests/hil/agent/usb_view.h"

namespace kaori::hil {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class PartsFolder : public ::testing::Test {
 protected:
  PartsFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kaori-parts-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~PartsFolder() override { std::filesystem::remove_all(folder_); }
  std::string Path(const std::string& name) const { return folder_ + "/" + name; }
  std::string Text(const std::string& name) const {
    std::ifstream file(Path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void Write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(std::filesystem::path(Path(name)).parent_path());
    std::ofstream(Path(name), std::ios::binary) << bytes;
  }
  std::string folder_;
};

using Programs = PartsFolder;

TEST_F(Programs, EndWithWhoeverHoldsThem) {
  pid_t number = 0;
  {
    const auto program = Process::Start({"sleep", "600"}, Path("log"));
    ASSERT_TRUE(program);
    number = program->number();
    EXPECT_TRUE(program->runs());
  }
  EXPECT_NE(::kill(number, 0), 0);
}

TEST_F(Programs, TellHowMuchTheyWorked) {
  const auto idle = Process::Start({"sleep", "600"}, Path("log"));
  const auto busy = Process::Start({"sh", "-c", "while :; do :; done"}, Path("log"));
  ASSERT_TRUE(idle && busy);
  while (busy->worked() < std::chrono::milliseconds(30)) ::usleep(1000);
  EXPECT_LT(idle->worked(), std::chrono::milliseconds(30));
}

TEST_F(Programs, ThatAreNotThereDoNotRun) {
  const auto program = Process::Start({"no-such-program-of-ours"}, Path("log"));
  ASSERT_TRUE(program);
  while (program->runs()) ::usleep(1000);
  EXPECT_FALSE(RunToEnd({"no-such-program-of-ours"}, Path("log")));
}

TEST_F(Programs, ThatFailSayWhy) {
  const auto ran = RunToEnd({"sh", "-c", "echo too few bricks; exit 3"}, Path("log"));
  ASSERT_FALSE(ran);
  EXPECT_THAT(ran.error().message(), HasSubstr("too few bricks"));
  EXPECT_EQ(ran.error().kind, ErrorKind::kSystem);
}

TEST(QemuCommand, DrawsInsideUnlessTheBenchShallDraw) {
  const QemuOptions options{.image = "i", .folder = "/f", .width_px = 480, .height_px = 270};
  EXPECT_THAT(QemuCommand(options, {}, "line", "disk"),
              Contains("virtio-gpu-pci,id=screens,xres=480,yres=270,max_outputs=1"));
  const auto outside =
      QemuCommand(options, {.graphics = Graphics::kVirgl, .width_px = 960, .height_px = 540}, "line", "disk");
  EXPECT_THAT(outside, Contains("virtio-gpu-gl-pci,id=screens,xres=960,yres=540"));
  EXPECT_THAT(outside, Contains("sdl,gl=on"));
}

TEST(QemuCommand, TakesAnotherKernelOnlyWhereACheckWantsIt) {
  const QemuOptions options{.image = "i", .bench_kernel = "more", .folder = "/f"};
  EXPECT_THAT(QemuCommand(options, {}, "line", "disk"), Contains("i/bzImage"));
  EXPECT_THAT(QemuCommand(options, {.bench_kernel = true}, "line", "disk"), Contains("more"));
}

TEST(QemuCommand, StartsTheDiskByItselfWhereTheFirmwareShall) {
  const QemuOptions options{.image = "i", .folder = "/f"};
  const auto pc = QemuCommand(
      options, {.agent = false, .firmware = true, .graphics = Graphics::kVga, .disk_bus = DiskBus::kNvme},
      "line", "d");
  EXPECT_THAT(pc, Contains("nvme,drive=disk,serial=1"));
  EXPECT_THAT(pc, Contains("-bios"));
  EXPECT_THAT(pc, Not(Contains("-kernel")));
  EXPECT_THAT(pc, Contains("file:/f/console.log")) << "without an agent the serial line is a log";
}

TEST(QemuCommand, HasRoomForTheDevicesWithoutAnAgentToo) {
  const QemuOptions options{.image = "i", .folder = "/f"};
  EXPECT_THAT(QemuCommand(options, {.agent = false}, "line", "d"), Contains(HasSubstr("qemu-xhci,id=xhci,")));
  EXPECT_THAT(QemuCommand(options, {.plugged = false, .agent = false}, "line", "d"),
              Not(Contains(HasSubstr("qemu-xhci,id=xhci,"))));
}

TEST(QemuCommand, KeepsWhatIsWrittenOnlyWhereACheckWantsIt) {
  const QemuOptions options{.image = "i", .folder = "/f"};
  EXPECT_THAT(QemuCommand(options, {}, "line", "d"), Contains(HasSubstr("snapshot=on")));
  EXPECT_THAT(QemuCommand(options, {.keeps_disk = true}, "line", "d"),
              Not(Contains(HasSubstr("snapshot=on"))));
}

TEST(LoggedCommandLine, LetsTheLogBeRead) {
  const std::string line = LoggedCommandLine({}, "root=a quiet loglevel=3 panic=5");
  EXPECT_THAT(line, Not(HasSubstr("quiet")));
  EXPECT_THAT(line, HasSubstr("root=a panic=5 console=ttyS0"));
}

using AgentPrograms = PartsFolder;

TEST_F(AgentPrograms, TellWhatAStartedProgramHasSaidSoFar) {
  const UniqueFd root(::open("/", O_PATH | O_DIRECTORY));
  agent::Started started;
  const auto number = started.Start(root.get(), {"WORD=good evening", "printenv", "WORD"});
  ASSERT_TRUE(number);
  while (started.Said(*number)->empty()) ::usleep(1000);
  EXPECT_EQ(started.Said(*number), "good evening\n");
  EXPECT_EQ(started.End(*number), "good evening\n");
  EXPECT_FALSE(started.Said(*number));
}

using Dumps = PartsFolder;

constexpr DumpPart kAll{0, 0, 2, 1};

std::string BigEndian(std::uint32_t word) {
  return {static_cast<char>(word >> 24), static_cast<char>(word >> 16), static_cast<char>(word >> 8),
          static_cast<char>(word)};
}

// Two by one points: red, and a blue that is almost black. The line is longer than its points.
std::string Dump(std::uint32_t bits_of_point) {
  constexpr std::uint32_t kHead = 104, kColours = 2;
  std::string dump;
  for (const std::uint32_t word :
       {kHead, 7U, 2U, 24U, 2U, 1U,       0U, 0U, 32U, 0U, 32U, bits_of_point, 12U, 4U,
        0U,    0U, 0U, 8U,  0U, kColours, 0U, 0U, 0U,  0U, 0U})
    dump += BigEndian(word);
  dump += "box" + std::string(1, '\0') + std::string(12 * kColours, 'c');
  const unsigned char points[] = {0, 0, 255, 0, 9, 0, 0, 0, 1, 1, 1, 1};
  return dump + std::string(reinterpret_cast<const char*>(points), sizeof points);
}

TEST_F(Dumps, OfAScreenBecomePictures) {
  Write("dump", Dump(32));
  ASSERT_TRUE(WriteDumpAsPng(Path("dump"), kAll, Path("dump.png")));
  const auto picture = LookAt(Path("dump.png"));
  ASSERT_TRUE(picture);
  EXPECT_EQ(picture->width_px, 2);
  EXPECT_EQ(picture->height_px, 1);
  EXPECT_DOUBLE_EQ(picture->lit, 0.5);
}

TEST_F(Dumps, GiveThePartThatIsAskedFor) {
  Write("dump", Dump(32));
  ASSERT_TRUE(WriteDumpAsPng(Path("dump"), {1, 0, 1, 1}, Path("part.png")));
  EXPECT_EQ(LookAt(Path("part.png"))->lit, 0) << "the second point alone";
  EXPECT_FALSE(WriteDumpAsPng(Path("dump"), {1, 0, 2, 1}, Path("none.png"))) << "it ends before";
}

TEST_F(Dumps, ThatAreNoneAreRefused) {
  Write("short", Dump(32).substr(0, 120));
  Write("grey", Dump(8));
  Write("empty", "");
  for (const char* name : {"short", "grey", "empty", "missing"})
    EXPECT_FALSE(WriteDumpAsPng(Path(name), kAll, Path("none.png"))) << name;
}

TEST_F(Dumps, AreComparedPointByPoint) {
  Write("dump", Dump(32));
  std::string other = Dump(32);
  other[other.size() - 7] = '\x7f';  // The second point's green.
  Write("other", other);
  ASSERT_TRUE(WriteDumpAsPng(Path("dump"), kAll, Path("dump.png")));
  ASSERT_TRUE(WriteDumpAsPng(Path("other"), kAll, Path("other.png")));
  EXPECT_EQ(ChangedPart(Path("dump.png"), Path("dump.png")), 0);
  EXPECT_EQ(ChangedPart(Path("dump.png"), Path("other.png")), 0.5);
  EXPECT_FALSE(ChangedPart(Path("dump.png"), Path("missing.png")));
}

using Disks = PartsFolder;

std::string LittleEndian(std::uint64_t number, int bytes) {
  std::string text;
  for (int n = 0; n < bytes; ++n) text += static_cast<char>(number >> (8 * n));
  return text;
}

std::string Entry(const std::string& name, std::uint64_t first) {
  std::string entry(32, '\1');
  entry += LittleEndian(first, 8) + LittleEndian(first + 7, 8) + LittleEndian(0, 8);
  for (const char letter : name) entry += {letter, '\0'};
  entry.resize(128);
  return entry;
}

std::string Gpt(const std::string& signature) {
  std::string disk(512, '\0');
  std::string head =
      signature + std::string(64, '\0') + LittleEndian(2, 8) + LittleEndian(3, 4) + LittleEndian(128, 4);
  head.resize(512);
  return disk + head + Entry("boot", 40) + Entry("data", 4000) + Entry("", 0);
}

TEST_F(Disks, TellWhereTheirPartitionsBegin) {
  Write("disk", Gpt("EFI PART"));
  EXPECT_EQ(PartitionStart_bytes(Path("disk"), "data"), 4000 * 512);
  EXPECT_FALSE(PartitionStart_bytes(Path("disk"), "root-c"));
}

TEST_F(Disks, WithoutATableAreRefused) {
  Write("disk", Gpt("NOT SUCH"));
  Write("short", "EFI PART");
  EXPECT_FALSE(PartitionStart_bytes(Path("disk"), "data"));
  EXPECT_FALSE(PartitionStart_bytes(Path("short"), "data"));
  EXPECT_FALSE(PartitionStart_bytes(Path("missing"), "data"));
}

using UsbView = PartsFolder;

TEST_F(UsbView, TellsWhichDevicesWereLetIn) {
  for (const auto& [port, authorised] : {std::pair{"1-8", "0"}, {"1-2.1", "1"}, {"usb1", "1"}}) {
    Write(std::string(port) + "/idVendor", "46f4\n");
    Write(std::string(port) + "/idProduct", "0001\n");
    Write(std::string(port) + "/authorized", std::string(authorised) + "\n");
  }
  Write("1-2.1:1.0/authorized", "1\n");
  EXPECT_EQ(agent::UsbDevices(folder_), "1-2.1 46f4:0001 1\n1-8 46f4:0001 0\n");
  EXPECT_EQ(agent::UsbDevices(Path("missing")), "");
}

using VoiceFiles = PartsFolder;

TEST_F(VoiceFiles, AreReadAsTheyWereWritten) {
  const auto said = sim::SayVowels(std::chrono::milliseconds(700));
  ASSERT_TRUE(sim::WriteWav(Path("voice.wav"), said));
  EXPECT_EQ(sim::ReadWav(Path("voice.wav")), said);
  Write("none.wav", std::string(100, 'n'));
  EXPECT_FALSE(sim::ReadWav(Path("none.wav")));
  EXPECT_FALSE(sim::ReadWav(Path("missing.wav")));
}

TEST(Likeness, FindsAVoiceThatIsLateAndSoft) {
  const auto said = sim::SayVowels(std::chrono::seconds(1));
  std::vector<std::int16_t> heard(12'345, 0);
  for (const std::int16_t sample : said) heard.push_back(static_cast<std::int16_t>(sample / 4));
  EXPECT_GT(sim::Likeness(said, heard), 0.95);
}

TEST(Likeness, OfSilenceNoiseAndAnotherVowelIsLow) {
  const auto said = sim::SayVowels(std::chrono::seconds(1));
  EXPECT_EQ(sim::Likeness(said, std::vector<std::int16_t>(48'000, 0)), 0);
  EXPECT_EQ(sim::Likeness(said, {}), 0);
  std::mt19937 chance(3);
  std::vector<std::int16_t> noise(48'000);
  for (auto& sample : noise)
    sample = static_cast<std::int16_t>(std::uniform_int_distribution(-9000, 9000)(chance));
  EXPECT_LT(sim::Likeness(said, noise), 0.4);
  const std::size_t third = said.size() / 3;
  EXPECT_LT(sim::Likeness(said, std::span(said).first(third)), 0.6) << "another vowel of the same voice";
}

using ReportFiles = PartsFolder;

TEST_F(ReportFiles, HoldWhatToolsSaid) {
  Report report;
  report.checks.push_back(
      {"tools", "What tools say", {.texts = {{"v4l2-compliance", "Total: 0"}, {"the kernel's log", "x"}}}});
  ASSERT_TRUE(WriteReport(report, folder_));
  EXPECT_EQ(Text("tools-v4l2-compliance.txt"), "Total: 0");
  EXPECT_EQ(Text("tools-the-kernel-s-log.txt"), "x");
  EXPECT_THAT(Text("report.html"), HasSubstr("href=\"tools-the-kernel-s-log.txt\""));
}

}  // namespace
}  // namespace kaori::hil
