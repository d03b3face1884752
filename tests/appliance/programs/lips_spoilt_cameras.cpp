// The two cameras that can be spoilt: the simulator's on the local link, and one behind V4L2's system calls.
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "drivers/camera/local_camera.h"
#include "drivers/camera/v4l2_source.h"
#include "hw-sim/links/local/rig.h"
#include "tests/appliance/programs/lips_faults.h"
#include "tests/drivers/camera_v4l2_fake.h"

namespace kaori::lips {
namespace {

constexpr double kOpenLips = 0.75;
constexpr double kWidth = 0.9;

class SpoiltLocalCamera final : public SpoiltCamera {
 public:
  SpoiltLocalCamera(const std::filesystem::path& folder, const Clock& clock)
      : folder_(folder / "links"), rig_(sim::Rig::Open({.folder = folder_.string()}, clock).value()) {
    rig_->camera().SetMouth(kOpenLips, kWidth);
  }

  Result<std::unique_ptr<ports::Camera>> Open() override { return camera::LocalCamera::Open(folder_); }
  std::span<const Fault> faults() const override {
    static constexpr std::array kAll{Fault::kStall,   Fault::kGone,  Fault::kTorn,     Fault::kGarbage,
                                     Fault::kCovered, Fault::kDrops, Fault::kNewFormat};
    return kAll;
  }
  void Begin(Fault fault, std::uint32_t how) override {
    fault_ = fault;
    if (fault == Fault::kGone) static_cast<void>(rig_->Unplug("camera"));
    rig_->camera().Stall(fault == Fault::kStall);
    rig_->camera().CoverLens(fault == Fault::kCovered);
    if (fault != Fault::kNewFormat) return;
    const bool was_small = rig_->camera().format().width_px == 320;
    const auto pixels = static_cast<ports::PixelFormat>(how % 3);
    rig_->camera().SetFormat(was_small ? ports::CameraFormat{640, 480, pixels}
                                       : ports::CameraFormat{320, 240, pixels});
  }
  void End() override {
    static_cast<void>(rig_->Plug("camera"));
    rig_->camera().Stall(false);
    rig_->camera().CoverLens(false);
    fault_.reset();
  }
  bool Tick() override {
    if (fault_ == Fault::kTorn) rig_->camera().SendGarbage();
    if (fault_ == Fault::kGarbage) rig_->camera().Scramble();
    if (fault_ == Fault::kDrops) rig_->camera().Stall(++ticks_ % 13 < 6);  // 30 ms of 65.
    rig_->Pump();
    return true;  // The socket wakes kaori-lips; to look in vain does no harm.
  }

 private:
  std::filesystem::path folder_;
  std::unique_ptr<sim::Rig> rig_;
  std::optional<Fault> fault_;
  std::uint32_t ticks_ = 0;
};

class SpoiltV4l2Camera final : public SpoiltCamera {
 public:
  explicit SpoiltV4l2Camera(const Clock& clock)
      : clock_(clock), source_("/dev/video0", {}, clock, kernel_), next_(clock.now()) {
    kernel_.offers = {{V4L2_PIX_FMT_YUYV, 30, 640, 480}};
  }

  Result<std::unique_ptr<ports::Camera>> Open() override {
    if (fault_ == Fault::kIoError) kernel_.failing_error = 0;
    return source_.Open();
  }
  std::span<const Fault> faults() const override {
    static constexpr std::array kAll{Fault::kStall,     Fault::kGone,    Fault::kIoError, Fault::kBusy,
                                     Fault::kTorn,      Fault::kDrops,   Fault::kGarbage, Fault::kCovered,
                                     Fault::kNewFormat, Fault::kTimeJump};
    return kAll;
  }
  void Begin(Fault fault, std::uint32_t how) override;
  void End() override;
  bool Tick() override;

 private:
  static constexpr Duration kPeriod = std::chrono::nanoseconds(33'333'333);
  bool Expose();
  std::span<const std::uint8_t> Picture();

