// One V4L2 camera over all of its openings: the rate that the light allows, and what is held, are kept.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/camera/v4l2_camera.h"
#include "drivers/camera/v4l2_controls.h"
#include "drivers/ports/camera_tuning.h"

namespace kaori::camera {

// Must outlive its openers and cameras. Controls are set through a file descriptor of their own: V4L2
// lets several descriptors set controls while one of them streams. That the camera is gone meanwhile is
// no error: the next opening sets them again. One thread.
class V4l2Source final : public ports::CameraTuning {
 public:
  // `clock` and `calls` must outlive it.
  V4l2Source(std::string path, const V4l2Preferences& preferences, const Clock& clock,
             V4l2Calls& calls = KernelCalls());

  // Opens the camera with its automatics on, or held as Set says. Where the USB bus has not room for a
  // rate, the next slower one is used, now and later. Blocks as V4l2Camera::Open does, for each rate
  // that is tried. Errors: those of V4l2Camera::Open.
  Result<std::unique_ptr<ports::Camera>> Open();
  // Borrows this object.
  ports::CameraOpener opener() {
    return [this] { return Open(); };
  }

  // As ports::CameraTuning says. Each opens the device node for as long as it asks.
  std::string mode() const override;
  std::optional<float> exposure() const override;
  std::vector<std::string> Set(ports::CameraHold hold) override;
  bool holds() const override { return held_.has_value(); }
  bool Slower() override;

 private:
  // The camera at the fastest rate that its bus has room for. Errors: those of V4l2Camera::Open.
  Result<std::unique_ptr<V4l2Camera>> OpenFastest();
  // Sets the controls as they are to be; returns what was refused. Nothing where the camera is gone.
  std::vector<std::string> Apply();

  std::string path_;
  V4l2Preferences preferences_;
  const Clock& clock_;
  V4l2Calls& calls_;
  // The mode of the camera that was opened last; none before.
  std::optional<V4l2Mode> mode_;
  // Values that were read when the show was held, and the name of the model that they are of: they mean nothing to
  // another one.
  struct Held {
    std::string model;
    std::vector<V4l2Value> values;
  };
  // None while free. An opening sets them again.
  std::optional<Held> held_;
};

}  // namespace kaori::camera
