#include "drivers/camera/v4l2_source.h"

#include <linux/videodev2.h>

#include <algorithm>

namespace kaori::camera {
namespace {

// The model's name, as the camera tells it: "HD Pro Webcam C920". Empty where it does not.
std::string ModelOf(V4l2Calls& calls, int fd) {
  v4l2_capability capability{};
  if (calls.Ioctl(fd, VIDIOC_QUERYCAP, &capability) != 0) return {};
  const auto end = std::ranges::find(capability.card, __u8{0});
  return {std::begin(capability.card), end};
}

}  // namespace

V4l2Source::V4l2Source(std::string path, const V4l2Preferences& preferences, const Clock& clock,
                       V4l2Calls& calls)
    : path_(std::move(path)), preferences_(preferences), clock_(clock), calls_(calls) {}

Result<std::unique_ptr<ports::Camera>> V4l2Source::Open() {
  auto camera = OpenFastest();
  if (!camera) return tl::unexpected(camera.error());
  mode_ = (*camera)->format().mode;
  Apply();  // After the stream has started: some cameras forget their controls then.
  return camera;
}

// Every rung tries less of the cable: a camera that shares its USB bus gets what is left. The
// kernel answers VIDIOC_STREAMON with ENOSPC where the bus has no room for the stream; any other
// error would be the same at a slower rate.
Result<std::unique_ptr<V4l2Camera>> V4l2Source::OpenFastest() {
  for (;;) {
    auto camera = V4l2Camera::Open(path_, preferences_, clock_, calls_);
    const bool narrow = !camera && camera.error().cause == std::errc::no_space_on_device;
    if (!narrow || !Slower()) return camera;
  }
}

// Through a descriptor of its own: the stream's belongs to the camera, which may be gone. A camera that does not
// tell its model now may be the one before.
std::vector<std::string> V4l2Source::Apply() {
  const UniqueFd fd = calls_.Open(path_);
  if (!fd.valid()) return {};
  const std::string model = ModelOf(calls_, fd.get());
  if (held_ && !model.empty() && model != held_->model) held_.reset();
  if (mode_) FitMains(calls_, fd.get(), mode_->rate_hz());
  return held_ ? HoldControls(calls_, fd.get(), held_->values) : FreeControls(calls_, fd.get());
}

std::string V4l2Source::mode() const {
  return mode_ ? NameOf(*mode_) : std::string();
}

// Opens the device anew for the question, which V4L2 allows beside the one that streams. Nothing: no camera,
// or none that tells its exposure.
std::optional<float> V4l2Source::exposure() const {
  const UniqueFd fd = calls_.Open(path_);
  const auto exposure_s = fd.valid() ? ExposureSeconds(calls_, fd.get()) : std::nullopt;
  if (!exposure_s || !mode_ || mode_->rate_hz() == 0) return std::nullopt;
  // The part of a frame's time: both are in seconds and frames a second.
  return static_cast<float>(*exposure_s * mode_->rate_hz());
}

// What the automatics have found is kept as values: each opening writes them again, also after a re-plug. A
// camera that is away keeps what was held before.
std::vector<std::string> V4l2Source::Set(ports::CameraHold hold) {
  if (hold == ports::CameraHold::kFree) {
    held_.reset();
  } else if (const UniqueFd fd = calls_.Open(path_); fd.valid()) {
    held_ = {ModelOf(calls_, fd.get()), ReadControls(calls_, fd.get())};
  }
  return Apply();
}

// The ladder is made anew each time, of the modes of the camera that is plugged in now.
bool V4l2Source::Slower() {
  const UniqueFd fd = calls_.Open(path_);
  const auto modes = fd.valid() ? ListModes(calls_, fd.get()) : Result<std::vector<V4l2Mode>>();
  if (!modes || preferences_.rung + 1 >= LadderOf(*modes, preferences_).size()) return false;
  ++preferences_.rung;
  return true;
}

}  // namespace kaori::camera
