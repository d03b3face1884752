// The seam to cameras that come from a library which a box need not have: a shared object of their own,
// loaded when such a camera is named.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/ports/camera.h"
#include "drivers/ports/camera_tuning.h"

namespace kaori::camera {

// All cameras of one library; its tuning is that of the camera which was opened last. One thread.
class CameraLibrary : public ports::CameraTuning {
 public:
  // By the library's own names; empty where it sees none.
  virtual std::vector<std::string> Names() = 0;

  // An empty name takes the first. Borrows `clock`; the camera ends before the library. Errors:
  // no_such_device (says which there are), device_or_resource_busy, not_supported, io_error.
  virtual Result<std::unique_ptr<ports::Camera>> Open(const std::string& name, const Clock& clock) = 0;
};

// What a plug-in exports, in C: a struct of this name. Program and plug-in are built together: the number is
// raised with every change of what passes between them.
struct CameraPlugin {
  static constexpr std::uint32_t kVersion = 1;
  static constexpr const char* kSymbol = "kaori_camera_plugin";
  std::uint32_t version = kVersion;
  CameraLibrary* (*start)() = nullptr;  // The caller's to delete. Null where the library does not start.
};

// Loads the plug-in `file` and starts its library. What was loaded stays until the program ends. Errors:
//   not_supported  it cannot be loaded, or is none of ours, or of another version: the attempt says why
//   io_error       its library does not start
Result<std::unique_ptr<CameraLibrary>> LoadCameraPlugin(const std::string& file);

// Where the plug-in `name` lies: beside the program.
std::string PluginFile(const std::string& name);

}  // namespace kaori::camera
