#include "appliance/authoring/sculpt/recipe_file.h"

#include <algorithm>
#include <string>
#include <utility>

#include "appliance/authoring/sculpt/body_file.h"
#include "appliance/authoring/sculpt/section.h"

namespace kaori::sculpt {
namespace {

bool Rises(const std::vector<double>& x) {
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (!(x[i] > x[i - 1])) return false;
  }
  return x.size() >= 2;
}

void NeedRising(Section& section, std::string_view key, const std::vector<double>& x) {
  if (!Rises(x)) section.Fault(key, "must be two numbers or more that rise");
}

void NeedCount(Section& section, std::string_view key, std::size_t count, std::size_t wanted) {
  if (count != wanted) section.Fault(key, "must have " + std::to_string(wanted) + " entries");
}

void NeedPositive(Section& section, std::string_view key, double value) {
  if (!(value > 0)) section.Fault(key, "must be greater than 0");
}

double Positive(Section& section, std::string_view key) {
  const double value = section.Number(key);
  NeedPositive(section, key, value);
  return value;
}

AimTable ReadAim(Section aim) {
  aim.AllowOnly({"columns", "rows"});
  AimTable table{.columns = aim.Numbers("columns"), .rows = {}, .points = {}};
  NeedRising(aim, "columns", table.columns);
  for (Section& row : aim.Parts("rows")) {
    row.AllowOnly({"row", "points"});
    table.rows.push_back(row.Number("row"));
    table.points.push_back(row.Points("points"));
    NeedCount(row, "points", table.points.back().size(), table.columns.size());
  }
  NeedRising(aim, "rows", table.rows);
  return table;
}

EyeRecipe ReadEye(Section section) {
  section.AllowOnly(
      {"centre", "radius", "inner", "outer", "upper_height", "lower_height", "thickness", "crease"});
  EyeRecipe eye;
  eye.centre = section.Point("centre");
  eye.radius = Positive(section, "radius");
  const std::vector<double> inner = section.Numbers("inner");
  const std::vector<double> outer = section.Numbers("outer");
  NeedCount(section, "inner", inner.size(), 2);
  NeedCount(section, "outer", outer.size(), 2);
  if (inner.size() == 2) eye.inner_x = inner[0], eye.inner_y = inner[1];
  if (outer.size() == 2) eye.outer_x = outer[0], eye.outer_y = outer[1];
  eye.upper_height = Positive(section, "upper_height");
  eye.lower_height = Positive(section, "lower_height");
  eye.thickness = section.NumberOr("thickness", eye.thickness);
  eye.crease = section.NumberOr("crease", eye.crease);
  return eye;
}

MouthRecipe ReadMouth(Section section) {
  section.AllowOnly({"half_width", "y", "upper_height", "lower_height", "upturn", "fullness"});
  MouthRecipe mouth;
  mouth.half_width = Positive(section, "half_width");
  mouth.y = section.Number("y");
  mouth.upper_height = Positive(section, "upper_height");
  mouth.lower_height = Positive(section, "lower_height");
  mouth.upturn = section.NumberOr("upturn", 0);
  mouth.fullness = section.NumberOr("fullness", mouth.fullness);
  return mouth;
}

EarRecipe ReadEar(Section section) {
  section.AllowOnly({"height", "width", "tilt_deg"});
  EarRecipe ear;
  ear.height = section.NumberOr("height", ear.height);
  ear.width = section.NumberOr("width", ear.width);
  ear.tilt_deg = section.NumberOr("tilt_deg", ear.tilt_deg);
  return ear;
}

AimScale ReadScale(Section section) {
  section.AllowOnly({"x", "y_above_eyes", "y_below_eyes"});
  return {.x = section.NumberOr("x", 1),
          .y_above_eyes = section.NumberOr("y_above_eyes", 1),
          .y_below_eyes = section.NumberOr("y_below_eyes", 1)};
}

Landmark ReadLandmark(Section section) {
  section.AllowOnly({"at", "to"});
  const auto vertex = AsVertex(section.Word("at"));
  if (!vertex) section.Fault("at", "names no vertex");
  return {vertex.value_or(Key{}), section.Point("to")};
}

// A touched vertex keeps to the grid: rings are laid after it. The middle of the face stays in the middle.
Landmark ReadTouch(const Section& section) {
  Landmark touch = ReadLandmark(section);
  Section named = section;
  if (touch.vertex.region != Region::kGrid) named.Fault("at", "must be a vertex of the grid");
  if (touch.vertex.a == 0 && touch.target.x != 0) named.Fault("to", "must stay in the middle, at x = 0");
  return touch;
}

// What a face that is "like" another one does not say, it takes from there; bodies and touches come on top.
Carved ReadCarved(Section& file, Carved carved) {
  file.AllowOnly(
      {"shape", "like", "mouth_fit", "expression_gain", "scale", "body", "touch", "eye", "mouth", "ear"});
  const bool alone = !file.Has("like");
  if (file.Has("scale")) carved.scale = ReadScale(file.Part("scale"));
  for (const Section& body : file.Parts("body")) carved.bodies.push_back(ReadBody(body));
  if (alone && carved.bodies.empty()) file.Fault("body", "there must be one at least");
  for (const Section& touch : file.Parts("touch")) carved.touches.push_back(ReadTouch(touch));
  if (alone || file.Has("eye")) carved.eye = ReadEye(file.Part("eye"));
  if (alone || file.Has("mouth")) carved.mouth = ReadMouth(file.Part("mouth"));
  if (file.Has("ear")) carved.ear = ReadEar(file.Part("ear"));
  return carved;
}

Tube ReadTube(Section section) {
  section.AllowOnly({"path", "half_width", "half_thickness", "width_direction", "cap"});
  Tube tube{.path = section.Points("path"),
            .half_width = section.Numbers("half_width"),
            .half_thickness = section.Numbers("half_thickness"),
            .width_direction = section.Point("width_direction"),
            .cap = section.NumberOr("cap", 0)};
  constexpr std::size_t kStations = kEarRings + 1;
  NeedCount(section, "path", tube.path.size(), kStations);
  NeedCount(section, "half_width", tube.half_width.size(), kStations);
  NeedCount(section, "half_thickness", tube.half_thickness.size(), kStations);
  if (tube.width_direction == glm::dvec3(0)) section.Fault("width_direction", "must point somewhere");
  return tube;
}

Warped ReadWarped(Section& file) {
  file.AllowOnly({"shape", "mouth_fit", "expression_gain", "eye", "landmark", "ear_tube", "smoothing_steps"});
  Warped warped;
  for (const Section& landmark : file.Parts("landmark")) warped.landmarks.push_back(ReadLandmark(landmark));
  Section eye = file.Part("eye");
  eye.AllowOnly({"shift", "scale", "radius", "thickness"});
  warped.eye_shift = eye.Point("shift");
  warped.eye_scale = Positive(eye, "scale");
  warped.eye_radius = Positive(eye, "radius");
  warped.lid_thickness = eye.NumberOr("thickness", warped.lid_thickness);
  warped.smoothing_steps = static_cast<int>(file.NumberOr("smoothing_steps", 0));
  warped.ear = ReadTube(file.Part("ear_tube"));
  return warped;
}

Spout ReadSpout(Section section) {
  section.AllowOnly(
      {"foot", "tip", "foot_width", "foot_height", "foot_out", "rim_radius", "hole_depth", "hole_radius"});
  Spout spout{.foot = section.Point("foot"), .tip = section.Point("tip")};
  spout.foot_width = section.Number("foot_width");
  spout.foot_height = section.Number("foot_height");
  spout.foot_out = section.NumberOr("foot_out", 0);
  spout.rim_radius = section.Number("rim_radius");
  spout.hole_depth = section.Number("hole_depth");
  spout.hole_radius = section.Number("hole_radius");
  if (spout.foot == spout.tip) section.Fault("tip", "must differ from 'foot'");
  return spout;
}

void ReadProfile(Section section, Turned& turned) {
  section.AllowOnly({"rows", "radius", "y", "columns", "angles_deg", "knob_y", "knob_radius"});
  turned.profile_rows = section.Numbers("rows");
  turned.profile_radius = section.Numbers("radius");
  turned.profile_y = section.Numbers("y");
  turned.columns = section.Numbers("columns");
  turned.angles_deg = section.Numbers("angles_deg");
  turned.knob_y = section.Number("knob_y");
  turned.knob_radius = section.Number("knob_radius");
  NeedRising(section, "rows", turned.profile_rows);
  NeedRising(section, "columns", turned.columns);
  NeedCount(section, "radius", turned.profile_radius.size(), turned.profile_rows.size());
  NeedCount(section, "y", turned.profile_y.size(), turned.profile_rows.size());
  NeedCount(section, "angles_deg", turned.angles_deg.size(), turned.columns.size());
}

Turned ReadTurned(Section& file) {
  file.AllowOnly({"shape", "mouth_fit", "expression_gain", "profile", "eye", "mouth", "spout", "handle"});
  Turned turned;
  ReadProfile(file.Part("profile"), turned);
  Section eye = file.Part("eye");
  eye.AllowOnly({"yaw_deg", "thickness"});
  turned.eye_yaw_deg = eye.Number("yaw_deg");
  turned.lid_thickness = eye.NumberOr("thickness", turned.lid_thickness);
  Section mouth = file.Part("mouth");
  mouth.AllowOnly({"scale", "relief", "wall_radius"});
  turned.mouth_scale = Positive(mouth, "scale");
  turned.lip_relief = mouth.NumberOr("relief", 0);
  turned.wall_radius = Positive(mouth, "wall_radius");
  turned.spout = ReadSpout(file.Part("spout"));
  turned.handle = ReadTube(file.Part("handle"));
  return turned;
}

void ReadMouthFit(Section section, FaceRecipe& face) {
  section.AllowOnly({"teeth_scale", "teeth_offset", "upper_teeth", "lower_teeth", "tongue"});
  face.teeth_scale = section.NumberOr("teeth_scale", face.teeth_scale);
  face.teeth_offset = section.PointOr("teeth_offset", face.teeth_offset);
  face.upper_teeth = section.NumberOr("upper_teeth", face.upper_teeth);
  face.lower_teeth = section.NumberOr("lower_teeth", face.lower_teeth);
  face.tongue = section.NumberOr("tongue", face.tongue);
}

void ReadShape(Section& file, FaceRecipe& face) {
  const std::string shape = file.Word("shape");
  if (shape == "carved") {
    face.shape = ReadCarved(file, std::get<Carved>(face.shape));
  } else if (shape == "warped") {
    face.shape = ReadWarped(file);
  } else if (shape == "turned") {
    face.shape = ReadTurned(file);
  } else {
    file.Fault("shape", "must be \"carved\", \"warped\" or \"turned\"");
  }
}

enum class Borrowing { kAllowed, kRefused };  // A face is like another one, and that one like none.

Result<FaceRecipe> ReadFace(const std::filesystem::path& path, Borrowing borrowing) {
  const Result<Value> value = ReadToml(path);
  if (!value) return tl::unexpected(value.error());
  Faults faults(path.string());
  Section file(*value, "", faults);
  FaceRecipe face{.name = "", .file = path.string(), .shape = Carved{}};
  if (file.Has("like")) {
    const std::filesystem::path model = path.parent_path() / (file.Word("like") + ".toml");
    Result<FaceRecipe> other = tl::unexpected(Error{});
    if (borrowing == Borrowing::kAllowed) other = ReadFace(model, Borrowing::kRefused);
    const bool sound = other && std::holds_alternative<Carved>(other->shape);
    if (sound) face = std::move(*other);
    if (!sound) file.Fault("like", "must name a sound, carved face that is like no other");
  }
  face.file = path.string();
  ReadShape(file, face);
  if (file.Has("mouth_fit")) ReadMouthFit(file.Part("mouth_fit"), face);
  face.expression_gain = file.NumberOr("expression_gain", face.expression_gain);
  const Result<void> verdict = faults.Verdict();
  if (!verdict) return tl::unexpected(verdict.error());
  return face;
}

// What is wrong with several files, one a line.
struct Complaints {
  std::string text;

