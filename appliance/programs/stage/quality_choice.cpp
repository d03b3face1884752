#include "appliance/programs/stage/quality_choice.h"

#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

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
Result<std::vector<Duration>> TimeFrames(Studio& studio) {
  std::vector<Duration> times;
  for (int frame = 0; frame <= kTimedFrames; ++frame) {
    const auto time = studio.TimeFrame(FaceAtRest(), 1920, 1080);
    if (!time) return tl::unexpected(time.error());
    if (frame > 0) times.push_back(*time);  // The first one compiles shaders.
  }
  return times;
}

// Finer ones first.
Result<std::string> ChooseByTime(Studio& studio) {
  double fastest_ms = 0;
  for (const Quality quality : {Quality::kFinest, Quality::kFine}) {
    if (auto set = studio.SetQuality(quality); !set) return tl::unexpected(set.error());
    const auto times = TimeFrames(studio);
    if (!times) return tl::unexpected(times.error());
    fastest_ms = Seconds(*std::ranges::min_element(*times)) * 1e3;
    if (IsInTime(*times)) return fmt::format("{}, {:.1f} ms a frame", passes::NameOf(quality), fastest_ms);
  }
  if (auto back = studio.SetQuality(Quality::kBasic); !back) return tl::unexpected(back.error());
  return fmt::format("basic: fine would take {:.0f} ms a frame", fastest_ms);
}

}  // namespace

bool IsInTime(std::span<const Duration> times) {
  if (times.empty()) return false;
  std::vector<Duration> sorted(times.begin(), times.end());
  std::ranges::sort(sorted);
  return sorted[sorted.size() / 2] <= kFineFrame;
}

bool IsQualityWish(std::string_view wish) {
  return wish == "auto" || NamedBy(wish);
}

std::string NoQualityWish(std::string_view wish) {
  return fmt::format("--quality {}: expected auto, basic, fine or finest", wish);
}

std::string ChooseQuality(Studio& studio, std::string_view wish) {
  if (wish == "basic") return "basic, as asked for";
  const auto asked = NamedBy(wish);
  if (!asked && passes::QualityFor(studio.renderer()) == Quality::kBasic)
    return "basic, since a processor draws";
  const auto as_asked = [&]() -> Result<std::string> {
    auto set = studio.SetQuality(*asked);
    if (!set) return tl::unexpected(set.error());
    return fmt::format("{}, as asked for", wish);
  };
  auto chosen = asked ? as_asked() : ChooseByTime(studio);
  if (chosen) return std::move(*chosen);
  return fmt::format("{}, since another was refused ({})", NameOf(studio.quality()),
                     chosen.error().message());
}

}  // namespace kaori::stage
