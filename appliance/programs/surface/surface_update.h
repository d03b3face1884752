// Brings new firmware onto a control surface that plays, by its HID feature report
// (firmware/wire/surface_feature.h).
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "drivers/base/clock.h"
#include "drivers/base/result.h"
#include "drivers/ports/hid_channel.h"
#include "firmware/wire/dial_box.h"
#include "firmware/wire/stick_pod.h"
#include "firmware/wire/surface_feature.h"

namespace kaori::surface_update {

// NAME.update of ./box firmware: what kBegin wants, and the image.
struct UpdateFile {
  wire::SurfaceImage image;
  std::vector<std::uint8_t> bytes;
};
// Errors: those of ReadFile; invalid_argument, where it is no such file or not all of it.
Result<UpdateFile> ReadUpdateFile(const std::filesystem::path& file);

// Products as updates name them: vendor id * 65536 + product id.
inline constexpr std::uint32_t kDialBoxImage =
    std::uint32_t{wire::kDialBoxVendor} << 16U | wire::kDialBoxProduct;
inline constexpr std::uint32_t kStickPodImage =
    std::uint32_t{wire::kStickPodVendor} << 16U | wire::kStickPodProduct;
inline std::uint32_t ProductOf(const ports::HidIdentity& identity) {
  return std::uint32_t{identity.vendor} << 16U | identity.product;
}

// Versions as updates name them, major * 65536 + minor; and as people do, "1.4".
std::uint32_t VersionOf(const wire::SurfaceStatus& status);
std::string VersionWords(std::uint32_t version);

// What an update has to know of the box.
struct Circumstances {
  bool in_service = false;  // The key switch is on, or there is no stage.
  bool show_runs = false;   // The audience sees the face.
  int dial_boxes = 0;       // That are plugged in now.
};
// Errors: operation_not_permitted, in words: the box is not in service, or this is the last dial box of a
// running show.
Result<void> MayUpdate(const wire::SurfaceImage& image, const Circumstances& now);

// What a surface says of itself. Errors: those of HidChannel::GetFeature; bad_message, where the answer is
// too short.
Result<wire::SurfaceStatus> ReadStatus(ports::HidChannel& channel);

// Why a surface that refuses plays nothing, as the end of a sentence that begins with "it". Empty: it does not
// refuse.
std::string RefusalWords(const wire::SurfaceStatus& status);
// Whether a surface counts as a dial box that plays: one that refuses, or says nothing, takes nobody's place.
bool IsPlayingDialBox(const ports::HidIdentity& identity, const Result<wire::SurfaceStatus>& status);

// Sends, restarts, watches for ten seconds, and confirms. Nothing that happens on the way leaves a dead
// surface: what is not confirmed is given up by the surface itself after three starts. A surface that goes
// away while it is sent to is sent to again, three times at most. One thread; one at a time.
class SurfaceUpdate {
 public:
  enum class State : std::uint8_t { kSending, kRestarting, kTrying, kDone, kFailed };
  static constexpr Duration kProbation = std::chrono::seconds(10);

  // Borrows the bus and the file.
  SurfaceUpdate(ports::HidBus& bus, std::string port, const UpdateFile& file);

  // The next piece of work, to be called every 20 ms or so. It takes as long as the surface needs for its
  // flash, 0.4 s at most.
  void Step(Time now);

  State state() const { return state_; }
  // Of kDone and kFailed: a whole sentence.
  const std::string& outcome() const { return outcome_; }
  std::size_t bytes_sent() const { return sent_; }

 private:
  void Send(Time now);
  Result<void> Begin();
  Result<void> SendPieces();
  void AwaitRestart(Time now);
  void Watch(Time now);
  Result<void> Command(wire::SurfaceOperation operation, std::span<const std::uint8_t> data = {},
                       std::uint32_t offset = 0);
  // The channel of the port, where it is there; opened anew after it went.
  bool HasChannel();
  void Fail(std::string why);
  std::uint32_t version_sent() const { return file_.image.version; }

  ports::HidBus& bus_;
  std::string port_;
  const UpdateFile& file_;
  std::unique_ptr<ports::HidChannel> channel_;
  State state_ = State::kSending;
  std::string outcome_;
  bool begun_ = false;
  std::size_t sent_ = 0;
  int attempts_ = 0;
  int losses_ = 0;     // How often it went away while it was tried.
  Time give_up_at_{};  // While nobody answers.
  Time trying_since_{};
  Time asked_at_{};
};

}  // namespace kaori::surface_update
