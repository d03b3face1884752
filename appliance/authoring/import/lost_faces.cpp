#include "appliance/authoring/import/lost_faces.h"

#include <algorithm>

namespace kaori::import {

// Calls name faces by number: what lies beyond the last face of the cast is lost.
void DropLostFaces(show::Show& show) {
  const std::size_t faces = show.cast.faces.size();
  const auto is_lost = [faces](const show::Call& call) {
    return call.kind == show::CallKind::kFace && call.index >= faces;
  };
  std::ranges::replace_if(show.buttons, is_lost, show::Call{});
  std::ranges::replace_if(show.second_buttons, is_lost, show::Call{});
  for (show::KeyCall& key : show.keys)
    if (is_lost(key.call)) key.call = {};
  for (show::Call& mix : show.roles.mixes)
    if (is_lost(mix)) mix.index = 0;
  for (show::StageScene& scene : show.scenes)
    if (scene.face >= faces) scene.face = 0;
  show.face_fades.resize(std::min(show.face_fades.size(), faces));
}

}  // namespace kaori::import
