#include "appliance/programs/lips/voice/speaker.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "appliance/core/board/snapshot.h"
#include "drivers/base/log.h"
#include "drivers/base/source.h"

namespace kaori::voice {
namespace {

using std::chrono::milliseconds;

constexpr Duration kRetry = milliseconds(250);
// How much waits in the device: how late we may be. A device that ran dry gets more, and less again by and
// by.
constexpr Duration kLeastLead = milliseconds(20), kMoreLead = milliseconds(10), kMostLead = milliseconds(50);
constexpr int kForgiveness = 1000;            // A millisecond of each second.
constexpr Duration kSpeakerTorn = milliseconds(10);  // A promise further off than this is a break, and no trembling.
constexpr double kPromiseShare = 0.05;        // Of a promise's news that is believed.
constexpr Duration kStuck = milliseconds(1000);
constexpr Duration kTellPeriod = milliseconds(100);
constexpr Duration kQuiet = std::chrono::seconds(10);  // Between two lines of the log about the delay.
constexpr int kChunksAtOnce = 40;

float Ms(Duration time) {
  return static_cast<float>(Seconds(time) * 1e3);
}

std::int16_t Sample16(float sample) {
  return static_cast<std::int16_t>(std::lround(32767 * std::clamp(sample, -1.0F, 1.0F)));
}

}  // namespace

Speaker::Speaker(ports::LoudspeakerOpener open, const board::Board& board, board::Writer<board::Sound> writer,
                 SpeakerSettings settings, const Clock& clock)
    : open_(std::move(open)),
      board_(board),
      writer_(std::move(writer)),
      clock_(clock),
      choice_(settings.delay, board.Read<board::Sound>()),
      takes_(std::move(settings.clips)) {
  chunk_.reserve(kChunk * 8);
}

void Speaker::Step() {
  const Time now = clock_.now();
  takes_.Follow(board_.Read<board::MotionNow>());
  choice_.Choose(board::ReadAll(board_), now);
  if (!loudspeaker_ && now >= retry_at_) TryOpen(now);
  if (loudspeaker_) Fill(now);
  if (now - told_at_ >= kTellPeriod) Tell(now);
}

void Speaker::TryOpen(Time now) {
  retry_at_ = now + kRetry;
  loudspeaker_ = OpenOrLog(open_, logged_);
  if (!loudspeaker_) return;
  heard_next_.reset();
  chunk_.clear();
  pushed_ = 0;
  silent_since_ = filled_at_ = now;
  Log("loudspeaker: open");
}

void Speaker::Fill(Time now) {
  lead_ = std::max(lead_ - (now - filled_at_) / kForgiveness, kLeastLead);
  filled_at_ = now;
  for (int n = 0; n < kChunksAtOnce && loudspeaker_; ++n) {
    const bool enough = heard_next_ && *heard_next_ >= now + depth_ + lead_;
    if (pushed_ == chunk_.size() && enough) return;
    if (!SpeakChunk()) break;
  }
  if (loudspeaker_ && now - silent_since_ > kStuck) Close(now, "loudspeaker: it takes no sound");
}

// Makes the next chunk, unless one still waits, and gives it away. False: there is no room now.
bool Speaker::SpeakChunk() {
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

// Before it is known when it will be heard, a chunk is silent.
void Speaker::Mix() {
  mixed_.fill(0);
  if (!heard_next_) return;
  line_.Speak(voice_, *heard_next_, choice_.chosen());
  for (std::size_t frame = 0; frame < kChunk; ++frame)
    mixed_[2 * frame] = mixed_[2 * frame + 1] = voice_[frame];
  takes_.Mix(mixed_, *heard_next_);
  *heard_next_ += FromSeconds(static_cast<double>(kChunk) / kSoundRate_hz);
}

bool Speaker::Push() {
  const auto channels = static_cast<std::size_t>(loudspeaker_->format().channels);
  const auto playout = loudspeaker_->Write(std::span<const std::int16_t>(chunk_).subspan(pushed_));
  if (!playout) {
    if (playout.error().cause != std::errc::resource_unavailable_try_again)
      Close(clock_.now(), playout.error().message());
    return false;
  }
  pushed_ += playout->frames * channels;
  NotePlayout(*playout);
  return pushed_ == chunk_.size();
}

// The device promises when the frames that it took are heard; what it took last ends where the next begins.
void Speaker::NotePlayout(const ports::Playout& playout) {
  const Time now = clock_.now();
  silent_since_ = now;
  if (source_ != board::SourceState::kLive) Log("loudspeaker: live");
  source_ = board::SourceState::kLive;
  logged_ = {};
  const auto channels = static_cast<std::size_t>(loudspeaker_->format().channels);
  const std::size_t left = (chunk_.size() - pushed_) / channels;
  const Time next = playout.at + FromSeconds(static_cast<double>(playout.frames + left) / kSoundRate_hz);
  if (playout.xrun) {
    ++sound_.xruns;
    lead_ = std::min(lead_ + kMoreLead, kMostLead);
  }
  if (!heard_next_) depth_ = std::max(playout.at - now, Duration{});
  const Duration off = heard_next_ ? next - *heard_next_ : Duration{};
  if (!heard_next_ || playout.xrun || off > kSpeakerTorn || off < -kSpeakerTorn)
    heard_next_ = next;
  else
    *heard_next_ += FromSeconds(Seconds(off) * kPromiseShare);
}

void Speaker::Close(Time now, std::string_view why) {
  loudspeaker_.reset();
  retry_at_ = now + kRetry;
  LogWarning("{}; opening the loudspeaker anew", why);
  logged_ = std::errc::no_such_device;
  if (source_ != board::SourceState::kLive) return;
  source_ = board::SourceState::kStale;
  Tell(now);
}

void Speaker::Tell(Time now) {
  told_at_ = now;
  sound_.delay_ms = std::clamp(Ms(line_.delay()), 0.0F, 1000.0F);
  sound_.asked_ms = Ms(choice_.chosen());
  sound_.automatic = choice_.automatic() ? 1 : 0;
  sound_.leaps = line_.leaps();
  sound_.drift_ppm = line_.drift_ppm();
  writer_.Write(sound_, now, source_);
  LogDelay();
}

void Speaker::LogDelay() {
  if (choice_.automatic() && (!choice_.measured() || told_at_ < quiet_until_)) return;
  if (std::exchange(logged_delay_, choice_.chosen()) == choice_.chosen()) return;
  quiet_until_ = told_at_ + kQuiet;
  Log("the voice sounds {:.0f} ms after it was spoken{}", Ms(choice_.chosen()),
      choice_.automatic() ? ", as measured" : "");
}

}  // namespace kaori::voice
