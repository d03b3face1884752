// A lip camera with rendered pictures of an operator, thirty a second; the test moves the mouth and the
// paint.
#pragma once

#include <sys/eventfd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "drivers/base/unique_fd.h"
#include "drivers/ports/camera.h"
#include "hw-sim/devices/lip_scene.h"

namespace kaori::tests {

// What the test changes; it outlives the camera.
struct OperatorHand {
  sim::LipScene scene;
  bool plugged = true;
};

class OperatorCamera final : public ports::Camera {
 public:
  static constexpr int kWidth_px = 320;
  static constexpr int kHeight_px = 240;

  OperatorCamera(OperatorHand& hand, const Clock& clock)
      : hand_(hand), clock_(clock), event_(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)), due_(clock.now()) {}

  static ports::CameraOpener Opener(OperatorHand& hand, const Clock& clock) {
    return [&hand, &clock]() -> Result<std::unique_ptr<ports::Camera>> {
      if (!hand.plugged) return Fail(std::errc::no_such_device, "open the operator's camera");
      return std::make_unique<OperatorCamera>(hand, clock);
    };
  }

  int pollable() const override { return event_.get(); }

  Result<ports::CameraFrame> Next() override {
    constexpr Duration kPeriod = std::chrono::microseconds(33'333);
    if (!hand_.plugged) return Fail(std::errc::no_such_device, "the operator's camera");
    const Time now = clock_.now();
    if (now < due_) return Fail(std::errc::resource_unavailable_try_again, "the operator's camera");
    due_ = std::max(due_ + kPeriod, now - kPeriod);
    hand_.scene.camera.sequence++;
    return ports::CameraFrame{.at = now,
                              .sequence = hand_.scene.camera.sequence,
                              .format = {kWidth_px, kHeight_px, ports::PixelFormat::kYuyv},
                              .stride_bytes = kWidth_px * 2,
                              .bytes = Picture()};
  }

 private:
  // What a picture shows apart from its noise. Four pictures of each are drawn and repeated.
  struct Rendered {
    sim::Mouth mouth;
    float red, green, blue;
    double light;
    bool operator==(const Rendered&) const = default;
  };

  const std::vector<std::uint8_t>& Picture() {
    const auto& [person, before, light, lens] = hand_.scene;
    const Rendered rendered{person.mouth, person.paint.red, person.paint.green, person.paint.blue,
                            light.level};
    if (rendered != seen_) drawn_ = 0;
    seen_ = rendered;
    auto& picture = pictures_[next_++ % pictures_.size()];
    if (drawn_ == pictures_.size()) return picture;
    ++drawn_;
    picture.resize(std::size_t{2} * kWidth_px * kHeight_px);
    sim::PaintScene(hand_.scene, {kWidth_px, kHeight_px, picture});
    return picture;
  }

  OperatorHand& hand_;
  const Clock& clock_;
  UniqueFd event_;
  Time due_;
  Rendered seen_{};
  std::size_t drawn_ = 0;
  std::size_t next_ = 0;
  std::array<std::vector<std::uint8_t>, 4> pictures_;
};

}  // namespace kaori::tests
