#include "appliance/programs/stage/rehearsal.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "appliance/core/performance/animate.h"
#include "appliance/programs/stage/studio.h"

namespace kaori::stage {
namespace {

constexpr int kRehearsed_width_px = 320, kRehearsed_height_px = 180;
constexpr int kLeastShades =
    8;  // Of 255, between the darkest and the brightest value of a picture that shows something.

struct FirstFrame {
  std::string scene_name;
  scene::Scene scene;
};

// A show opens with its first scene, so that each scene is put there once; without cues, which would call
// another one.
std::vector<FirstFrame> FirstFrames(show::Show& show) {
  const auto cues = std::exchange(show.cue_list.cues, {});
  std::vector<FirstFrame> frames;
  const auto open = [&](std::string name) {
    const auto state = performance::Opening(show, {}, {});
    frames.push_back({std::move(name), performance::Animate(state, {}, {}, show, {}).scene});
  };
  if (show.scenes.empty()) open(show.name);
  for (auto& each : show.scenes) {
    std::swap(show.scenes.front(), each);
    open(show.scenes.front().name);
    std::swap(show.scenes.front(), each);
  }
  show.cue_list.cues = cues;
  return frames;
}

// The fourth byte of a pixel means nothing.
bool ShowsSomething(const std::vector<std::uint8_t>& rgbx) {
  std::uint8_t low = 255, high = 0;
  for (std::size_t i = 0; i < rgbx.size(); ++i) {
    if (i % 4 == 3) continue;
    low = std::min(low, rgbx[i]);
    high = std::max(high, rgbx[i]);
  }
  return high - low >= kLeastShades;
}

}  // namespace

// A scene that is dark on purpose is no fault; a show in which all of them are dark is one.
Result<void> Rehearse(show::Show show) {
  const auto frames = FirstFrames(show);
  auto studio = Studio::Open(std::move(show));
  if (!studio) return tl::unexpected(studio.error());
  std::vector<std::uint8_t> picture(std::size_t{kRehearsed_width_px} * kRehearsed_height_px * 4);
  bool seen = false;
  for (const auto& frame : frames) {
    const auto drawn = (*studio)->Draw(frame.scene, {.width_px = kRehearsed_width_px,
                                                     .height_px = kRehearsed_height_px,
                                                     .target = ports::PixelMemory{picture}});
    if (!drawn)
      return FailAs(drawn.error(), "draw the scene " + frame.scene_name + ": " + drawn.error().attempt);
    seen = seen || ShowsSomething(picture);
  }
  if (!seen) return FailInput("nothing is seen in any of the show's scenes");
  return {};
}

}  // namespace kaori::stage
