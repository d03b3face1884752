// Any bytes as a show pack: refused, or everything that the show calls is there, and it can be played. The
// kept inputs began with the content and the header of a tiny show (SmallShow in
// tests/appliance/core/pack_fixture.h).
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "appliance/core/board/press_log.h"
#include "appliance/core/performance/animate.h"
#include "appliance/core/show/check.h"
#include "appliance/core/show/pack_container.h"
#include "appliance/core/show/pack_content.h"
#include "render/face/composer.h"
#include "tests/fuzz/check.h"

namespace kaori::fuzz {
namespace {

void CheckCalls(const show::Show& show) {
  const std::size_t expressions = show.cast.expressions.size();
  std::vector<show::Call> calls(show.buttons.begin(), show.buttons.end());
  calls.insert(calls.end(), show.second_buttons.begin(), show.second_buttons.end());
  calls.insert(calls.end(), show.stick_buttons.begin(), show.stick_buttons.end());
  calls.insert(calls.end(), show.roles.mixes.begin(), show.roles.mixes.end());
  for (const show::KeyCall& key : show.keys) calls.push_back(key.call);
  for (const show::Call& call : calls) {
    const std::size_t counts[]{1,
                               show.cast.faces.size(),
                               expressions,
                               scene::kStyleCount,
                               show.scenes.size(),
                               show::kCueVerbCount,
                               show::kSheetCount,
                               show.motions.size(),
                               show::kBlinkNames.size(),
                               show.cue_list.cues.size()};
    Promise(call.kind <= show::CallKind::kGoTo, "a control calls what exists");
    Promise(call.mode == show::CallMode::kCall || show::Joins(call.kind), "only what can join others does");
    Promise(call.index < counts[static_cast<std::size_t>(call.kind)], "a control calls one that exists");
  }
  for (const show::StageScene& scene : show.scenes)
    Promise(scene.face < show.cast.faces.size() && scene.expression < expressions &&
                static_cast<int>(scene.style) < scene::kStyleCount,
            "a scene shows what exists");
  for (const show::Motion& motion : show.motions)
    Promise(motion.layer <= show::MotionLayer::kOver, "a motion lies in a layer that there is");
  for (const face::Face& face : show.cast.faces) {
    Promise(face.surface.texture >= 0 && face.surface.texture < static_cast<int>(show.cast.textures.size()),
            "a face has a texture");
    for (const int prop : face.props)
      Promise(prop >= 0 && prop < static_cast<int>(show.cast.props.size()), "a face wears what exists");
  }
  for (const face::Prop& prop : show.cast.props) {
    Promise(prop.part <= face::Part::kClothes, "a prop is a known part");
    for (const face::Triangle& t : prop.triangles)
      Promise(std::ranges::max(t) < prop.vertices.size(), "a prop's corners exist");
  }
}

// Every button at once, every key within a few frames, and what comes of it.
void Play(const show::Show& show) {
  face::Composer composer(show.cast);
  board::Snapshot board;
  Time now = Time{} + std::chrono::seconds(1);
  performance::State state = performance::Opening(show, board, now);
  board.surface.source = board.keys.source = board::SourceState::kLive;
  for (std::size_t button = 0; button < 32; ++button) board::NotePress(board.surface.value, button, now);
  for (std::size_t usage = 0; usage < 256; usage += board::PressLog::kKept) {
    for (std::size_t i = 0; i < board::PressLog::kKept; ++i)
      board::NotePress(board.keys.value, usage + i, now);
    const auto events = performance::ReadEvents(state.seen, board);
    const auto performed =
        performance::Animate(state, board, events, show, now += std::chrono::milliseconds(90));
    state = performed.state;
    Promise(performance::IsValid(state, show), "a sound show is performed soundly");
    Promise(std::isfinite(performed.scene.head.yaw_rad + performed.scene.light.exposure), "and in numbers");
    composer.Compose(performed.scene.weights, face::Detail::kFine);
  }
}

}  // namespace
}  // namespace kaori::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace kaori;
  if (const auto seal = show::ReadHeader({data, size}, size))
    fuzz::Promise(seal->content_bytes + show::kPackHeader_bytes == size, "a header knows its file's length");
  const std::vector<std::uint8_t> aligned(data, data + size);
  const auto show = show::DecodeContent(aligned);
  if (!show || !show::CheckShow(*show).empty()) return 0;
  fuzz::CheckCalls(*show);
  fuzz::Play(*show);
  return 0;
}
