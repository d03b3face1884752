#include "appliance/programs/lips/lip_reader.h"

#include "drivers/base/log.h"
#include "drivers/base/source.h"

namespace kaori::lips {
namespace {

using std::chrono::milliseconds;

// After that the lips are stale, and the stage looks elsewhere: within 200 ms, with a step every 25 ms and a
// frame of the stage.
constexpr Duration kSilence = milliseconds(150);
constexpr Duration kRetry = milliseconds(250);
constexpr Duration kGiveUp = milliseconds(2000);  // A stream this silent does not come back by itself.
constexpr Duration kQuiet = std::chrono::seconds(10);
constexpr Duration kOldest = milliseconds(150);  // A stamp further off than this is the source's mistake.

}  // namespace

LipReader::LipReader(ports::CameraOpener open, const board::Board& board, board::Writer<board::Lips> writer,
                     const LipSettings& settings, const Clock& clock, ports::CameraTuning* tuning)
    : open_(std::move(open)),
      writer_(std::move(writer)),
      clock_(clock),
      meter_(settings, board.Read<board::Lips>().value),
      care_(tuning),
      source_(board.Read<board::Lips>().source),
      last_frame_(clock.now()),
      last_sign_(clock.now()) {}

void LipReader::Step() {
  const Time now = clock_.now();
  if (!camera_ && now >= retry_at_) TryOpen(now);
  if (camera_) HandleFrame(now);
  CheckSilence(now);
}

void LipReader::TryOpen(Time now) {
  retry_at_ = now + kRetry;
  camera_ = OpenOrLog(open_, logged_);
  if (!camera_) return;
  last_sign_ = opened_at_ = now;
  ++opened_;
  if (logged_ != std::errc::timed_out) Log("lip camera: open");
  care_.Opened();
}

void LipReader::HandleFrame(Time now) {
  const auto frame = camera_->Next();
  if (frame) return Measure(*frame, now);
  switch (frame.error().cause) {
    case std::errc::resource_unavailable_try_again:
      return;
    case std::errc::bad_message:
      return Drop(frame.error(), now);
    default:
      return Close(now, frame.error().message());
  }
}

void LipReader::Measure(const ports::CameraFrame& frame, Time now) {
  const auto planes = planes_.Read(frame);
  if (!planes) return Drop(planes.error(), now);
  if (frame.format != format_)
    Log("lip camera: frames of {} x {}", frame.format.width_px, frame.format.height_px);
  format_ = frame.format;
  const Time at = PlausibleStamp(frame.at, now, kOldest);
  const bool knew_rest = meter_.lips().rest_width > 0;
  meter_.Measure(*planes, at);
  if (!knew_rest && meter_.lips().rest_width > 0)
    Log("lip camera: the mouth at rest is {:.3f} of the picture wide", meter_.lips().rest_width);
  last_frame_ = last_sign_ = now;
  logged_ = {};
  Write(at, board::SourceState::kLive);
  if (watcher_) watcher_(*planes, meter_, at);
  if (!care_.See(*planes, now)) return;
  camera_.reset();
  retry_at_ = now;
}

// A bad cable spoils every other frame: one line now and then tells it.
void LipReader::Drop(const Error& error, Time now) {
  if (now < quiet_until_) return;
  quiet_until_ = now + kQuiet;
  LogWarning("{}; frame dropped", error.message());
}

// A camera that was good is opened anew at once, one that breaks at its opening after a while.
void LipReader::Close(Time now, std::string_view why) {
  camera_.reset();
  retry_at_ = last_frame_ > opened_at_ ? now : now + kRetry;
  LogWarning("{}; opening the lip camera anew", why);
  silence_log_.Lost();
  logged_ = std::errc::no_such_device;
  if (source_ == board::SourceState::kLive) Write(last_frame_, board::SourceState::kStale);
}

void LipReader::CheckSilence(Time now) {
  if (source_ == board::SourceState::kLive && now - last_frame_ >= kSilence) {
    silence_log_.Silent(kSilence, now);
    Write(last_frame_, board::SourceState::kStale);
  }
  if (!camera_ || now - last_sign_ < kGiveUp) return;
  if (logged_ != std::errc::timed_out)
    LogWarning("lip camera: silent for {} s; opening it anew", kGiveUp / milliseconds(1000));
  logged_ = std::errc::timed_out;
  camera_.reset();
  retry_at_ = now;
}

void LipReader::Write(Time at, board::SourceState source) {
  if (source == board::SourceState::kLive && source_ != source) silence_log_.Speaks();
  source_ = source;
  writer_.Write(meter_.lips(), at, source);
}

}  // namespace kaori::lips
