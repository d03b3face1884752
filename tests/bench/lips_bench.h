// How long the mouth takes to be measured in a camera's frame, and how far the measure is off.
#pragma once

#include "tests/bench/metric.h"

namespace kaori::bench {

// lips.640x480_ms, lips.1280x720_ms: one YUYV frame of the simulated lip camera, from its bytes to all sizes.
// lips.noise_over_clean: how much longer it takes where half the samples are paint by the toss of a coin.
// lips.opencv_over_ours: how much longer OpenCV's inRange and connectedComponentsWithStats take for the box
// alone;
//   said aloud to be missing where OpenCV is.
// lips.error_percent: of the normal set of rendered operators, in hundredths of the mouth's width; its p99 is
// the
//   worst condition's. lips.longest_loss_ms: the longest time without a mouth in any of them.
std::vector<Metric> MeasureLips(bool quick);

}  // namespace kaori::bench
