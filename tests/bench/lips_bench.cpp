#include "tests/bench/lips_bench.h"

#include <algorithm>

#include "appliance/lips/lip_meter.h"
#include "drivers/base/clock.h"
#include "drivers/camera/planes.h"
#include "hw-sim/devices/lip_camera.h"

namespace kaori::bench {
namespace {

constexpr int kFrames = 1000;
constexpr int kPictures = 8;  // Different mouths and noise, drawn before the clock runs.

std::vector<std::vector<std::uint8_t>> Shoot(sim::LipCamera& camera) {
  std::vector<std::vector<std::uint8_t>> pictures(kPictures);
  for (std::uint32_t n = 0; n < kPictures; ++n) {
    camera.SetMouth(0.25 + 0.1 * n, 1.2 - 0.1 * n);
    pictures[n].resize(camera.frame_bytes());
    camera.Shoot(n, pictures[n]);
  }
  return pictures;
}

double At(std::vector<double>& sorted, double part) {
  return sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

}  // namespace

std::vector<Metric> MeasureLips(bool quick) {
  const SteadyClock clock;
  const sim::Workbench bench{clock, {}};
  sim::LipCamera camera({640, 480, ports::PixelFormat::kYuyv}, bench);
  const auto pictures = Shoot(camera);
  lips::LipMeter meter({}, {});
  camera::PlaneReader reader;
  std::vector<double> took_ms;
  for (int i = 0; i < kFrames / (quick ? 10 : 1); ++i) {
    const ports::CameraFrame frame{.at = clock.now(),
                                   .format = camera.format(),
                                   .stride_bytes = camera.stride_bytes(),
                                   .bytes = pictures[static_cast<std::size_t>(i) % pictures.size()]};
    const Time begin = clock.now();
    const auto planes = reader.Read(frame);
    meter.Measure(*planes, frame.at);
    took_ms.push_back(1e3 * Seconds(clock.now() - begin));
  }
  std::ranges::sort(took_ms);
  return {{"lips.640x480_ms", "ms", At(took_ms, 0.5), At(took_ms, 0.99)}};
}

}  // namespace kaori::bench
