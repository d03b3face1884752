// How long the mouth takes to be measured in a camera's frame, and how far the measure is off.
#pragma once

#include "tests/benchmark/metric.h"

namespace kaori::benchmark {

// lips.640x480_ms, lips.1280x720_ms: one YUYV frame of the simulated lip camera, from its bytes to the box that the
//   mouth lies in. lips.frame_ms: to all sizes of the mouth, at 640x480.
// lips.noise_over_clean: how much longer the box takes where half the samples are paint by the toss of a coin.
// lips.opencv_over_ours: how much longer OpenCV's inRange and connectedComponentsWithStats take for the box; said aloud
//   to be missing where OpenCV is.
// lips.error_percent: of the normal set of rendered operators, in hundredths of the mouth's width; its p99 is
//   the worst condition's. lips.longest_loss_ms: the longest time without a mouth in any of them.
// lips.hard_error_percent, lips.hard_longest_loss_ms: the same of the hard set, as it is.
std::vector<Metric> MeasureLips(bool quick);

// lips.motion_to_board_ms, lips.motion_to_board_60_ms: from the lips' motion before a camera of 30, of 60
// frames a second to the board, by kaori-lips as it runs on a box. The simulator's time to draw the frame is
// in it.
std::vector<Metric> MeasureLipMotion(bool quick);

}  // namespace kaori::benchmark
