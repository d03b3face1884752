#include "appliance/authoring/keys/key_scene.h"

#include <algorithm>
#include <array>
#include <string_view>

#include "appliance/authoring/script/labels.h"

namespace kaori::authoring {
namespace {

// Keys are small: the head fills them, hair and ears included.
constexpr float kKeyDistance_m = 0.86F;
// A little to the side, so that depth and hair are seen.
constexpr float kKeyTurn_rad = 0.2F;
// Words before a name that say nothing where its picture is there.
constexpr std::array<std::string_view, 6> kKinds{"face ",  "expression ", "scene ",
                                                 "style ", "motion ",     "cue "};

// Whole, and alone.
void Become(face::Terms& terms, std::uint16_t index) {
  terms.clear();
  terms.Push(index, 1);
}

// As the show opens, without a backdrop that a small picture has no room for.
scene::Scene Opening(const show::Show& show) {
  const show::StageScene& first = show.scenes.front();
  scene::Scene scene;
  Become(scene.weights.faces, first.face);
  Become(scene.weights.expressions, 0);
  scene.camera.distance_m = kKeyDistance_m;
  scene.head.yaw_rad = kKeyTurn_rad;
  return scene;
}

void Draw(scene::Style style, scene::Scene& scene) {
  scene.styles = {};
  scene.styles[static_cast<std::size_t>(style)] = 1;
}

// All that a scene says but its fade, its life and where she looks, which no still picture shows.
scene::Scene OnStage(const show::StageScene& staged, scene::Scene scene) {
  Become(scene.weights.faces, staged.face);
  Become(scene.weights.expressions, staged.expression);
  Draw(staged.style, scene);
  scene.backdrop = staged.backdrop;
  scene.light.exposure = staged.exposure;
  scene.camera = {};  // Farther away: a scene is known by what stands behind.
  return scene;
}

}  // namespace

std::optional<scene::Scene> SceneOfKey(const show::Call& call, const show::Show& show) {
  scene::Scene scene = Opening(show);
  switch (call.kind) {
    case show::CallKind::kFace:
      Become(scene.weights.faces, call.index);
      return scene;
    case show::CallKind::kExpression:
      Become(scene.weights.expressions, call.index);
      return scene;
    case show::CallKind::kStyle:
      Draw(static_cast<scene::Style>(call.index), scene);
      return scene;
    case show::CallKind::kScene:
      return OnStage(show.scenes[call.index], scene);
    default:
      return std::nullopt;
  }
}

// The number of a cue alone would be read as a key's.
std::string TextOfKey(const std::string& call) {
  const auto* const kind =
      std::ranges::find_if(kKinds, [&](std::string_view word) { return call.starts_with(word); });
  const bool is_number = call.starts_with("cue ") && call.size() > 4 && call[4] >= '0' && call[4] <= '9';
  return Readable(kind == kKinds.end() || is_number ? call : call.substr(kind->size()));
}

}  // namespace kaori::authoring
