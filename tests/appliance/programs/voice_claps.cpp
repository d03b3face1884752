#include "tests/appliance/programs/voice_claps.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "hw-sim/rehearsal/rehearsal.h"

namespace kaori::tests {
namespace {

using namespace std::chrono_literals;

constexpr Duration kOpens = 70ms;  // As quick as a mouth says "pa".
constexpr Duration kShuts = 90ms;
constexpr Duration kHolds = 220ms;
constexpr Duration kBetween = 911ms;  // No multiple of any frame's length.
constexpr double kShutHeight = 0.25, kOpenHeight = 0.78;
constexpr int kHeard = 1000;  // Of 32767: a voice, and no room.

double Ms(Duration time) {
  return Seconds(time) * 1e3;
}

double Eased(double x) {
  const double t = std::clamp(x, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double Difference(const std::vector<std::uint8_t>& a, std::span<const std::uint8_t> b) {
  double sum = 0;
  for (std::size_t n = 0; n < std::min(a.size(), b.size()); ++n) sum += std::abs(int{a[n]} - int{b[n]});
  return sum;
}

bool Near(Time at, Time truth) {
  return at > truth - 50ms && at < truth + kBetween / 2;
}

}  // namespace

Time Claps::At(int number) const {
  return begin_ + number * kBetween;
}

Time Claps::end() const {
  return At(count_) - 200ms;
}

void Claps::Move(Time now) {
  const auto number = static_cast<int>((now - begin_ + kBetween / 2) / kBetween);
  const Duration since = now - At(std::clamp(number, 0, count_ - 1));
  const double opened = Eased(Seconds(since + kOpens / 2) / Seconds(kOpens));
  const double shut = Eased(Seconds(since - kHolds) / Seconds(kShuts));
  rig_.camera().SetMouth(kShutHeight + (opened - shut) * (kOpenHeight - kShutHeight), 1);
  const bool sounds = since >= 0ns && since < kHolds;
  if (sounds != sounding_) rig_.microphone().Say(0, sounds ? 1 : 0);
  sounding_ = sounds;
}

void Claps::Watch() {
  for (const auto& block : rig_.loudspeaker().DrainHeard())
    for (std::size_t n = 0; n < block.samples.size(); n += 2) {
      if (std::abs(int{block.samples[n]}) < kHeard) continue;
      const Time at = block.at + FromSeconds(block.frame_s * static_cast<double>(n / 2));
      if (at - loud_at_ > 100ms) onsets_.push_back(at);
      loud_at_ = at;
    }
  const auto latest = rig_.screen().latest();
  if (!latest || rig_.screen().frames_shown() == shown_) return;
  shown_ = rig_.screen().frames_shown();
  if (shut_.empty()) shut_.assign(latest->rgbx.begin(), latest->rgbx.end());
  frames_.push_back({latest->at, Difference(shut_, latest->rgbx)});
}

// The picture passes half between two frames; a straight line between them tells where.
bool Claps::Measure(Time truth, Clap& clap) const {
  double most = 0;
  for (const Frame& frame : frames_)
    if (Near(frame.at, truth)) most = std::max(most, frame.change);
  const auto passes = [&](const Frame& a, const Frame& b) {
    return Near(a.at, truth) && a.change <= most / 2 && b.change > most / 2;
  };
  const auto before = std::ranges::adjacent_find(frames_, passes);
  const auto onset = std::ranges::find_if(onsets_, [truth](Time at) { return Near(at, truth); });
  if (before == frames_.end() || onset == onsets_.end()) return false;
  const Frame &a = *before, &b = *(before + 1);
  const double part = (most / 2 - a.change) / (b.change - a.change);
  const double period_ms = 1e3 / std::round(1e3 / Ms(b.at - a.at));
  clap = {Ms(a.at - truth) + part * Ms(b.at - a.at) + period_ms / 2, Ms(b.at - truth), Ms(*onset - truth)};
  return true;
}

std::vector<Clap> Claps::Measured() const {
  std::vector<Clap> all;
  for (int n = 0; n < count_; ++n)
    if (Clap clap; Measure(At(n), clap)) all.push_back(clap);
  return all;
}

double ClapReport::mean_apart_ms() const {
  double sum = 0;
  for (const Clap& clap : claps) sum += clap.apart_ms();
  return claps.empty() ? 0 : sum / static_cast<double>(claps.size());
}

double ClapReport::median_apart_ms() const {
  std::vector<double> apart_ms;
  for (const Clap& clap : claps) apart_ms.push_back(clap.apart_ms());
  std::ranges::sort(apart_ms);
  return apart_ms.empty() ? 0 : apart_ms[apart_ms.size() / 2];
}

double ClapReport::worst_apart_ms() const {
  double worst = 0;
  for (const Clap& clap : claps) worst = std::max(worst, std::abs(clap.apart_ms()));
  return worst;
}

namespace {

Result<void> Play(sim::Rehearsal& rehearsal, Claps& claps, Time end) {
  while (rehearsal.now() < end) {
    const auto shown = rehearsal.NextPicture([&](Time now) { claps.Move(now); });
    if (!shown) return tl::unexpected(shown.error());
    claps.Watch();
  }
  return {};
}

}  // namespace

Result<ClapReport> ClapIn(const std::string& folder, stage::Studio& studio, const ClapOptions& options) {
  auto rehearsal = sim::Rehearsal::Open({.folder = folder,
                                         .width_px = 128,
                                         .height_px = 72,
                                         .hz = options.screen_hz,
                                         .camera_hz = options.camera_hz},
                                        studio);
  if (!rehearsal) return tl::unexpected(rehearsal.error());
  sim::Rig& rig = (*rehearsal)->rig();
  rig.dial_box().Turn(6, -1);  // Life off: only the mouth moves her.
  rig.microphone().SetDrift(options.microphone_ppm);
  rig.loudspeaker().SetDrift(options.loudspeaker_ppm);
  rig.camera().CoverLens(options.covered);
  Claps first(rig, (*rehearsal)->now() + 300ms, 3);  // Whoever leads shall be measured, too.
  if (auto ok = Play(**rehearsal, first, (*rehearsal)->now() + 3s); !ok) return tl::unexpected(ok.error());
  Claps claps(rig, (*rehearsal)->now() + 700ms, options.claps);
  if (auto ok = Play(**rehearsal, claps, claps.end()); !ok) return tl::unexpected(ok.error());
  const board::Board& board = (*rehearsal)->board();
  return ClapReport{claps.Measured(), Seconds(board.Read<board::StageStatus>().value.lips_age) * 1e3,
                    static_cast<double>(board.Read<board::Sound>().value.delay_ms)};
}

}  // namespace kaori::tests
