#include "appliance/authoring/import/kept_script.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kaori::import {

// Calls name faces by number: what lies beyond the last face of the cast is lost.
int DropLostFaces(show::Show& show) {
  const std::size_t faces = show.cast.faces.size();
  int lost = 0;
  // The rest of such a call, its mode and its fade, goes with it.
  const auto drop = [&](show::Call& call) {
    if (call.kind != show::CallKind::kFace || call.index < faces) return;
    call = {};
    ++lost;
  };
  std::ranges::for_each(show.buttons, drop);
  std::ranges::for_each(show.second_buttons, drop);
  for (show::KeyCall& key : show.keys) drop(key.call);
  // A mix keeps its place among the roles, whose numbers other files name.
  for (show::Call& mix : show.roles.mixes)
    if (mix.kind == show::CallKind::kFace && mix.index >= faces) mix.index = 0;
  // A scene must show somebody.
  for (show::StageScene& scene : show.scenes)
    if (scene.face >= faces) scene.face = 0;
  show.face_fades.resize(std::min(show.face_fades.size(), faces));
  return lost;
}

// Each once, however many scenes stand before it.
void CarryPictures(const show::Show& from, show::Show& to) {
  std::map<int, int> carried;  // From the number there to the number here.
  for (show::StageScene& scene : to.scenes) {
    int& picture = scene.backdrop.picture;
    const bool known = picture >= 0 && picture < static_cast<int>(from.cast.textures.size());
    if (scene.backdrop.kind != scene::BackdropKind::kPicture || !known) continue;
    const auto [place, is_new] = carried.try_emplace(picture, static_cast<int>(to.cast.textures.size()));
    if (is_new) to.cast.textures.push_back(from.cast.textures[static_cast<std::size_t>(picture)]);
    picture = place->second;
  }
}

// A show without scenes has no script to speak of.
std::vector<std::string> WhatBecameOf(const show::Show& script, int lost_calls) {
  std::vector<std::string> said;
  if (script.scenes.empty()) return said;
  std::vector<std::string> names;
  for (const face::Face& face : script.cast.faces) names.push_back(face.name);
  said.push_back(
      fmt::format("scenes: each of the {} plays a face of this import ({}), the only ones that it has",
                  script.scenes.size(), fmt::join(names, ", ")));
  if (lost_calls > 0)
    said.push_back(
        fmt::format("buttons and keys: {} called other faces of the show, and call nothing now", lost_calls));
  return said;
}

}  // namespace kaori::import
