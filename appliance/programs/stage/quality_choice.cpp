#include "appliance/programs/stage/quality_choice.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "drivers/base/log.h"
#include "drivers/base/long_call.h"

namespace kaori::stage {
namespace {

using passes::Quality;

// Of each quality, after one that is not timed: a hiccup of one of them is no slow card.
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

// How long frames of this size take in a quality, which is set.
auto TimesOf(Studio& studio, PictureSize size) {
  return [&studio, size](Quality quality) {
    return studio.SetQuality(quality).and_then([&] { return TimeFrames(studio, size); });
  };
}

// Before the first picture: shaders of a quality that is then not used were compiled for nothing, once.
Result<std::string> ChooseByTime(Studio& studio) {
  constexpr std::array kFiner{Quality::kFinest, Quality::kFine};
  const ChosenQuality chosen = FirstInTime(kFiner, TimesOf(studio, {}));
  if (auto set = studio.SetQuality(chosen.quality); !set) return tl::unexpected(set.error());
  return chosen.why;
}

}  // namespace

bool IsInTime(std::span<const Duration> times) {
  if (times.empty()) return false;
  std::vector<Duration> sorted(times.begin(), times.end());
  std::ranges::sort(sorted);
  return sorted[sorted.size() / 2] <= kFineFrame;
}

ChosenQuality FirstInTime(std::span<const Quality> finer,
                          const std::function<Result<std::vector<Duration>>(Quality)>& time) {
  std::string why;
  for (const Quality quality : finer) {
    const auto times = time(quality);
    if (!times || times->empty()) {
      why = fmt::format("{} was refused ({})", passes::NameOf(quality),
                        times ? "no frame was drawn" : times.error().message());
      continue;
    }
    const double fastest_ms = Seconds(*std::ranges::min_element(*times)) * 1e3;
    if (IsInTime(*times))
      return {quality, fmt::format("{}, {:.1f} ms a frame", passes::NameOf(quality), fastest_ms)};
    why = fmt::format("{} would take {:.0f} ms a frame", passes::NameOf(quality), fastest_ms);
  }
  return {Quality::kBasic, "basic: " + why};
}

// The names are those of the option and of the log.
bool IsQualityWish(std::string_view wish) {
  return wish == "auto" || NamedBy(wish);
}

std::string NoQualityWish(std::string_view wish) {
  return fmt::format("--quality {}: expected auto, basic, fine or finest", wish);
}

// A wish for basic costs nothing: it is what a studio begins with, and no shader is made anew.
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

QualityForScreens::QualityForScreens(Studio& studio, std::string_view wish)
    : studio_(studio), is_auto_(wish == "auto"), usual_(studio.quality()) {}

// A quality that was too slow for the usual size is not tried again for a larger one.
Result<Quality> QualityForScreens::QualityAt(PictureSize size) {
  constexpr long kUsual_px = 1920L * 1080;
  if (static_cast<long>(size.width_px) * size.height_px <= kUsual_px) return usual_;
  const std::pair key{size.width_px, size.height_px};
  if (const auto known = at_size_.find(key); known != at_size_.end()) return known->second;
  std::vector<Quality> finer;
  for (const Quality quality : {Quality::kFinest, Quality::kFine})
    if (quality <= usual_) finer.push_back(quality);
  ExpectLongCall();
  const ChosenQuality chosen = FirstInTime(finer, TimesOf(studio_, size));
  at_size_[key] = chosen.quality;
  Log("quality {} at {} x {} pixels", chosen.why, size.width_px, size.height_px);
  return chosen.quality;
}

// Basic is what a processor draws, or a card that is too slow for all else.
void QualityForScreens::See(ports::Scanout& screen) {
  const auto lent = screen.Acquire();
  if (!lent || !is_auto_ || usual_ == Quality::kBasic) return;
  const auto wanted = QualityAt({.width_px = lent->width_px, .height_px = lent->height_px});
  const auto set = wanted.and_then([this](Quality quality) { return studio_.SetQuality(quality); });
  if (!set) LogWarning("the quality stays as it is: {}", set.error().message());
}

}  // namespace kaori::stage
