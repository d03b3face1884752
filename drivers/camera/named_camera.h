// The camera that people name: a device of V4L2, or one of a library that is a plug-in.
#pragma once

#include <memory>
#include <string>

#include "drivers/camera/camera_plugin.h"
#include "drivers/camera/v4l2_source.h"

namespace kaori::camera {

// "/dev/video0", or "libcamera:NAME", or "libcamera:" for the first that libcamera sees. A plug-in that
// cannot be loaded is an error of each opening, so that a program goes on without a camera. Outlives its
// cameras.
class NamedCamera {
 public:
  // Borrows `clock` for its life.
  NamedCamera(const std::string& device, const Clock& clock);

  // Errors: those of ports::CameraOpener and of LoadCameraPlugin.
  ports::CameraOpener opener();
  ports::CameraTuning* tuning();  // Null where there is no camera to tune.

  // What the camera can, or which cameras there are, as lines for people. Errors: as above.
  Result<std::string> ModesText();

 private:
  std::string device_;
  const Clock& clock_;
  std::unique_ptr<V4l2Source> v4l2_;  // Else a plug-in.
  Result<std::unique_ptr<CameraLibrary>> library_;
};

}  // namespace kaori::camera
