// What the lips are compared with: OpenCV's inRange and connectedComponentsWithStats, on one thread.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

namespace kaori::benchmark {

// Finds the largest patch of blue in a YUYV frame, which it borrows. The frame's four bytes are taken as four
// channels, so nothing is converted before the range is compared. Empty where OpenCV was not there at build.
std::function<void()> OpenCvArm(std::span<const std::uint8_t> yuyv, int width_px, int height_px);

}  // namespace kaori::benchmark
