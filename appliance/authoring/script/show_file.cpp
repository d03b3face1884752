#include "appliance/authoring/script/show_file.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <string_view>

#include "appliance/authoring/script/backdrop_file.h"
#include "appliance/authoring/script/show_parts.h"
#include "appliance/core/roles/roles_file.h"
#include "drivers/base/folder.h"

namespace kaori::authoring {
namespace {

// One [[scene]]. Without more it is the neutral expression in soft style, in the usual light, faded in
// within 0.8 s.
show::StageScene ReadScene(Script& script, toml::Section section) {
  section.AllowOnly(
      {"name", "key", "face", "expression", "style", "light", "fade_s", "backdrop", "life", "gaze"});
  show::StageScene scene;
  scene.name = section.TextOr("name", "unnamed");
  for (const show::StageScene& other : script.show.scenes)
    if (section.Has("name") && other.name == scene.name)
      section.Fault("name", fmt::format("the name \"{}\" is given twice", scene.name));
  if (section.Has("key"))
    scene.key_usage =
        KeyNamed(script, section, "key", section.Text("key"), fmt::format("scene \"{}\"", scene.name));
  if (const std::string face = section.Text("face"); !face.empty())
    scene.face = FaceNamed(script, section, "face", face);
  scene.expression = ExpressionNamed(script, section, "expression", section.TextOr("expression", "neutral"));
  scene.style = static_cast<scene::Style>(StyleNamed(section, "style", section.TextOr("style", "soft")));
  scene.exposure = Between(section, "light", 1, show::kMostExposure, "");
  scene.fade_s = Between(section, "fade_s", 0.8F, show::kLongestFade_s, " s");
  scene.life = LifeAt(section, "life", 1);
  if (section.Has("gaze")) scene.gaze = GazeNamed(script, section, "gaze", section.Text("gaze"));
  if (section.Has("backdrop"))
    scene.backdrop = ReadBackdrop(section.Part("backdrop"), script.folder, script.show.cast.textures);
  else
    section.Fault("backdrop", R"(is missing, such as { top = "#41506a", bottom = "#1b2030" })");
  return scene;
}

// [channels]: which expression plays each role. Roles without one stay -1, and nothing moves then.
void ReadChannels(Script& script, toml::Section section) {
  section.AllowOnly({"brow_up_left", "brow_up_right", "brow_frown", "lids_up", "lids_down", "mouth"});
  const auto channel = [&](const char* role) {
    return section.Has(role) ? ExpressionNamed(script, section, role, section.Text(role)) : -1;
  };
  show::Channels& channels = script.show.channels;
  channels.brow_up = {channel("brow_up_left"), channel("brow_up_right")};
  channels.brow_frown = channel("brow_frown");
  channels.lids_up = channel("lids_up");
  channels.lids_down = channel("lids_down");
  if (!section.Has("mouth")) return;
  const std::vector<std::string> mouth = section.Texts("mouth");
  // Shut narrow, shut wide, open narrow, open wide: the corners of the lips' bilinear shape.
  if (mouth.size() != channels.mouth.size()) return section.Fault("mouth", "must name four mouth shapes");
  for (std::size_t i = 0; i < mouth.size(); ++i)
    channels.mouth[i] = ExpressionNamed(script, section, "mouth", mouth[i]);
}

// Gaze targets before scenes, and scenes before motions and buttons, which may call them. [[take]] is what
// motions were called before; takes have files of their own.
void ReadScript(Script& script, toml::Section file) {
  if (file.Has("take")) file.Fault("take", "a registered motion is now written [[motion]], not [[take]]");
  file.AllowOnly(
      {"name", "scene", "motion", "buttons", "keys", "channels", "gaze", "second_buttons", "fades"});
  script.show.name = file.TextOr("name", "unnamed");
  const toml::Value none{};
  ReadGazeTargets(script, file.Has("gaze") ? file.Part("gaze") : toml::Section(none, "gaze", script.faults));
  std::size_t number = 0;
  for (const toml::Section& scene : file.Parts("scene"))
    script.show.scenes.push_back(ReadScene(script, Named(script, "scene", scene, ++number)));
  if (script.show.scenes.empty()) file.Fault("scene", "there is none; the first one opens the show");
  number = 0;
  for (const toml::Section& motion : file.Parts("motion"))
    script.show.motions.push_back(ReadMotion(script, Named(script, "motion", motion, ++number)));
  ReadTakes(script);
  if (file.Has("buttons")) ReadButtons(script, file, "buttons", script.show.buttons);
  if (file.Has("second_buttons")) ReadButtons(script, file, "second_buttons", script.show.second_buttons);
  if (file.Has("fades")) ReadFades(script, file.Part("fades"));
  if (file.Has("keys")) ReadKeys(script, file.Part("keys"));
  if (file.Has("channels")) ReadChannels(script, file.Part("channels"));
}

// Reads the file of a part with `read`, and returns its faults; a show may be without it.
std::vector<std::string> FaultsBeside(const Script& of_show, const char* name,
                                      void (*read)(Script&, toml::Section)) {
  const std::filesystem::path file = of_show.folder / name;
  if (!IsThere(file)) return {};
  const auto value = toml::ReadToml(file);
  if (!value) return {value.error().message()};
  toml::Faults faults(file.string());
  Script script{.folder = of_show.folder, .known = of_show.known, .show = of_show.show, .faults = faults};
  read(script, toml::Section(*value, "", faults));
  return faults.lines();
}

}  // namespace

// A file that cannot be read is one fault: the error of reading it.
// Roles are read before cues, which may release levels that only the roles name, and
// the lobby last: it stands in one of the cues.
std::vector<std::string> ReadShowFile(const std::filesystem::path& file, show::Show& show, KnownNames known) {
  const auto value = toml::ReadToml(file);
  if (!value) return {value.error().message()};
  toml::Faults faults(file.string());
  Script script{.folder = file.parent_path(), .known = known, .show = show, .faults = faults};
  ReadScript(script, toml::Section(*value, "", faults));
  std::vector<std::string> lines = faults.lines();
  std::ranges::copy(script.faults_of_takes, std::back_inserter(lines));
  const std::filesystem::path of_roles = script.folder / "roles.toml";
  roles::Items items = roles::ItemsOf(show.cast);
  items.all_known = known.faces && known.expressions;
  if (IsThere(of_roles))
    std::ranges::copy(roles::ReadRolesFile(of_roles, items, show.roles), std::back_inserter(lines));
  std::ranges::copy(FaultsBeside(script, "cues.toml", ReadCueList), std::back_inserter(lines));
  std::ranges::copy(FaultsBeside(script, "lobby.toml", ReadLobbyFile), std::back_inserter(lines));
  return lines;
}

}  // namespace kaori::authoring
