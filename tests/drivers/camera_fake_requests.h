// A fake camera library: it completes the requests that are queued when a test says so.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <vector>

#include "drivers/camera/libcamera/request_camera.h"

namespace kaori::tests {

inline constexpr std::uint32_t kRequestBytes = 320 * 240 * 2;

inline camera::RequestStream FakeStream() {
  return {.name = "imx219",
          .format = {320, 240, ports::PixelFormat::kYuyv},
          .stride_bytes = 640,
          .frame_bytes = kRequestBytes};
}

class FakeRequests final : public camera::RequestDevice {
 public:
  camera::Completions& completions() override { return completions_; }
  std::uint32_t buffers() const override { return 4; }
  std::span<const std::uint8_t> memory(std::uint32_t buffer) const override { return memory_[buffer]; }
  Result<void> Queue(std::uint32_t buffer) override {
    if (refuses) return Fail(std::errc::no_such_device, "queue");
    EXPECT_TRUE(queued.insert(buffer).second) << "queued twice";
    return {};
  }

  // Completes a request with a picture of this grey. False: none is queued, and the frame is lost.
  bool Fill(std::uint8_t grey, Time at, bool whole = true, std::uint32_t bytes = kRequestBytes) {
    ++sequence_;
    if (queued.empty()) return false;
    const std::uint32_t buffer = *queued.begin();
    queued.erase(queued.begin());
    memory_[buffer].assign(kRequestBytes, grey);
    completions_.Add({buffer, whole, bytes, sequence_ - 1, at});
    return true;
  }

  bool refuses = false;
  std::set<std::uint32_t> queued;

 private:
  camera::Completions completions_;
  std::array<std::vector<std::uint8_t>, 4> memory_;
  std::uint32_t sequence_ = 0;
};

}  // namespace kaori::tests
