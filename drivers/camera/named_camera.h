// The camera that people name: one of V4L2, or one of libcamera, which is a plug-in.
#pragma once

#include <memory>
#include <string>

#include "drivers/camera/camera_plugin.h"
#include "drivers/camera/v4l2_source.h"

namespace kaori::camera {

// Names are "/dev/video0" or the like, "libcamera:NAME", or "libcamera:" for the first camera that
// libcamera sees. A plug-in that cannot be loaded is an error of each opening, so that a program goes on
// without a camera. Must outlive its cameras. One thread.
class NamedCamera {
 public:
  // Loads the plug-in where `device` wants it, which may block; opens no camera. `clock` must outlive it.
  NamedCamera(const std::string& device, const Clock& clock);

  // Opens the camera at each call; borrows this object. Its errors are those of
  // ports::CameraOpener and of LoadCameraPlugin.
  ports::CameraOpener opener();
  // The camera's tuning, which this object owns; null where the plug-in cannot be loaded.
  ports::CameraTuning* tuning();

  // The camera's modes, or libcamera's cameras, as lines for people, each with its end of line. Opens
  // the device for as long as it asks. Errors: as the opener's.
  Result<std::string> ModesText();

 private:
  std::string device_;
  const Clock& clock_;
  std::unique_ptr<V4l2Source> v4l2_;  // Null: the camera is one of the plug-in's.
  Result<std::unique_ptr<CameraLibrary>> library_;
};

}  // namespace kaori::camera
