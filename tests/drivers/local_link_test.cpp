// What the contracts of Camera and Scanout leave to the local link: peers that do everything wrong.
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <random>

#include "drivers/base/packet_socket.h"
#include "drivers/base/shared_memory.h"
#include "drivers/camera/local_camera.h"
#include "drivers/scanout/local_screen.h"
#include "firmware/wire/link_packets.h"
#include "tests/drivers/link_peer.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori {
namespace {

using tests::LinkPeer;
using Bytes = std::vector<std::uint8_t>;

class LocalCameraTest : public ::testing::Test {
 protected:
  void Greet(const wire::CameraHello& hello, const SharedMemory& given) {
    camera = *camera::LocalCamera::Open(folder.path(), "c");
    ASSERT_TRUE(peer.Accept());
    peer.Send(wire::Encode(hello), given.descriptor());
  }
  std::errc Cause() { return camera->Next().error().cause; }

  sim::TempFolder folder;
  LinkPeer peer{folder.path() + "/camera.c"};
  SharedMemory memory = std::move(*SharedMemory::Make("test", 2 * 64));
  std::unique_ptr<ports::Camera> camera;
  wire::CameraFrameNote good{
      .at_ns = 5, .slot = 1, .width_px = 4, .height_px = 2, .stride_bytes = 8, .bytes = 16};
};

TEST_F(LocalCameraTest, RefusesMemoryThatIsSmallerThanPromised) {
  Greet({3, 64}, memory);
  EXPECT_EQ(Cause(), std::errc::io_error);
  EXPECT_EQ(Cause(), std::errc::io_error);
}

TEST_F(LocalCameraTest, RefusesAHelloOfNonsense) {
  for (const wire::CameraHello& hello :
       {wire::CameraHello{0, 64}, {2, 0}, {0xFFFFFFFF, 0xFFFFFFFF}, {65, 1}}) {
    Greet(hello, memory);
    EXPECT_EQ(Cause(), std::errc::io_error);
  }
}

TEST_F(LocalCameraTest, RefusesAHelloWithoutMemory) {
  Greet({2, 64}, {});
  EXPECT_EQ(Cause(), std::errc::io_error);
}

TEST_F(LocalCameraTest, GivesAFrameAndThenReturnsItsSlot) {
  Greet({2, 64}, memory);
  peer.Send(wire::Encode(good));
  const auto frame = camera->Next();
  ASSERT_TRUE(frame) << frame.error().message();
  EXPECT_EQ(frame->at, Time(Duration(5)));
  EXPECT_EQ(frame->bytes.size(), 16u);
  std::array<std::uint8_t, 64> heard;
  EXPECT_FALSE(peer.Receive(heard));
  EXPECT_EQ(Cause(), std::errc::resource_unavailable_try_again);
  ASSERT_TRUE(peer.Receive(heard));
  EXPECT_EQ(wire::GetU32(heard, 0), 1u);
}

TEST_F(LocalCameraTest, DropsEveryFrameWhoseNumbersDoNotFit) {
  Greet({2, 64}, memory);
  const auto bad = [this](auto change) {
    wire::CameraFrameNote note = good;
    change(note);
    peer.Send(wire::Encode(note));
    EXPECT_EQ(Cause(), std::errc::bad_message);
  };
  bad([](auto& n) { n.slot = 2; });
  bad([](auto& n) { n.slot = 0xFFFFFFFF; });
  bad([](auto& n) { n.bytes = 65; });
  bad([](auto& n) { n.bytes = 0; });
  bad([](auto& n) { n.bytes = 15; });
  bad([](auto& n) { n.width_px = 0; });
  bad([](auto& n) { n.width_px = 5; });
  bad([](auto& n) { n.height_px = 0xFFFFFFFF; });
  bad([](auto& n) { n.stride_bytes = 7; });
  bad([](auto& n) { n.stride_bytes = 0xFFFFFFFF; });
  bad([](auto& n) { n.pixels = 3; });
  peer.Send(Bytes{1, 2, 3});
  EXPECT_EQ(Cause(), std::errc::bad_message);
  peer.Send(wire::Encode(good));
  EXPECT_TRUE(camera->Next());
}

TEST_F(LocalCameraTest, IsNotBlockedByACameraThatNeverStops) {
  Greet({2, 64}, memory);
  EXPECT_EQ(Cause(), std::errc::resource_unavailable_try_again);
  int waiting = 0;
  while (peer.TrySend(wire::Encode(good))) ++waiting;
  int frames = 0;
  while (camera->Next()) ++frames;
  EXPECT_GE(frames, waiting / 64) << "it comes back now and then";
  EXPECT_GE(frames, 2);
}

TEST_F(LocalCameraTest, SurvivesRandomPackets) {
  Greet({2, 64}, memory);
  std::mt19937 random(7);
  for (int n = 0; n < 20'000; ++n) {
    wire::CameraFrameNote note = good;
    std::uint32_t* const fields[] = {&note.slot,         &note.width_px, &note.height_px,
                                     &note.stride_bytes, &note.pixels,   &note.bytes};
    *fields[random() % 6] = static_cast<std::uint32_t>(random() >> (random() % 32));
    peer.Send(wire::Encode(note));
    const auto frame = camera->Next();
    std::uint32_t sum = 0;
    if (frame)
      for (const std::uint8_t byte : frame->bytes) sum += byte;
    ASSERT_EQ(sum, 0u);  // The memory is all zeros: what was read lies in it.
    std::array<std::uint8_t, 8> heard;
    while (peer.Receive(heard)) {
    }
  }
}

TEST(LocalScreenTest, IsGoneAfterNonsense) {
  const sim::TempFolder folder;
  LinkPeer peer(folder.path() + "/screen.s");
  const auto memory = *SharedMemory::Make("test", 2 * 16 * 4);
  const auto open = [&](const wire::ScreenHello& hello) {
    auto screen = *scanout::LocalScreen::Open(folder.path(), "s");
    EXPECT_TRUE(peer.Accept());
    peer.Send(wire::Encode(hello), memory.descriptor());
    return screen;
  };
  const wire::ScreenHello good{2, 4, 4, 1000};
  EXPECT_TRUE(open(good)->Acquire());
  for (const wire::ScreenHello& bad : {wire::ScreenHello{1, 4, 4, 1000},
                                       {3, 4, 4, 1000},
                                       {2, 0, 4, 1000},
                                       {2, 4, 0xFFFFFFFF, 1000},
                                       {2, 4, 4, 0},
                                       {2, 4, 4, 1'000'000'001},
                                       {2, 4, 4, INT64_MAX},
                                       {2, 4, 4, -1}})
    EXPECT_EQ(open(bad)->Acquire().error().cause, std::errc::no_such_device);

  auto screen = open(good);
  ASSERT_TRUE(screen->Acquire());
  EXPECT_EQ(open(good)->Present(1).error().cause, std::errc::invalid_argument);
  screen = open(good);
  ASSERT_TRUE(screen->Acquire());
  ASSERT_TRUE(screen->Present(1));
  peer.Send(wire::Encode(wire::ScreenFlip{5, 2, 0}));  // Another frame than was presented.
  EXPECT_EQ(screen->ReadFlip().error().cause, std::errc::no_such_device);
  for (const std::int64_t never : {std::int64_t{-1}, INT64_MIN, INT64_MAX}) {
    screen = open(good);
    ASSERT_TRUE(screen->Acquire());
    ASSERT_TRUE(screen->Present(1));
    peer.Send(wire::Encode(wire::ScreenFlip{never, 1, 0}));
    EXPECT_EQ(screen->ReadFlip().error().cause, std::errc::no_such_device) << never;
  }
}

TEST(SharedMemoryTest, ThatMayShrinkIsRefused) {
  UniqueFd loose(::memfd_create("test", MFD_CLOEXEC));
  ASSERT_EQ(::ftruncate(loose.get(), 4096), 0);
  EXPECT_EQ(SharedMemory::Adopt(std::move(loose), 4096).error().cause, std::errc::invalid_argument);
}

TEST(PacketSocket, ClosesDescriptorsThatNobodyAskedFor) {
  const sim::TempFolder folder;
  const UniqueFd listener = *ListenForPackets(folder.path() + "/s");
  const UniqueFd near = *ConnectToPeer(folder.path() + "/s");
  const UniqueFd far = *AcceptPeer(listener.get());
  const int before = sim::OpenDescriptors();
  for (int n = 0; n < 10; ++n) {
    ASSERT_TRUE(SendPacket(near.get(), Bytes{1}, near.get()));
    std::array<std::uint8_t, 8> buffer;
    ASSERT_TRUE(ReceivePacket(far.get(), buffer));
  }
  EXPECT_EQ(sim::OpenDescriptors(), before);
}

TEST(PacketSocket, SaysWhichPacketWasTooLong) {
  const sim::TempFolder folder;
  const UniqueFd listener = *ListenForPackets(folder.path() + "/s");
  const UniqueFd near = *ConnectToPeer(folder.path() + "/s");
  const UniqueFd far = *AcceptPeer(listener.get());
  ASSERT_TRUE(SendPacket(near.get(), Bytes(100, 1)));
  ASSERT_TRUE(SendPacket(near.get(), Bytes(3, 1)));
  std::array<std::uint8_t, 8> buffer;
  EXPECT_EQ(ReceivePacket(far.get(), buffer).error().cause, std::errc::message_size);
  EXPECT_EQ(ReceivePacket(far.get(), buffer)->bytes, 3u);
}

TEST(PacketSocket, LeavesNoDraftWhateverLayThereBefore) {
  const sim::TempFolder folder;
  const std::string path = folder.path() + "/s", draft = path + ".new";
  std::ofstream(draft) << "left by a killed owner";
  const auto listener = ListenForPackets(path);
  ASSERT_TRUE(listener) << listener.error().message();
  EXPECT_TRUE(ConnectToPeer(path));
  EXPECT_FALSE(std::filesystem::exists(draft));
  std::filesystem::create_directory(folder.path() + "/folder");
  EXPECT_FALSE(ListenForPackets(folder.path() + "/folder")) << "a folder is not replaced";
  EXPECT_FALSE(std::filesystem::exists(folder.path() + "/folder.new"));
  std::filesystem::create_directory(draft);
  EXPECT_NE(ListenForPackets(path).error().message().find(draft), std::string::npos) << "what is in the way";
}

TEST(PacketSocket, NamesAPathThatIsTooLong) {
  EXPECT_EQ(ListenForPackets("/tmp/" + std::string(120, 'x')).error().cause, std::errc::filename_too_long);
  EXPECT_EQ(ConnectToPeer("/tmp/" + std::string(120, 'x')).error().cause, std::errc::filename_too_long);
}

}  // namespace
}  // namespace kaori
