#include "appliance/programs/lips/lip_reader.h"

#include "drivers/base/log.h"
#include "drivers/base/source.h"

namespace kaori::lips {
namespace {

using std::chrono::milliseconds;

// After this time the lips are stale. With a step every 25 ms and one frame of the stage the face leaves them
// within 200 ms.
constexpr Duration kSilence = milliseconds(150);
constexpr Duration kGiveUp =
    milliseconds(2000);  // A stream that was silent for this long does not resume by itself.
constexpr Duration kDropLogPeriod = std::chrono::seconds(10);
constexpr Duration kOldest = milliseconds(150);  // An older time of capture is a fault of the driver.

}  // namespace

// Rest width and sizes go on from the board, so that a restart in the middle of a show needs no new second of
// rest. Both times begin now: silence counts from the start of the program.
LipReader::LipReader(ports::CameraOpener open, const board::Board& board, board::Writer<board::Lips> writer,
                     const LipSettings& settings, const Clock& clock, ports::CameraTuning* tuning)
    : open_(std::move(open)),
      writer_(std::move(writer)),
      clock_(clock),
      meter_(settings, board.Read<board::Lips>().value),
      exposure_(tuning),
      reopening_("lip camera", clock, Duration{}),
      source_(board.Read<board::Lips>().source),
      last_frame_(clock.now()),
      last_activity_(clock.now()) {}

// One frame a step: a camera that has more ready is readable again at once, and the board and the loudspeaker
// get their turn in between.
void LipReader::Step() {
  if (!camera_ && reopening_.IsDue(clock_.now())) TryOpen();
  const Time now = clock_.now();  // The opening may have taken long.
  if (camera_) HandleFrame(now);
  CheckSilence(now);
}

// Silence counts from the end of the opening.
void LipReader::TryOpen() {
  camera_ = reopening_.Open(open_);
  if (!camera_) return;
  last_activity_ = clock_.now();
  ++opened_;
  exposure_.Opened();
}

// A frame that is damaged says nothing of the next one; any other failure says that the stream is over.
void LipReader::HandleFrame(Time now) {
  const auto frame = camera_->Next();
  if (frame) return Measure(*frame, now);
  switch (frame.error().cause) {
    case std::errc::resource_unavailable_try_again:
      return;
    case std::errc::bad_message:
      return Drop(frame.error(), now);
    default:
      return Close(frame.error());
  }
}

// The section is written before anybody else looks at the picture: the face comes first. The frame is given
// back to the camera when this returns.
void LipReader::Measure(const ports::CameraFrame& frame, Time now) {
  const auto planes = planes_.Read(frame);
  if (!planes) return Drop(planes.error(), now);
  if (frame.format != format_)
    Log("lip camera: the frames have {} x {} pixels", frame.format.width_px, frame.format.height_px);
  format_ = frame.format;
  const Time at = PlausibleStamp(frame.at, now, kOldest);
  const bool knew_rest = meter_.lips().rest_width > 0;
  meter_.Measure(*planes, at);
  if (!knew_rest && meter_.lips().rest_width > 0)
    Log("lip camera: the mouth at rest is {:.3f} of the picture wide", meter_.lips().rest_width);
  last_frame_ = last_activity_ = now;
  reopening_.NoteDelivery();
  Write(at, board::SourceState::kLive);
  if (watcher_) watcher_(*planes, meter_, at);
  if (exposure_.Observe(*planes, now)) reopening_.Close(camera_);
}

// A bad cable may damage every other frame, so that only one line in ten seconds says so.
void LipReader::Drop(const Error& error, Time now) {
  if (now < log_drops_after_) return;
  log_drops_after_ = now + kDropLogPeriod;
  LogWarning("{}; the frame is dropped", error.message());
}

// A camera that had sent frames is opened again at once; one that fails as it is opened has to wait.
void LipReader::Close(const Error& why) {
  reopening_.Close(camera_, why);
  silence_log_.Lost();
  if (source_ == board::SourceState::kLive) Write(last_frame_, board::SourceState::kStale);
}

// The stamp stays that of the last picture, so that readers see how old the mouth is.
void LipReader::CheckSilence(Time now) {
  if (source_ == board::SourceState::kLive && now - last_frame_ >= kSilence) {
    silence_log_.Silent(kSilence, now);
    Write(last_frame_, board::SourceState::kStale);
  }
  if (!camera_ || now - last_activity_ < kGiveUp) return;
  reopening_.Close(camera_,
                   {.cause = std::errc::timed_out,
                    .attempt = fmt::format("lip camera: no frame for {} s", kGiveUp / milliseconds(1000)),
                    .kind = ErrorKind::kInput});
}

// The end of a silence is logged where its beginning was (SilenceLog).
void LipReader::Write(Time at, board::SourceState source) {
  if (source == board::SourceState::kLive && source_ != source) silence_log_.Speaks();
  source_ = source;
  writer_.Write(meter_.lips(), at, source);
}

}  // namespace kaori::lips
