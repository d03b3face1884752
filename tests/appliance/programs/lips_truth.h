// Rendered operators whose mouths are known, measured by the lip meter: how far off it is, and how long it is
// lost. For tests and the bench.
#pragma once

#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "appliance/programs/lips/lip_meter.h"
#include "hw-sim/devices/lip_scene.h"

namespace kaori::lips {

// One way in which an evening may go.
struct Condition {
  std::string name;
  std::function<void(double time_s, sim::LipScene& scene)> play;  // On top of a mouth that speaks.
  LipSettings settings;
  ports::CameraFormat format{640, 480, ports::PixelFormat::kYuyv};
  int jpeg_quality = 85;
  friend void PrintTo(const Condition& condition, std::ostream* out) { *out << condition.name; }
};

// What an ordinary stage does, and what goes beyond it.
std::vector<Condition> NormalSet();
std::vector<Condition> HardSet();

struct Truth {
  std::string name;
  double height_error = 0;  // Mean, in widths of the mouth at rest, of the frames that are believed.
  double width_error = 0;
  double opening_error = 0;
  double longest_loss_ms = 0;
  int frames = 0;
};

// A second at rest, then `frames` frames of speech at 30 a second.
Truth MeasureTruth(const Condition& condition, int frames);

}  // namespace kaori::lips
