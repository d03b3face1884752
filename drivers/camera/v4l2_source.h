// One V4L2 camera over all its openings: which rate the light allows, and what is held still, stay with it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "drivers/camera/v4l2_camera.h"
#include "drivers/camera/v4l2_controls.h"
#include "drivers/ports/camera_tuning.h"

namespace kaori::camera {

// Outlives its openers and cameras. Controls go through a file descriptor of their own, so a camera may be
// gone while they are set: that is no error, the next opening sets them again.
class V4l2Source final : public ports::CameraTuning {
 public:
  // Borrows `clock` and `calls` for its life.
  V4l2Source(std::string path, const V4l2Wish& wish, const Clock& clock, V4l2Calls& calls = KernelCalls());

  // Free, until Set says otherwise. Where the cable is too narrow for a rate, the next slower one is taken.
  // Errors: those of V4l2Camera::Open.
  Result<std::unique_ptr<ports::Camera>> Open();
  ports::CameraOpener opener() {
    return [this] { return Open(); };
  }

  std::string mode() const override;
  std::optional<float> exposure() const override;
  std::vector<std::string> Set(ports::CameraHold hold) override;
  bool Slower() override;

 private:
  Result<std::unique_ptr<V4l2Camera>> OpenFastest();
  std::vector<std::string> Apply();

  std::string path_;
  V4l2Wish wish_;
  const Clock& clock_;
  V4l2Calls& calls_;
  std::optional<V4l2Mode> mode_;
  std::optional<std::vector<V4l2Value>> held_;  // None while free.
};

}  // namespace kaori::camera
