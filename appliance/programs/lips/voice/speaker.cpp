#include "appliance/programs/lips/voice/speaker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "appliance/core/board/snapshot.h"
#include "drivers/base/log.h"

namespace kaori::voice {
namespace {

using std::chrono::milliseconds;

// The pause before a loudspeaker that had played is opened again.
constexpr Duration kSpeakerAfterLoss = milliseconds(250);
// How much sound waits in the device, which is how late the program may be. A device that ran dry gets more,
// and that shrinks again by a millisecond each second.
constexpr Duration kMinLead = milliseconds(20), kMoreLead = milliseconds(10), kMaxLead = milliseconds(50);
constexpr int kLeadDecay = 1000;
constexpr Duration kPlayoutGap =
    milliseconds(10);                   // A larger change of the playout time is a gap and no jitter.
constexpr double kPlayoutShare = 0.05;  // The weight of a new playout time.
// A device that has accepted nothing for this long is closed and opened again: some drivers say "later" for
// ever after a cable was pulled.
constexpr Duration kStuck = milliseconds(1000);
// A device that plays nothing accepts sound all the same, until its buffer is full. One that has accepted half of
// this time and of all that follows plays.
constexpr Duration kPlays = milliseconds(400);
constexpr Duration kPublishPeriod = milliseconds(100);
constexpr Duration kDelayLogPeriod = std::chrono::seconds(10);  // Between two log lines about the delay.
// 0.1 s at most in one step: more than is ever wanted, and a bound for a device that accepts without end.
constexpr int kChunksAtOnce = 40;

float Ms(Duration time) {
  return static_cast<float>(Seconds(time) * 1e3);
}

// What is louder than full scale is cut and does not wrap; -32768 is never given, so that the scale is even.
std::int16_t Sample16(float sample) {
  return static_cast<std::int16_t>(std::lround(32767 * std::clamp(sample, -1.0F, 1.0F)));
}

}  // namespace

// A chunk has up to eight channels without another allocation.
Speaker::Speaker(ports::LoudspeakerOpener open, const board::Board& board, board::Writer<board::Sound> writer,
                 SpeakerSettings settings, const Clock& clock)
    : open_(std::move(open)),
      board_(board),
      writer_(std::move(writer)),
      clock_(clock),
      choice_(settings.delay, board.Read<board::Sound>()),
      motion_sound_(std::move(settings.clips)),
      reopening_("loudspeaker", clock, kSpeakerAfterLoss) {
  chunk_.reserve(kChunk * 8);
}

// The delay is chosen and the motion followed in each step, with a loudspeaker and without one.
void Speaker::Step() {
  motion_sound_.Follow(board_.Read<board::MotionNow>());
  choice_.Choose(board::ReadAll(board_), clock_.now());
  if (!loudspeaker_ && reopening_.IsDue(clock_.now())) TryOpen();
  const Time now = clock_.now();  // The opening may have taken long.
  if (loudspeaker_) Fill(now);
  if (now - published_at_ >= kPublishPeriod) Publish(now);
}

// Nothing is known yet of when a frame will be heard: the first chunks are silent and find that out.
void Speaker::TryOpen() {
  loudspeaker_ = reopening_.Open(open_);
  if (!loudspeaker_) return;
  heard_next_.reset();
  chunk_.clear();
  pushed_ = 0;
  opened_at_ = stuck_since_ = filled_at_ = clock_.now();
  accepted_ = {};
}

// Keeps `lead_` of sound in the device beyond its own latency. What is written cannot be taken back, so that
// more of it would make every change of the delay later.
void Speaker::Fill(Time now) {
  lead_ = std::max(lead_ - (now - filled_at_) / kLeadDecay, kMinLead);
  filled_at_ = now;
  for (int n = 0; n < kChunksAtOnce && loudspeaker_; ++n) {
    const bool enough = heard_next_ && *heard_next_ >= now + depth_ + lead_;
    if (pushed_ == chunk_.size() && enough) return;
    if (!WriteChunk()) break;
  }
  if (loudspeaker_ && now - stuck_since_ > kStuck)
    Close({.cause = std::errc::timed_out,
           .attempt = "loudspeaker: the device accepts no sound",
           .kind = ErrorKind::kInput});
}

// Makes the next chunk, unless one still waits, and writes it. Returns false where the device has no room
// now. A device with one channel gets the mean of left and right; channels beyond the second repeat the right
// one.
bool Speaker::WriteChunk() {
  if (pushed_ == chunk_.size()) {
    Mix();
    const auto channels = static_cast<std::size_t>(loudspeaker_->format().channels);
    chunk_.clear();
    pushed_ = 0;
    for (std::size_t frame = 0; frame < kChunk; ++frame)
      for (std::size_t channel = 0; channel < channels; ++channel)
        chunk_.push_back(Sample16(channels == 1 ? (mixed_[2 * frame] + mixed_[2 * frame + 1]) / 2
                                                : mixed_[2 * frame + std::min<std::size_t>(channel, 1)]));
  }
  return Push();
}

// A chunk is silent while it is unknown when it will be heard.
void Speaker::Mix() {
  mixed_.fill(0);
  if (!heard_next_) return;
  line_.Read(voice_, *heard_next_, choice_.chosen());
  for (std::size_t frame = 0; frame < kChunk; ++frame)
    mixed_[2 * frame] = mixed_[2 * frame + 1] = voice_[frame];
  motion_sound_.Mix(mixed_, *heard_next_);
  *heard_next_ += FromSeconds(static_cast<double>(kChunk) / kSoundRate_hz);
}

// Writes what is left of the chunk; false where the device took less, or failed.
bool Speaker::Push() {
  const auto channels = static_cast<std::size_t>(loudspeaker_->format().channels);
  const auto playout = loudspeaker_->Write(std::span<const std::int16_t>(chunk_).subspan(pushed_));
  if (!playout) {
    if (playout.error().cause != std::errc::resource_unavailable_try_again) Close(playout.error());
    return false;
  }
  pushed_ += playout->frames * channels;
  NotePlayout(*playout);
  return pushed_ == chunk_.size();
}

// The device says when the frames that it accepted will be heard; the next frame is heard after the last of
// them. The time is smoothed, since drivers' times jitter; a gap, or a buffer that ran dry, sets it anew.
void Speaker::NotePlayout(const ports::Playout& playout) {
  const Time now = clock_.now();
  stuck_since_ = now;
  source_ = board::SourceState::kLive;
  accepted_ += FromSeconds(static_cast<double>(playout.frames) / kSoundRate_hz);
  if (now - opened_at_ >= kPlays && 2 * accepted_ >= now - opened_at_) {
    reopening_.NoteDelivery();
    if (!std::exchange(told_that_it_plays_, true)) Log("loudspeaker: playing");
  }
  const auto channels = static_cast<std::size_t>(loudspeaker_->format().channels);
  const std::size_t left = (chunk_.size() - pushed_) / channels;
  const Time next = playout.at + FromSeconds(static_cast<double>(playout.frames + left) / kSoundRate_hz);
  if (playout.xrun) {
    ++sound_.xruns;
    lead_ = std::min(lead_ + kMoreLead, kMaxLead);
  }
  if (!heard_next_) depth_ = std::max(playout.at - now, Duration{});
  const Duration off = heard_next_ ? next - *heard_next_ : Duration{};
  if (!heard_next_ || playout.xrun || off > kPlayoutGap || off < -kPlayoutGap)
    heard_next_ = next;
  else
    *heard_next_ += FromSeconds(Seconds(off) * kPlayoutShare);
}

// The section becomes stale at once: the status says so to whoever looks.
void Speaker::Close(const Error& why) {
  reopening_.Close(loudspeaker_, why);
  told_that_it_plays_ = false;
  if (source_ != board::SourceState::kLive) return;
  source_ = board::SourceState::kStale;
  Publish(clock_.now());
}

// The delay is bounded for the board: a device that lies about its latency must not make the section invalid.
void Speaker::Publish(Time now) {
  published_at_ = now;
  sound_.delay_ms = std::clamp(Ms(line_.delay()), 0.0F, 1000.0F);
  sound_.asked_ms = Ms(choice_.chosen());
  sound_.automatic = choice_.automatic() ? 1 : 0;
  sound_.leaps = line_.jumps();
  sound_.drift_ppm = line_.drift_ppm();
  writer_.Write(sound_, now, source_);
  LogDelay();
}

// A delay that a person sets is logged at once; a measured one when it has been measured, and not more often
// than every ten seconds.
void Speaker::LogDelay() {
  if (choice_.automatic() && (!choice_.measured() || published_at_ < log_delay_after_)) return;
  if (std::exchange(logged_delay_, choice_.chosen()) == choice_.chosen()) return;
  log_delay_after_ = published_at_ + kDelayLogPeriod;
  Log("the voice is played {:.0f} ms after it was spoken{}", Ms(choice_.chosen()),
      choice_.automatic() ? ", as measured" : "");
}

}  // namespace kaori::voice
