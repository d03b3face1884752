// From the lip camera to the board: opens it, measures each frame, and outlives everything a camera does.
#pragma once

#include <functional>
#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/programs/lips/camera_care.h"
#include "appliance/programs/lips/lip_meter.h"
#include "drivers/base/clock.h"
#include "drivers/base/silence_log.h"
#include "drivers/decode/planes.h"
#include "drivers/ports/camera.h"

namespace kaori::lips {

// One thread. Silence of 150 ms, or a camera that is gone, makes the section stale; its sizes hold. A camera
// that is gone is opened anew at once and then every 250 ms, and one that has been silent for 2 s as well.
class LipReader {
 public:
  // Goes on from what `board` holds. Borrows the clock, and the tuning of the camera that `open` opens, where
  // it has one.
  LipReader(ports::CameraOpener open, const board::Board& board, board::Writer<board::Lips> writer,
            const LipSettings& settings, const Clock& clock, ports::CameraTuning* tuning = nullptr);

  // Does everything that waits; never blocks. Call it when pollable() is readable, and every 25 ms or sooner.
  void Step();

  // From the next frame on; the mouth is looked for anew.
  void Use(const LipSettings& settings) { meter_ = LipMeter(settings, meter_.lips()); }

  // Called for each picture once its mouth is on the board; the planes hold only so long. May call Use.
  using Watcher = std::function<void(const decode::Planes& planes, const LipMeter& meter, Time at)>;
  void Watch(Watcher watcher) { watcher_ = std::move(watcher); }

  // The camera's exposure and colours: free for a calibration, held after it.
  CameraCare& care() { return care_; }

  // What was seen last, for a calibration.
  const LipMeter& meter() const { return meter_; }

  // Of the camera that is open; -1 while none is. Another camera may have the same number: see opened().
  int pollable() const { return camera_ ? camera_->pollable() : -1; }
  int opened() const { return opened_; }  // How often a camera was opened.

 private:
  void TryOpen(Time now);
  void HandleFrame(Time now);
  void Measure(const ports::CameraFrame& frame, Time now);
  void Drop(const Error& error, Time now);
  void Close(Time now, std::string_view why);
  void CheckSilence(Time now);
  void Write(Time at, board::SourceState source);

  ports::CameraOpener open_;
  board::Writer<board::Lips> writer_;
  const Clock& clock_;
  LipMeter meter_;
  CameraCare care_;
  decode::PlaneReader planes_;
  std::unique_ptr<ports::Camera> camera_;
  board::SourceState source_;
  ports::CameraFormat format_;
  Time last_frame_;  // When the newest good frame was measured.
  Time last_sign_;   // When the camera was opened, or last gave a good frame.
  Time opened_at_{};
  Time retry_at_{};
  Time quiet_until_{};  // Dropped frames are not logged before.
  SilenceLog silence_log_{"lip camera", "the lips are stale"};
  std::errc logged_{};  // The last trouble that was logged: the same again is not.
  int opened_ = 0;
  Watcher watcher_;
};

}  // namespace kaori::lips
