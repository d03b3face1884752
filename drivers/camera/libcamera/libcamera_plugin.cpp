// The plug-in kaori-camera-libcamera.so: the cameras that libcamera sees.
#include <stdlib.h>

#include <algorithm>

#include "drivers/camera/camera_plugin.h"
#include "drivers/camera/libcamera/libcamera_device.h"

namespace kaori::camera {
namespace {

// The cameras of this machine as libcamera knows them. It owns the camera manager, of which libcamera permits
// one in a process. All calls come from the loop's thread.
class Libcamera final : public CameraLibrary {
 public:
  bool Start() { return cameras_.start() == 0; }
  ~Libcamera() override { cameras_.stop(); }

  std::vector<std::string> Names() override {
    std::vector<std::string> names;
    for (const auto& camera : cameras_.cameras()) names.push_back(camera->id());
    return names;
  }

  Result<std::unique_ptr<ports::Camera>> Open(const std::string& name, const Clock& clock) override {
    auto camera = Find(name);
    if (!camera) return tl::unexpected(camera.error());
    auto device = LibcameraDevice::Open(std::move(*camera), {.rung = rung_, .hold = hold_});
    if (!device) return tl::unexpected(device.error());
    const RequestStream stream = (*device)->stream();
    mode_ = NameOf(stream.format, (*device)->rate_hz());
    lacks_ = (*device)->lacks();
    times_ = (*device)->times();
    return RequestCamera::Start(std::move(*device), stream, clock);
  }

  std::string mode() const override { return mode_; }
  std::optional<float> exposure() const override { return std::nullopt; }
  std::vector<std::string> Set(ports::CameraHold hold) override {
    hold_.Set(hold);
    return lacks_;
  }
  bool holds() const override { return hold_.holds(); }
  // A camera that was never opened has told no rates, and so has no slower rung.
  bool Slower() override {
    if (!FrameTimeOf(times_, rung_ + 1)) return false;
    ++rung_;
    return true;
  }

 private:
  Result<std::shared_ptr<libcamera::Camera>> Find(const std::string& name) {
    const auto all = cameras_.cameras();
    const auto it =
        std::ranges::find_if(all, [&](const auto& camera) { return name.empty() || camera->id() == name; });
    if (it != all.end()) return *it;
    std::string there;
    for (const std::string& one : Names()) there += (there.empty() ? "" : ", ") + one;
    return Fail(std::errc::no_such_device, "find the camera " + name + " among libcamera's (" +
                                               (there.empty() ? "it sees none" : there) + ")");
  }

  libcamera::CameraManager cameras_;
  LibcameraHold hold_;
  std::size_t rung_ = 0;
  std::string mode_;
  std::vector<std::string> lacks_;
  FrameTimes times_;
};

// The plug-in's entry: called once, from the loop's thread. The caller owns the library.
CameraLibrary* StartLibcamera() {
  // libcamera logs a greeting at each start. What the environment says already counts.
  ::setenv("LIBCAMERA_LOG_LEVELS", "*:ERROR", 0);
  auto library = std::make_unique<Libcamera>();
  return library->Start() ? library.release() : nullptr;
}

}  // namespace
}  // namespace kaori::camera

extern "C" {
extern const kaori::camera::CameraPlugin kaori_camera_plugin;
const kaori::camera::CameraPlugin kaori_camera_plugin{.start = &kaori::camera::StartLibcamera};
}