  template <class T>
  void Hear(const Result<T>& result) {
    if (!result) text += (text.empty() ? "" : "\n") + result.error().message();
  }
};

}  // namespace

Result<CastRecipe> ReadCastRecipe(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / "cast.toml";
  const Result<Value> value = ReadToml(path);
  if (!value) return tl::unexpected(value.error());
  Faults faults(path.string());
  Section file(*value, "", faults);
  file.AllowOnly({"faces", "aim"});
  CastRecipe cast{.aim = ReadAim(file.Part("aim")), .faces = {}};
  const std::vector<std::string> names = file.Words("faces");
  if (names.empty()) file.Fault("faces", "there must be one at least");
  for (auto name = names.begin(); name != names.end(); ++name)
    if (std::find(names.begin(), name, *name) != name)
      file.Fault("faces", "\"" + *name + "\" is given twice");
  Complaints complaints;
  complaints.Hear(faults.Verdict());
  for (const std::string& name : names) {
    Result<FaceRecipe> face = ReadFace(folder / (name + ".toml"), Borrowing::kAllowed);
    complaints.Hear(face);
    if (!face) continue;
    face->name = name;
    cast.faces.push_back(std::move(*face));
  }
  if (!complaints.text.empty()) return FailInput(complaints.text);
  if (!std::holds_alternative<Carved>(cast.faces.front().shape)) {
    return FailInput(cast.faces.front().file + ": shape: the first face must be \"carved\"");
  }
  return cast;
}

}  // namespace kaori::sculpt
