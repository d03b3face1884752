#include "drivers/camera/named_camera.h"

#include <string_view>

namespace kaori::camera {
namespace {

// A name that begins so is libcamera's; behind it stands libcamera's own name of the camera, or nothing.
constexpr std::string_view kLibcamera = "libcamera:";
// Of the plug-in's file, without its folder and its ending.
constexpr const char* kLibcameraPlugin = "kaori-camera-libcamera";

}  // namespace

NamedCamera::NamedCamera(const std::string& device, const Clock& clock) : device_(device), clock_(clock) {
  if (!device.starts_with(kLibcamera)) {
    v4l2_ = std::make_unique<V4l2Source>(device, V4l2Preferences{}, clock);
    return;
  }
  device_.erase(0, kLibcamera.size());
  // A failure is kept, and told by each opening.
  library_ = LoadCameraPlugin(PluginFile(kLibcameraPlugin));
}

ports::CameraOpener NamedCamera::opener() {
  if (v4l2_) return v4l2_->opener();
  return [this]() -> Result<std::unique_ptr<ports::Camera>> {
    if (!library_) return tl::unexpected(library_.error());
    return (*library_)->Open(device_, clock_);
  };
}

ports::CameraTuning* NamedCamera::tuning() {
  if (v4l2_) return v4l2_.get();
  return library_ ? library_->get() : nullptr;
}

Result<std::string> NamedCamera::ModesText() {
  if (v4l2_) return camera::ModesText(device_, {});
  if (!library_) return tl::unexpected(library_.error());
  const auto names = (*library_)->Names();
  if (names.empty()) return std::string("libcamera sees no camera\n");
  std::string text;
  for (const std::string& name : names) text += "  libcamera:" + name + "\n";
  return text;
}

}  // namespace kaori::camera
