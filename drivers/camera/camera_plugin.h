// The interface of cameras whose library a box need not have:
// a plug-in, which is loaded when such a camera is named.
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

// All cameras of one library, and their tuning: that of the camera that was opened last. A library is
// started once and lives as long as the program needs cameras. One thread.
class CameraLibrary : public ports::CameraTuning {
 public:
  // The library's own names of its cameras, as people give them behind "libcamera:"; empty
  // where it sees none. Does not open them.
  virtual std::vector<std::string> Names() = 0;

  // Opens the camera of this name, or the first one where `name` is empty. `clock` must outlive the camera,
  // and the camera must end before the library. Errors:
  //   no_such_device           there is no such camera; the attempt says which there are
  //   device_or_resource_busy  another program uses it
  //   not_supported            it has no format that we read
  //   io_error                 any other failure of the library
  virtual Result<std::unique_ptr<ports::Camera>> Open(const std::string& name, const Clock& clock) = 0;
};

// What a plug-in exports with C linkage under the name kSymbol. Program and plug-in are built
// together: kVersion is raised with every change of the interface between them, since C++
// classes cross it and a mismatch would crash.
struct CameraPlugin {
  // Raised with every change of CameraPlugin, CameraLibrary or the ports that they use.
  static constexpr std::uint32_t kVersion = 2;
  // The name that dlsym(3) looks for: a variable of the type CameraPlugin.
  static constexpr const char* kSymbol = "kaori_camera_plugin";
  // First, and of fixed size: it can be read whatever the rest of the struct has become.
  std::uint32_t version = kVersion;
  CameraLibrary* (*start)() = nullptr;  // The caller owns the result. Null: the library does not start.
};

// Loads the plug-in `file` and starts its library; blocks for the disk and for the library, some tenths
// of a second. The file stays loaded until the program ends. Errors:
//   not_supported  it cannot be loaded, is no plug-in of ours, or of another version; the attempt says why
//   io_error       its library does not start
Result<std::unique_ptr<CameraLibrary>> LoadCameraPlugin(const std::string& file);

// The path of the plug-in `name`: beside the program's own file, whether or not there
// is one. Never from the environment.
std::string PluginFile(const std::string& name);

}  // namespace kaori::camera
