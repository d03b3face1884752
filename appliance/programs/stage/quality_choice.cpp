#include "appliance/programs/stage/quality_choice.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace kaori::stage {
namespace {

using passes::Quality;

constexpr int kTimedFrames = 5;

// The first face of the show as it is at rest, before its plainest backdrop.
scene::Scene FaceAtRest() {
  scene::Scene scene;
  scene.weights.faces.Push(0, 1);
  scene.weights.expressions.Push(0, 1);
  return scene;
}

Result<std::string> ChooseByTime(Studio& studio) {
  std::vector<Duration> times;
  for (int frame = 0; frame <= kTimedFrames; ++frame) {
    const auto time = studio.TimeFrame(FaceAtRest(), 1920, 1080);
    if (!time) return tl::unexpected(time.error());
    if (frame > 0) times.push_back(*time);  // The first one compiles shaders.
  }
  const double fastest_ms = Seconds(*std::ranges::min_element(times)) * 1e3;
  if (IsInTime(times)) return fmt::format("fine, {:.1f} ms a frame", fastest_ms);
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
  return wish == "auto" || wish == "basic" || wish == "fine";
}

std::string ChooseQuality(Studio& studio, std::string_view wish) {
  const bool on_card = passes::QualityFor(studio.renderer()) == Quality::kFine;
  if (wish == "basic") return "basic, as asked for";
  if (wish == "auto" && !on_card) return "basic, since a processor draws";
  auto chosen = studio.SetQuality(Quality::kFine).and_then([&]() -> Result<std::string> {
    if (wish == "fine") return "fine, as asked for";
    return ChooseByTime(studio);
  });
  if (chosen) return std::move(*chosen);
  return fmt::format("{}, since another was refused ({})", NameOf(studio.quality()),
                     chosen.error().message());
}

}  // namespace kaori::stage
