// The simulator's camera: frames in shared memory, told of by packets.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "drivers/base/shared_memory.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/camera.h"
#include "firmware/wire/link_packets.h"

namespace kaori::camera {

class LocalCamera final : public ports::Camera {
 public:
  // Connects to "<folder>/camera.<port>"; until the camera has answered, Next has no new frame. Errors:
  // no_such_device (nobody is there), permission_denied.
  static Result<std::unique_ptr<ports::Camera>> Open(const std::string& folder,
                                                     const std::string& port = "camera");

  // `name` is for errors.
  LocalCamera(UniqueFd socket, std::string name) : socket_(std::move(socket)), name_(std::move(name)) {}

  int pollable() const override { return socket_.get(); }
  Result<ports::CameraFrame> Next() override;

 private:
  Result<void> ReadHello();
  Result<std::optional<wire::CameraFrameNote>> NewestNote();
  Result<ports::CameraFrame> Look(const wire::CameraFrameNote& note);
  void GiveBack(std::uint32_t slot);
  tl::unexpected<Error> ReceiveError(const Error& error) const;

  UniqueFd socket_;
  std::string name_;
  wire::CameraHello hello_;
  SharedMemory memory_;
  std::optional<std::uint32_t> borrowed_;  // The slot whose bytes the caller holds.
  bool broken_ = false;                    // The hello made no sense: nothing after it does.
};

}  // namespace kaori::camera
