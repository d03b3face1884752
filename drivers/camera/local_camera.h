// The simulator's camera: frames in shared memory, announced by packets.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "drivers/base/shared_memory.h"
#include "drivers/base/unique_fd.h"
#include "drivers/ports/camera.h"
#include "firmware/wire/link_packets.h"

namespace kaori::camera {

// As ports::Camera, over the local link (firmware/wire/link.h). A slot of the shared memory
// is the caller's from Next to Next and then goes back to the simulator, which must not
// write into it meanwhile. One thread.
class LocalCamera final : public ports::Camera {
 public:
  // Connects to the socket "<folder>/camera.<port>". Until the camera has answered, Next says
  // resource_unavailable_try_again. Errors: no_such_device (nobody listens), permission_denied.
  static Result<std::unique_ptr<ports::Camera>> Open(const std::string& folder,
                                                     const std::string& port = "camera");

  // `name` is for errors.
  LocalCamera(UniqueFd socket, std::string name) : socket_(std::move(socket)), name_(std::move(name)) {}

  int pollable() const override { return socket_.get(); }
  Result<ports::CameraFrame> Next() override;

 private:
  // Reads the hello, and maps the memory that came with it. Errors: as Next.
  Result<void> ReadHello();
  // The newest frame packet that waits. Errors: as Next.
  Result<std::optional<wire::CameraFrameNote>> NewestNote();
  // The frame that a note announces, once its numbers were checked. Errors: bad_message.
  Result<ports::CameraFrame> Borrow(const wire::CameraFrameNote& note);
  // Tells the simulator that the slot is free again.
  void GiveBack(std::uint32_t slot);
  tl::unexpected<Error> ReceiveError(const Error& error) const;

  UniqueFd socket_;
  std::string name_;
  // How many slots there are, and how long each is.
  wire::CameraHello hello_;
  // All slots, read only by agreement: the simulator writes into those that are not lent.
  SharedMemory memory_;
  std::optional<std::uint32_t> borrowed_;  // The slot whose bytes the caller reads.
  bool broken_ = false;                    // The hello made no sense.
};

}  // namespace kaori::camera
