#include "tests/benchmark/opencv_arm.h"

#include <stdexcept>

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace kaori::benchmark {
namespace {

struct Memory {
  cv::Mat mask, labels, stats, centres;
};

// The range of the simulated paint, in light and shade.
const cv::Scalar kLow(0, 150, 0, 70);
const cv::Scalar kHigh(255, 255, 255, 122);

}  // namespace

std::function<void()> OpenCvArm(std::span<const std::uint8_t> yuyv, int width_px, int height_px) {
  cv::setNumThreads(1);
  const cv::Mat frame(height_px, width_px / 2, CV_8UC4, const_cast<std::uint8_t*>(yuyv.data()));
  return [frame, memory = std::make_shared<Memory>()] {
    cv::inRange(frame, kLow, kHigh, memory->mask);
    const int count =
        cv::connectedComponentsWithStats(memory->mask, memory->labels, memory->stats, memory->centres);
    if (count < 2) throw std::runtime_error("OpenCV found no mouth: the comparison is void");
  };
}

}  // namespace kaori::benchmark
