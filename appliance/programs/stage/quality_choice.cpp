#include "appliance/programs/stage/quality_choice.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "drivers/base/log.h"

namespace kaori::stage {
namespace {

using passes::Quality;

constexpr int kTimedFrames = 5;

// The quality that a wish names; nothing of "auto", or of no name.
std::optional<Quality> NamedBy(std::string_view wish) {
  for (const Quality quality : {Quality::kBasic, Quality::kFine, Quality::kFinest})
    if (wish == passes::NameOf(quality)) return quality;
  return std::nullopt;
}

// The first face of the show as it is at rest, before its plainest backdrop.
scene::Scene FaceAtRest() {
  scene::Scene scene;
  scene.weights.faces.Push(0, 1);
  scene.weights.expressions.Push(0, 1);
  return scene;
}

// Frames of the quality that is set.
Result<std::vector<Duration>> TimeFrames(Studio& studio, PictureSize size) {
  std::vector<Duration> times;
  for (int frame = 0; frame <= kTimedFrames; ++frame) {
    const auto time = studio.TimeFrame(FaceAtRest(), size.width_px, size.height_px);
    if (!time) return tl::unexpected(time.error());
    if (frame > 0) times.push_back(*time);  // The first one compiles shaders.
  }
  return times;
}

// Finer ones first; one that the driver refuses is left out.
Result<std::string> ChooseByTime(Studio& studio, PictureSize size) {
  std::string why;
  for (const Quality quality : {Quality::kFinest, Quality::kFine}) {
    const auto times = studio.SetQuality(quality).and_then([&] { return TimeFrames(studio, size); });
    if (!times) {
      why = fmt::format("{} was refused ({})", passes::NameOf(quality), times.error().message());
      continue;
    }
    const double fastest_ms = Seconds(*std::ranges::min_element(*times)) * 1e3;
    if (IsInTime(*times)) return fmt::format("{}, {:.1f} ms a frame", passes::NameOf(quality), fastest_ms);
    why = fmt::format("{} would take {:.0f} ms a frame", passes::NameOf(quality), fastest_ms);
  }
  if (auto back = studio.SetQuality(Quality::kBasic); !back) return tl::unexpected(back.error());
  return "basic: " + why;
}

}  // namespace

bool IsInTime(std::span<const Duration> times) {
  if (times.empty()) return false;
  std::vector<Duration> sorted(times.begin(), times.end());
  std::ranges::sort(sorted);
  return sorted[sorted.size() / 2] <= kFineFrame;
}

// The names are those of the option and of the log.
bool IsQualityWish(std::string_view wish) {
  return wish == "auto" || NamedBy(wish);
}

std::string NoQualityWish(std::string_view wish) {
  return fmt::format("--quality {}: expected auto, basic, fine or finest", wish);
}

// A wish for basic costs nothing: it is what a studio begins with, and no shader is made anew.
std::string ChooseQuality(Studio& studio, std::string_view wish, PictureSize size) {
  if (wish == "basic") return "basic, as asked for";
  const auto asked = NamedBy(wish);
  if (!asked && passes::QualityFor(studio.renderer()) == Quality::kBasic)
    return "basic, since a processor draws";
  const auto as_asked = [&]() -> Result<std::string> {
    auto set = studio.SetQuality(*asked);
    if (!set) return tl::unexpected(set.error());
    return fmt::format("{}, as asked for", wish);
  };
  auto chosen = asked ? as_asked() : ChooseByTime(studio, size);
  if (chosen) return std::move(*chosen);
  return fmt::format("{}, since another was refused ({})", NameOf(studio.quality()),
                     chosen.error().message());
}

// Screens of one size, or smaller ones than before, are not timed again: what was chosen is in time for them.
void QualityForScreens::See(ports::Scanout& screen) {
  const auto lent = screen.Acquire();
  if (!lent || wish_ != "auto") return;
  const long px = static_cast<long>(lent->width_px) * lent->height_px;
  if (px <= timed_px_) return;
  timed_px_ = px;
  Log("quality {} at {} x {} pixels",
      ChooseQuality(studio_, wish_, {.width_px = lent->width_px, .height_px = lent->height_px}),
      lent->width_px, lent->height_px);
}

}  // namespace kaori::stage