  const Clock& clock_;
  tests::FakeV4l2 kernel_;
  camera::V4l2Source source_;
  const sim::DeviceContext bench_{clock_, {}};
  sim::LipCamera lens_{{640, 480, ports::PixelFormat::kYuyv}, bench_};
  std::map<std::pair<int, std::uint32_t>, std::vector<std::uint8_t>> pictures_;  // By width and noise.
  std::vector<std::uint8_t> spoilt_;
  std::optional<Fault> fault_;
  Duration astray_{};
  Time next_;
  std::uint32_t number_ = 0;
};

void SpoiltV4l2Camera::Begin(Fault fault, std::uint32_t how) {
  fault_ = fault;
  constexpr std::array kJumps{std::chrono::milliseconds(-3'600'000), std::chrono::milliseconds(-400),
                              std::chrono::milliseconds(250), std::chrono::milliseconds(86'400'000)};
  if (fault == Fault::kTimeJump) astray_ = kJumps[how % kJumps.size()];
  if (fault == Fault::kGone || fault == Fault::kBusy || fault == Fault::kIoError)
    kernel_.failing_error = fault == Fault::kGone ? ENODEV : EIO;
  if (fault == Fault::kGone) kernel_.open_error = ENOENT;
  if (fault == Fault::kBusy) kernel_.open_error = EBUSY;
  if (fault != Fault::kNewFormat) return;
  const bool was_small = kernel_.chosen().width_px == 320;
  kernel_.gives = {V4L2_PIX_FMT_YUYV, 30, was_small ? 640U : 320U, was_small ? 480U : 240U};
  kernel_.source_changed = true;
}

void SpoiltV4l2Camera::End() {
  kernel_.failing_error = kernel_.open_error = 0;
  astray_ = {};
  fault_.reset();
}

bool SpoiltV4l2Camera::Tick() {
  if (clock_.now() < next_) return false;
  next_ += kPeriod;
  ++number_;
  return Expose();
}

bool SpoiltV4l2Camera::Expose() {
  if (kernel_.failing_error != 0) return true;  // What is broken or gone is readable.
  if (fault_ == Fault::kStall || (fault_ == Fault::kDrops && number_ % 2 != 0)) return false;
  const auto picture = Picture();
  const bool torn = fault_ == Fault::kTorn;
  const auto bytes = static_cast<std::uint32_t>(torn ? number_ % picture.size() : picture.size());
  const Time read_out = clock_.now() - std::chrono::milliseconds(8) + astray_;
  return kernel_.ExposePicture(picture, read_out, bytes, torn && number_ % 2 == 0 ? V4L2_BUF_FLAG_ERROR : 0);
}

std::span<const std::uint8_t> SpoiltV4l2Camera::Picture() {
  const auto width_px = static_cast<int>(kernel_.chosen().width_px);
  auto& picture = pictures_[{width_px, number_ % 4}];
  if (picture.empty()) {
    lens_.SetFormat({width_px, static_cast<int>(kernel_.chosen().height_px), ports::PixelFormat::kYuyv});
    lens_.SetMouth(kOpenLips, kWidth);
    picture.resize(lens_.frame_bytes());
    lens_.Shoot(number_ % 4, picture);
  }
  if (fault_ != Fault::kGarbage && fault_ != Fault::kCovered) return picture;
  spoilt_.assign(picture.size(), fault_ == Fault::kCovered ? 128 : 0);
  if (fault_ == Fault::kGarbage) sim::FillWithNoise(number_, spoilt_);
  return spoilt_;
}

}  // namespace

std::unique_ptr<SpoiltCamera> MakeSpoiltLocalCamera(const std::filesystem::path& folder, const Clock& clock) {
  return std::make_unique<SpoiltLocalCamera>(folder, clock);
}

std::unique_ptr<SpoiltCamera> MakeSpoiltV4l2Camera(const Clock& clock) {
  return std::make_unique<SpoiltV4l2Camera>(clock);
}

}  // namespace kaori::lips
