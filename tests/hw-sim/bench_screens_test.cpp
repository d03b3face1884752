// Screens of the bench: how they are plugged into a virtual machine, and what is read from their pictures.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <string>

#include "appliance/programs/status/sheet.h"
#include "drivers/base/unique_fd.h"
#include "hw-sim/hil/picture.h"
#include "hw-sim/hil/qemu_command.h"
#include "hw-sim/hil/vnc_screen.h"
#include "render/image/png.h"

namespace kaori::hil {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr std::array<int, 3> kAmberMark{235, 170, 50}, kGreenMark{70, 190, 110};

TEST(QemuCommand, HasAVncServerForEachOutputWhoseScreenMayGo) {
  const QemuOptions options{.image = "i", .folder = "/f"};
  const auto two = QemuCommand(options, {.screens = 2, .width_px = 320, .height_px = 240}, "line", "d");
  EXPECT_THAT(two, Contains("virtio-gpu-pci,id=screens,xres=320,yres=240,max_outputs=2"));
  EXPECT_THAT(two, Contains("unix:/f/screen1.vnc,id=vnc1,display=screens,head=1"));
  EXPECT_THAT(QemuCommand(options, {}, "line", "d"), Not(Contains("-vnc")));
  EXPECT_THAT(QemuCommand(options, {.tells_size = false}, "line", "d"), Contains(HasSubstr(",edid=off")));
}

TEST(QemuCommand, CountsInstructionsOnOneProcessor) {
  const auto counted =
      QemuCommand({.image = "i", .folder = "/f"}, {.counts_instructions = true}, "line", "d");
  EXPECT_THAT(counted, Contains("shift=0,sleep=off"));
  EXPECT_THAT(counted, Contains("1"));
  EXPECT_THAT(counted, Not(Contains("2")));
}

class ScreenFiles : public ::testing::Test {
 protected:
  ScreenFiles() {
    std::string pattern = (std::filesystem::temp_directory_path() / "kaori-screens-XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~ScreenFiles() override { std::filesystem::remove_all(folder_); }
  std::string Path(const std::string& name) const { return folder_ + "/" + name; }
  std::string folder_;
};

using StatusMarks = ScreenFiles;

// As they are drawn on the box.
TEST_F(StatusMarks, AreCountedByColour) {
  using status::Mark;
  const std::vector<status::Line> lines{{Mark::kTitle, "Kaori", "plays"},
                                        {Mark::kGood, "show", "Kaori"},
                                        {Mark::kMissing, "dial box", "is not there"},
                                        {Mark::kMissing, "camera", "is not there"},
                                        {Mark::kGood, "screen", "640 x 480"},
                                        {Mark::kGood, "keyboard", "works"}};
  for (const auto& [width_px, height_px] : {std::pair{640, 480}, {1920, 1080}, {400, 300}}) {
    const auto picture = status::DrawAll(lines, width_px, height_px);
    ASSERT_TRUE(picture);
    ASSERT_TRUE(image::WritePng(Path("status.png"), *picture));
    EXPECT_EQ(CountMarks(Path("status.png"), kGreenMark), 3) << width_px;
    EXPECT_EQ(CountMarks(Path("status.png"), kAmberMark), 2) << width_px;
  }
  EXPECT_FALSE(CountMarks(Path("missing.png"), kAmberMark));
}

// QEMU's end of the cable: says what it has to say at once, and keeps what it hears.
class VncServer final : public Waiter {
 public:
  VncServer(const std::string& path, std::string said)
      : listener_(::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)), said_(std::move(said)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof(address.sun_path) - 1);
    EXPECT_EQ(::bind(listener_.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    EXPECT_EQ(::listen(listener_.get(), 1), 0);
  }

  bool Until(const std::function<bool()>& done, Duration longest, int /*fd*/) override {
    const Time end = SteadyClock().now() + std::min<Duration>(longest, std::chrono::seconds(1));
    while (!done()) {
      if (SteadyClock().now() >= end) return false;
      Serve();
    }
    return true;
  }

  std::string Heard() {
    std::string bytes(4096, '\0');
    const ssize_t got = ::recv(peer_.get(), bytes.data(), bytes.size(), MSG_DONTWAIT);
    return bytes.substr(0, static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  }

 private:
  void Serve() {
    if (peer_.valid()) return;
    peer_ = UniqueFd(::accept4(listener_.get(), nullptr, nullptr, SOCK_CLOEXEC));
    static_cast<void>(::send(peer_.get(), said_.data(), said_.size(), MSG_NOSIGNAL));
  }

  UniqueFd listener_, peer_;
  std::string said_;
};

using VncScreens = ScreenFiles;

// RFC 6143: version, one security type, its result, and the first words of the server with its name.
std::string ServersWords() {
  std::string said = "RFB 003.008\n";
  said += {1, 1};
  said += std::string(4, '\0') + std::string(20, 'x') + std::string(3, '\0') + '\x04' + "QEMU";
  return said;
}

TEST_F(VncScreens, ArePluggedInAsTheirViewersSay) {
  VncServer server(Path("vnc"), ServersWords());
  auto screen = VncScreen::Connect(Path("vnc"), server);
  ASSERT_TRUE(screen) << screen.error().message();
  const std::string greeting = server.Heard();
  EXPECT_EQ(greeting.substr(0, 14), std::string("RFB 003.008\n\1\1"));
  EXPECT_EQ(greeting.size(), 14U + 16U) << "and three encodings";
  ASSERT_TRUE(screen->Resize(400, 300));
  const std::string size{1, '\x90', 1, 44};
  const std::string begin{'\xfb', 0}, one{1, 0};
  const std::string resized = begin + size + one + std::string(8, '\0') + size + std::string(4, '\0');
  EXPECT_EQ(server.Heard(), resized);
}

TEST_F(VncScreens, AreNotThereWhereTheServerSaysLess) {
  VncServer server(Path("vnc"), ServersWords().substr(0, 40));
  EXPECT_FALSE(VncScreen::Connect(Path("vnc"), server));
}

}  // namespace
}  // namespace kaori::hil
