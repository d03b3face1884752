#include "appliance/authoring/script/show_file.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>
#include <utility>

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

// Gaze targets before scenes, and scenes before motions. [[take]] is what
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
  if (file.Has("fades")) ReadFades(script, file.Part("fades"));
  if (file.Has("channels")) ReadChannels(script, file.Part("channels"));
}

// What buttons and keys call, once all of it is read.
void ReadControls(Script& script, toml::Section file) {
  if (file.Has("buttons")) ReadButtons(script, file, "buttons", script.show.buttons);
  if (file.Has("second_buttons")) ReadButtons(script, file, "second_buttons", script.show.second_buttons);
  if (file.Has("keys")) ReadKeys(script, file.Part("keys"));
}

// A file beside show.toml, which a show may be without. Its own faults are told once, whoever reads its parts.
struct FileBeside {
  std::filesystem::path file;
  std::optional<toml::Value> value;  // None: it is not there, or it is no TOML.
  std::vector<std::string> faults;
};

FileBeside ReadBeside(const Script& of_show, const char* name) {
  FileBeside beside{.file = of_show.folder / name, .value = {}, .faults = {}};
  if (!IsThere(beside.file)) return beside;
  auto value = toml::ReadToml(beside.file);
  if (value) beside.value = std::move(*value);
  if (!value) beside.faults.push_back(value.error().message());
  return beside;
}

// Reads a part of it with `read`.
void ReadPart(const Script& of_show, FileBeside& beside, void (*read)(Script&, toml::Section)) {
  if (!beside.value) return;
  toml::Faults faults(beside.file.string());
  Script script{.folder = of_show.folder,
                .known = of_show.known,
                .show = of_show.show,
                .faults = faults,
                .knows_cues = of_show.knows_cues};
  read(script, toml::Section(*beside.value, "", faults));
  std::ranges::copy(faults.lines(), std::back_inserter(beside.faults));
}

}  // namespace

// A file that cannot be read is one fault: the error of reading it.
// Roles are read before cues, which may release levels that only the roles name, buttons and keys after cues,
// and the lobby last: it stands in one of the cues.
std::vector<std::string> ReadShowFile(const std::filesystem::path& file, show::Show& show, KnownNames known) {
  const auto value = toml::ReadToml(file);
  if (!value) return {value.error().message()};
  toml::Faults faults(file.string());
  Script script{.folder = file.parent_path(), .known = known, .show = show, .faults = faults};
  const toml::Section of_show(*value, "", faults);
  ReadScript(script, of_show);
  roles::Items items = roles::ItemsOf(show.cast);
  items.all_known = known.faces && known.expressions;
  FileBeside of_roles = ReadBeside(script, "roles.toml"), of_cues = ReadBeside(script, "cues.toml"),
             of_lobby = ReadBeside(script, "lobby.toml");
  if (of_roles.value) of_roles.faults = roles::ReadRolesFile(of_roles.file, items, show.roles);
  ReadPart(script, of_cues, ReadCueList);
  script.knows_cues = of_cues.value || of_cues.faults.empty();
  ReadControls(script, of_show);
  ReadPart(script, of_roles, ReadStickButtons);
  ReadPart(script, of_lobby, ReadLobbyFile);
  std::vector<std::string> lines = faults.lines();
  for (const auto* more : {&std::as_const(script.faults_of_takes), &std::as_const(of_roles.faults),
                           &std::as_const(of_cues.faults), &std::as_const(of_lobby.faults)})
    std::ranges::copy(*more, std::back_inserter(lines));
  return lines;
}

}  // namespace kaori::authoring
