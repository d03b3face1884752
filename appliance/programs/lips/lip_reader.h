// From the lip camera to the board: opens the camera, measures each frame, and recovers from every failure of
// it. The stamp on the board is the middle of the exposure, as the driver says it, so that whoever reads it
// knows how old the mouth is.
#pragma once

#include <functional>
#include <optional>

#include "appliance/core/board/board.h"
#include "appliance/programs/lips/camera_exposure.h"
#include "appliance/programs/lips/lip_meter.h"
#include "drivers/base/clock.h"
#include "drivers/base/reopening.h"
#include "drivers/base/silence_log.h"
#include "drivers/decode/planes.h"
#include "drivers/ports/camera.h"

namespace kaori::lips {

// Used by one thread. After 150 ms without a frame, or when the camera is gone, the section becomes stale and
// its sizes stay. A camera that is gone, or that sent nothing for 2 s, is opened again at once and then every
// 250 ms, or less often where it opens and sends no frame (Reopening). A damaged frame is dropped; one line in ten
// seconds says so.
class LipReader {
 public:
  // Goes on from what `board` holds; the board is not kept. Borrows the clock, and `tuning`, which belongs to
  // the camera that `open` opens, or is null where that has none.
  LipReader(ports::CameraOpener open, const board::Board& board, board::Writer<board::Lips> writer,
            const LipSettings& settings, const Clock& clock, ports::CameraTuning* tuning = nullptr);

  // Handles a waiting frame and what is due. It never blocks, apart from the time that opening a camera
  // needs. Call it when pollable() is readable, and every 25 ms or sooner.
  void Step();

  // Uses other settings from the next frame on; the mouth is searched in the whole picture again. What is
  // known of the mouth goes on: its rest width, and the sizes until the next picture.
  void Use(const LipSettings& settings) { meter_ = LipMeter(settings, meter_.lips()); }

  // Sets a function that is called for each picture once its mouth is on the board. The planes are valid
  // during the call only. The function may call Use.
  using Watcher = std::function<void(const decode::Planes& planes, const LipMeter& meter, Time at)>;
  void Watch(Watcher watcher) { watcher_ = std::move(watcher); }

  // The camera's exposure and colours, to be freed for a calibration and held after it.
  CameraExposure& exposure() { return exposure_; }

  // The meter with the newest picture's results, for a calibration.
  const LipMeter& meter() const { return meter_; }

  // The descriptor of the open camera; -1 while none is open. Another camera may have the same number: see
  // opened().
  int pollable() const { return camera_ ? camera_->pollable() : -1; }
  int opened() const { return opened_; }  // How often a camera was opened.

 private:
  // Tries to open the camera.
  void TryOpen();
  // Asks the camera for its next frame, and handles what comes or why none does.
  void HandleFrame(Time now);
  // One frame from its bytes to the board.
  void Measure(const ports::CameraFrame& frame, Time now);
  // A damaged frame: what was measured before it stays.
  void Drop(const Error& error, Time now);
  // The camera failed: the section becomes stale and the camera is opened again.
  void Close(const Error& why);
  // A camera that sends nothing: stale after 150 ms, opened again after 2 s.
  void CheckSilence(Time now);
  // Publishes the meter's sizes with this stamp and state.
  void Write(Time at, board::SourceState source);

  // Opens the camera anew each time; what it gives is owned by camera_.
  ports::CameraOpener open_;
  board::Writer<board::Lips> writer_;
  const Clock& clock_;
  LipMeter meter_;
  CameraExposure exposure_;
  // Makes planes of luma and chroma out of any format that the camera sends, a compressed one included.
  decode::PlaneReader planes_;
  std::unique_ptr<ports::Camera> camera_;
  Reopening reopening_;
  // Of the section, as it was written last.
  board::SourceState source_;
  // Of the newest frame, to log a change of it.
  ports::CameraFormat format_;
  Time last_frame_;         // When the newest valid frame was measured.
  Time last_activity_;      // When the camera was opened, or sent its last valid frame.
  Time log_drops_after_{};  // A dropped frame is not logged before this time.
  SilenceLog silence_log_{"lip camera", "the lips are stale"};
  int opened_ = 0;
  // Who looks at each picture after the board was written; may be empty.
  Watcher watcher_;
};

}  // namespace kaori::lips
