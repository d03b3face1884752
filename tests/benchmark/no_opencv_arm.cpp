#include "tests/benchmark/opencv_arm.h"

namespace kaori::benchmark {

std::function<void()> OpenCvArm(std::span<const std::uint8_t> /*yuyv*/, int /*width_px*/, int /*height_px*/) {
  return {};
}

}  // namespace kaori::benchmark
