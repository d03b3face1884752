#include "tests/benchmark/lips_benchmark.h"

#include <algorithm>
#include <random>
#include <stdexcept>

#include <fmt/format.h>

#include "appliance/programs/lips/lip_meter.h"
#include "drivers/base/clock.h"
#include "drivers/decode/planes.h"
#include "hw-sim/devices/lip_camera.h"
#include "tests/appliance/programs/lips_truth.h"
#include "tests/benchmark/figures.h"
#include "tests/benchmark/opencv_arm.h"
#include "tests/benchmark/rounds.h"

namespace kaori::benchmark {
namespace {

constexpr int kRounds = 60;
constexpr int kCalls =
    64;  // A turn is long enough to have its own code and pictures in the cache, not the other arm's.
constexpr std::size_t kPictures = 8;  // Different mouths and noise, drawn before the clock runs.
constexpr int kTruthFrames = 60;

using Picture = std::vector<std::uint8_t>;

std::vector<Picture> Shoot(ports::CameraFormat format) {
  const SteadyClock clock;
  const sim::DeviceContext context{clock, {}};
  sim::LipCamera camera(format, context);
  std::vector<Picture> pictures(kPictures);
  for (std::uint32_t n = 0; n < kPictures; ++n) {
    camera.SetMouth(0.25 + 0.1 * n, 1.2 - 0.1 * n);
    pictures[n].resize(camera.frame_bytes());
    camera.Shoot(n, pictures[n]);
  }
  return pictures;
}

// The worst for runs and regions: by the toss of a coin each sample is paint or grey.
void TossCoins(std::vector<Picture>& pictures) {
  std::mt19937 random(1);
  for (Picture& picture : pictures) {
    for (std::size_t n = 0; n < picture.size(); n += 4) {
      const bool paint = random() % 2 == 0;
      picture[n + 1] = paint ? 200 : 128;
      picture[n + 3] = paint ? 104 : 128;
    }
  }
}

// Pictures as a camera's frames, one after the other.
class Frames {
 public:
  Frames(ports::CameraFormat format, std::vector<Picture> pictures)
      : format_(format), pictures_(std::move(pictures)) {}

  decode::Planes Next() {
    at_ += std::chrono::milliseconds(33);
    const auto stride_bytes = static_cast<std::uint32_t>(format_.width_px) * 2;
    return reader_
        .Read({.at = at_,
               .format = format_,
               .stride_bytes = stride_bytes,
               .bytes = pictures_[next_++ % kPictures]})
        .value();
  }
  Time at() const { return at_; }

 private:
  ports::CameraFormat format_;
  std::vector<Picture> pictures_;
  decode::PlaneReader reader_;
  Time at_ = Time{} + std::chrono::seconds(1);
  std::size_t next_ = 0;
};

// From a frame's bytes to the box that the mouth lies in: what OpenCV is compared with.
class BoxArm {
 public:
  BoxArm(ports::CameraFormat format, std::vector<Picture> pictures) : frames_(format, std::move(pictures)) {}

  Arm arm() {
    return {[this] { FindNext(); }, {}};
  }
  int found() const { return found_; }

 private:
  void FindNext() {
    const decode::Planes planes = frames_.Next();
    mask_.Read(planes, key_);
    const bool any = regions_.Find(mask_);
    if (any && search_.Find(regions_, mask_.grid(), frames_.at()) != nullptr) ++found_;
  }

  Frames frames_;
  lips::PaintKey key_{lips::Paint{}};
  lips::PaintMask mask_;
  lips::Regions regions_;
  lips::MouthSearch search_;
  int found_ = 0;
};

// From a frame's bytes to all sizes of the mouth.
class MeterArm {
 public:
  MeterArm(ports::CameraFormat format, std::vector<Picture> pictures)
      : frames_(format, std::move(pictures)) {}

  Arm arm() {
    return {[this] {
              const decode::Planes planes = frames_.Next();
              meter_.Measure(planes, frames_.at());
            },
            {}};
  }

 private:
  Frames frames_;
  lips::LipMeter meter_{{}, {}};
};

std::vector<double> InMilliseconds(const std::vector<double>& us) {
  std::vector<double> ms;
  for (const double value : us) ms.push_back(value / 1e3);
  return ms;
}

std::vector<Metric> MeasureSpeed(bool quick) {
  const ports::CameraFormat small{640, 480, ports::PixelFormat::kYuyv};
  const ports::CameraFormat large{1280, 720, ports::PixelFormat::kYuyv};
  const auto clean = Shoot(small);
  auto noisy = clean;
  TossCoins(noisy);
  BoxArm ours(small, clean), ours_large(large, Shoot(large)), ours_noisy(small, noisy);
  MeterArm meter(small, clean);
  Arm arm = ours.arm(), arm_large = ours_large.arm(), arm_noisy = ours_noisy.arm(), whole = meter.arm();
  std::vector<std::function<void()>> same;  // Of the same pictures, one after the other.
  for (const Picture& picture : clean)
    if (auto find = OpenCvArm(picture, small.width_px, small.height_px)) same.push_back(std::move(find));
  std::size_t next = 0;
  Arm opencv{[&] { same[next++ % same.size()](); }, {}};
  std::vector<Arm*> arms{&arm, &arm_large, &arm_noisy, &whole};
  if (!same.empty()) arms.push_back(&opencv);
  RunInTurns(arms, kRounds / (quick ? 4 : 1), kCalls);
  if (ours.found() == 0) throw std::runtime_error("no mouth was found: the comparison is void");
  std::vector<Metric> metrics{Figure("lips.640x480_ms", "ms", InMilliseconds(arm.us)),
                              Figure("lips.1280x720_ms", "ms", InMilliseconds(arm_large.us)),
                              Figure("lips.frame_ms", "ms", InMilliseconds(whole.us)),
                              Figure("lips.noise_over_clean", "x", Ratios(arm_noisy.us, arm.us))};
  if (!same.empty())
    metrics.push_back(Figure("lips.opencv_over_ours", "x", Ratios(opencv.us, arm.us)));
  else
    fmt::print(stderr, "lips.opencv_over_ours: NOT MEASURED: built without OpenCV (libopencv-imgproc-dev)\n");
  return metrics;
}

// Over a set: the mean of height and width, and the longest loss in any of it.
std::vector<Metric> MeasureSet(const std::string& name, const std::vector<lips::Condition>& set, bool quick) {
  std::vector<double> errors;
  double longest_ms = 0;
  for (const lips::Condition& condition : set) {
    const lips::Truth truth = lips::MeasureTruth(condition, kTruthFrames / (quick ? 4 : 1));
    errors.push_back(50 * (truth.height_error + truth.width_error));
    longest_ms = std::max(longest_ms, truth.longest_loss_ms);
  }
  double sum = 0;
  for (const double error : errors) sum += error;
  return {{name + "error_percent", "%", sum / static_cast<double>(errors.size()), Quantile(errors, 0.99)},
          {name + "longest_loss_ms", "ms", longest_ms, longest_ms}};
}

}  // namespace

std::vector<Metric> MeasureLips(bool quick) {
  auto metrics = MeasureSpeed(quick);
  for (const Metric& metric : MeasureSet("lips.", lips::NormalSet(), quick)) metrics.push_back(metric);
  for (const Metric& metric : MeasureSet("lips.hard_", lips::HardSet(), quick)) metrics.push_back(metric);
  return metrics;
}

}  // namespace kaori::benchmark
