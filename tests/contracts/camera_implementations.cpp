// The cameras: V4L2 on a fake kernel, libcamera's request camera on a fake library, and the simulator's link.
#include "drivers/camera/libcamera/request_camera.h"
#include "drivers/camera/local_camera.h"
#include "drivers/camera/v4l2_camera.h"
#include "firmware/wire/link_packets.h"
#include "tests/contracts/camera_contract.h"
#include "tests/drivers/camera_fake_requests.h"
#include "tests/drivers/camera_v4l2_fake.h"
#include "tests/drivers/link_peer.h"
#include "tests/hw-sim/link_fixture.h"

namespace kaori::contracts {
namespace {

class V4l2Subject final : public CameraSubject {
 public:
  V4l2Subject() : camera_(camera::V4l2Camera::Open("/dev/video0", {}, clock, kernel_).value()) {}
  ports::Camera& camera() override { return *camera_; }
  bool Expose(std::uint8_t grey, Time at) override { return kernel_.Expose(grey, at); }
  void ExposeTorn() override {
    kernel_.Expose(0, clock.now(), tests::FakeV4l2::kBufferBytes, V4L2_BUF_FLAG_ERROR);
  }
  void Unplug() override { kernel_.failing_error = ENODEV; }
  bool wakes() const override { return false; }

 private:
  tests::FakeV4l2 kernel_;
  std::unique_ptr<camera::V4l2Camera> camera_;
};

class RequestSubject final : public CameraSubject {
 public:
  RequestSubject() {
    auto device = std::make_unique<tests::FakeRequests>();
    device_ = device.get();
    camera_ = camera::RequestCamera::Start(std::move(device), tests::FakeStream(), clock).value();
  }
  ports::Camera& camera() override { return *camera_; }
  bool Expose(std::uint8_t grey, Time at) override { return device_->Fill(grey, at); }
  void ExposeTorn() override { device_->Fill(0, clock.now(), false); }
  void Unplug() override { device_->completions().Disconnect(); }

 private:
  tests::FakeRequests* device_ = nullptr;
  std::unique_ptr<camera::RequestCamera> camera_;
};

class LocalCameraSubject final : public CameraSubject {
 public:
  LocalCameraSubject() {
    camera_ = camera::LocalCamera::Open(folder_.path(), "c").value();
    EXPECT_TRUE(device_.Accept());
    device_.Send(wire::Encode(wire::CameraHello{kSlots, kBytes}), memory_.descriptor());
  }
  ports::Camera& camera() override { return *camera_; }
  bool Expose(std::uint8_t grey, Time at) override {
    std::array<std::uint8_t, 64> packet{};
    while (device_.Receive(packet)) lent_[wire::GetU32(packet, 0)] = false;
    const auto free = std::ranges::find(lent_, false);
    ++sequence_;
    if (free == lent_.end()) return false;
    *free = true;
    const auto slot = static_cast<std::uint32_t>(free - lent_.begin());
    std::ranges::fill(memory_.bytes().subspan(slot * kBytes, kBytes), grey);
    device_.Send(wire::Encode(wire::CameraFrameNote{.at_ns = at.time_since_epoch().count(),
                                                    .sequence = sequence_,
                                                    .slot = slot,
                                                    .width_px = 4,
                                                    .height_px = 2,
                                                    .stride_bytes = 8,
                                                    .bytes = kBytes}));
    return true;
  }
  void ExposeTorn() override { device_.Send(std::array<std::uint8_t, 3>{1, 2, 3}); }
  void Unplug() override { device_.HangUp(); }
  bool tells_stalls() const override { return false; }

 private:
  static constexpr std::uint32_t kSlots = 4, kBytes = 16;
  sim::TempFolder folder_;
  tests::LinkPeer device_{folder_.path() + "/camera.c"};
  SharedMemory memory_ = std::move(*SharedMemory::Make("contract", kSlots* kBytes));
  std::array<bool, kSlots> lent_{};
  std::uint32_t sequence_ = 0;
  std::unique_ptr<ports::Camera> camera_;
};

INSTANTIATE_TEST_SUITE_P(
    Cameras, CameraContract,
    ::testing::Values(
        Implementation<CameraSubject>{"V4l2", [] { return std::make_unique<V4l2Subject>(); }},
        Implementation<CameraSubject>{"Requests", [] { return std::make_unique<RequestSubject>(); }},
        Implementation<CameraSubject>{"Local", [] { return std::make_unique<LocalCameraSubject>(); }}),
    NameOf<CameraSubject>);

}  // namespace
}  // namespace kaori::contracts
