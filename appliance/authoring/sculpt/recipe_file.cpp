#include "appliance/authoring/sculpt/recipe_parts.h"

#include <algorithm>
#include <string>
#include <utility>

#include "appliance/authoring/sculpt/body_file.h"
#include "appliance/core/toml/nearest.h"

namespace kaori::sculpt {
namespace {

// Two numbers at least, each larger than the one before: what Pchip needs.
bool Rises(const std::vector<double>& x) {
  for (std::size_t i = 1; i < x.size(); ++i) {
    if (!(x[i] > x[i - 1])) return false;
  }
  return x.size() >= 2;
}

// The Need... functions put a fault where a value is not as it must be; reading goes on with it.
void NeedRising(toml::Section& section, std::string_view key, const std::vector<double>& x) {
  if (!Rises(x)) section.Fault(key, "must be two numbers or more that rise");
}

void NeedCount(toml::Section& section, std::string_view key, std::size_t count, std::size_t wanted) {
  if (count != wanted) section.Fault(key, "must have " + std::to_string(wanted) + " entries");
}

void NeedPositive(toml::Section& section, std::string_view key, double value) {
  if (!(value > 0)) section.Fault(key, "must be greater than 0");
}

// The value is returned even where it is a fault: the verdict comes at the end, and nothing is built before
// it.
double Positive(toml::Section& section, std::string_view key) {
  const double value = section.Number(key);
  NeedPositive(section, key, value);
  return value;
}

// What a part of a head can measure, in centimetres, with room for giants and puppets. Outside of it a length
// was meant in metres or in millimetres.
constexpr toml::Range kEyeRadius_cm{0.3, 10};
constexpr toml::Range kLidHeight_cm{0.05, 10};
constexpr toml::Range kMouthHalfWidth_cm{0.2, 15};
constexpr toml::Range kLipHeight_cm{0.03, 8};

// [eye] of a carved face: the left one.
EyeRecipe ReadEye(toml::Section section) {
  section.AllowOnly(
      {"centre", "radius", "inner", "outer", "upper_height", "lower_height", "thickness", "crease"});
  EyeRecipe eye;
  eye.centre = section.Point_cm("centre", kFarthest_cm);
  eye.radius = section.Length_cm("radius", kEyeRadius_cm);
  const std::vector<double> inner = section.Numbers("inner");
  const std::vector<double> outer = section.Numbers("outer");
  NeedCount(section, "inner", inner.size(), 2);
  NeedCount(section, "outer", outer.size(), 2);
  if (inner.size() == 2) eye.inner_x = inner[0], eye.inner_y = inner[1];
  if (outer.size() == 2) eye.outer_x = outer[0], eye.outer_y = outer[1];
  eye.upper_height = section.Length_cm("upper_height", kLidHeight_cm);
  eye.lower_height = section.Length_cm("lower_height", kLidHeight_cm);
  eye.thickness = section.NumberOr("thickness", eye.thickness);
  eye.crease = section.NumberOr("crease", eye.crease);
  return eye;
}

// [mouth] of a carved face.
MouthRecipe ReadMouth(toml::Section section) {
  section.AllowOnly({"half_width", "y", "upper_height", "lower_height", "upturn", "fullness"});
  MouthRecipe mouth;
  mouth.half_width = section.Length_cm("half_width", kMouthHalfWidth_cm);
  mouth.y = section.Length_cm("y", {-kFarthest_cm, kFarthest_cm});
  mouth.upper_height = section.Length_cm("upper_height", kLipHeight_cm);
  mouth.lower_height = section.Length_cm("lower_height", kLipHeight_cm);
  mouth.upturn = section.NumberOr("upturn", 0);
  mouth.fullness = section.NumberOr("fullness", mouth.fullness);
  return mouth;
}

// [ear]; what is not said keeps the usual ear's size.
EarRecipe ReadEar(toml::Section section) {
  section.AllowOnly({"height", "width", "tilt_deg"});
  EarRecipe ear;
  ear.height = section.NumberOr("height", ear.height);
  ear.width = section.NumberOr("width", ear.width);
  ear.tilt_deg = section.NumberOr("tilt_deg", ear.tilt_deg);
  return ear;
}

// [scale] of a carved face. A factor that is not said leaves its direction of the table as it is.
AimScale ReadScale(toml::Section section) {
  section.AllowOnly({"x", "y_above_eyes", "y_below_eyes"});
  return {.x = section.NumberOr("x", 1),
          .y_above_eyes = section.NumberOr("y_above_eyes", 1),
          .y_below_eyes = section.NumberOr("y_below_eyes", 1)};
}

// A vertex by name, and where it goes.
Landmark ReadLandmark(toml::Section section) {
  section.AllowOnly({"at", "to"});
  const auto vertex = AsVertex(section.Text("at"));
  if (!vertex) section.Fault("at", "names no vertex");
  return {vertex.value_or(Key{}), section.Point_cm("to", kFarthest_cm)};
}

// A touched vertex keeps to the grid: rings are laid after it. The middle of the face stays in the middle.
Landmark ReadTouch(const toml::Section& section) {
  Landmark touch = ReadLandmark(section);
  toml::Section named = section;
  if (touch.vertex.region != Region::kGrid) named.Fault("at", "must be a vertex of the grid");
  if (touch.vertex.a == 0 && touch.target.x != 0) named.Fault("to", "must stay in the middle, at x = 0");
  return touch;
}

// What a face that is "like" another one does not say, it takes from there; bodies and touches come on top.
Carved ReadCarved(toml::Section& file, Carved carved) {
  file.AllowOnly(
      {"shape", "like", "mouth_fit", "expression_gain", "scale", "body", "touch", "eye", "mouth", "ear"});
  const bool alone = !file.Has("like");
  if (file.Has("scale")) carved.scale = ReadScale(file.Part("scale"));
  for (const toml::Section& body : file.Parts("body")) carved.bodies.push_back(ReadBody(body));
  if (alone && carved.bodies.empty()) file.Fault("body", "there must be one at least");
  for (const toml::Section& touch : file.Parts("touch")) carved.touches.push_back(ReadTouch(touch));
  if (alone || file.Has("eye")) carved.eye = ReadEye(file.Part("eye"));
  if (alone || file.Has("mouth")) carved.mouth = ReadMouth(file.Part("mouth"));
  if (file.Has("ear")) carved.ear = ReadEar(file.Part("ear"));
  return carved;
}

// [ear_tube] of an animal, [handle] of a kettle: one station for each ring of the ear, and the one
// inside the head.
Tube ReadTube(toml::Section section) {
  section.AllowOnly({"path", "half_width", "half_thickness", "width_direction", "cap", "hangs_from_y"});
  Tube tube{.path = section.Points("path"),
            .half_width = section.Numbers("half_width"),
            .half_thickness = section.Numbers("half_thickness"),
            .width_direction = section.Point("width_direction"),
            .cap = section.NumberOr("cap", 0)};
  if (section.Has("hangs_from_y")) tube.hangs_from_y = section.Number("hangs_from_y");
  constexpr std::size_t kStations = kEarRings + 1;
  NeedCount(section, "path", tube.path.size(), kStations);
  NeedCount(section, "half_width", tube.half_width.size(), kStations);
  NeedCount(section, "half_thickness", tube.half_thickness.size(), kStations);
  if (tube.width_direction == glm::dvec3(0)) section.Fault("width_direction", "must point somewhere");
  return tube;
}

// More would only take time: a cage of this size is as smooth as a ball long before.
constexpr int kMostSmoothing = 1000;

// An animal: nothing of the reference face can be left out, only pulled.
Warped ReadWarped(toml::Section& file) {
  file.AllowOnly({"shape", "mouth_fit", "expression_gain", "eye", "landmark", "ear_tube", "smoothing_steps"});
  Warped warped;
  for (const toml::Section& landmark : file.Parts("landmark"))
    warped.landmarks.push_back(ReadLandmark(landmark));
  toml::Section eye = file.Part("eye");
  eye.AllowOnly({"shift", "scale", "radius", "thickness"});
  warped.eye_shift = eye.Point("shift");
  warped.eye_scale = Positive(eye, "scale");
  warped.eye_radius = eye.Length_cm("radius", kEyeRadius_cm);
  warped.lid_thickness = eye.NumberOr("thickness", warped.lid_thickness);
  warped.smoothing_steps = file.WholeOr("smoothing_steps", 0, 0, kMostSmoothing);
  warped.ear = ReadTube(file.Part("ear_tube"));
  return warped;
}

// [spout] of a kettle, in centimetres like all of the file. Its lengths have no bounds; only an axis without
// a length is refused, since it has no direction.
Spout ReadSpout(toml::Section section) {
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

// [profile]: the turned body by grid rows and columns.
void ReadProfile(toml::Section section, Turned& turned) {
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

// A kettle.
Turned ReadTurned(toml::Section& file) {
  file.AllowOnly({"shape", "mouth_fit", "expression_gain", "profile", "eye", "mouth", "spout", "handle"});
  Turned turned;
  ReadProfile(file.Part("profile"), turned);
  toml::Section eye = file.Part("eye");
  eye.AllowOnly({"yaw_deg", "thickness"});
  turned.eye_yaw_deg = eye.Number("yaw_deg");
  turned.lid_thickness = eye.NumberOr("thickness", turned.lid_thickness);
  toml::Section mouth = file.Part("mouth");
  mouth.AllowOnly({"scale", "relief", "wall_radius"});
  turned.mouth_scale = Positive(mouth, "scale");
  turned.lip_relief = mouth.NumberOr("relief", 0);
  turned.wall_radius = Positive(mouth, "wall_radius");
  turned.spout = ReadSpout(file.Part("spout"));
  turned.handle = ReadTube(file.Part("handle"));
  return turned;
}

// A head from a modelling tool. Its file lies beside the face's; a way that leads elsewhere would not come along
// with the show.
Modelled ReadModelled(toml::Section& file, const std::filesystem::path& folder) {
  file.AllowOnly({"shape", "mesh", "mouth_fit", "expression_gain", "eye"});
  const std::filesystem::path mesh = file.Text("mesh");
  if (mesh != mesh.filename()) file.Fault("mesh", "must be the name of a file beside this one");
  Modelled modelled{.mesh = folder / mesh};
  if (file.Has("eye")) {
    toml::Section eye = file.Part("eye");
    eye.AllowOnly({"thickness"});
    modelled.lid_thickness = eye.Number("thickness");
  }
  return modelled;
}

}  // namespace

// [aim] of cast.toml. Rows and columns must rise, since a spline runs through them in both directions.
AimTable ReadAim(toml::Section aim) {
  aim.AllowOnly({"columns", "rows"});
  AimTable table{.columns = aim.Numbers("columns"), .rows = {}, .points = {}};
  NeedRising(aim, "columns", table.columns);
  for (toml::Section& row : aim.Parts("rows")) {
    row.AllowOnly({"row", "points"});
    table.rows.push_back(row.Number("row"));
    table.points.push_back(row.Points("points"));
    NeedCount(row, "points", table.points.back().size(), table.columns.size());
  }
  NeedRising(aim, "rows", table.rows);
  return table;
}

// [mouth_fit]. In a face that is like another one `face` holds that one's values, and what is not said keeps
// them.
void ReadMouthFit(toml::Section section, FaceRecipe& face) {
  section.AllowOnly({"teeth_scale", "teeth_offset", "upper_teeth", "lower_teeth", "tongue"});
  face.teeth_scale = section.NumberOr("teeth_scale", face.teeth_scale);
  face.teeth_offset = section.PointOr("teeth_offset", face.teeth_offset);
  face.upper_teeth = section.NumberOr("upper_teeth", face.upper_teeth);
  face.lower_teeth = section.NumberOr("lower_teeth", face.lower_teeth);
  face.tongue = section.NumberOr("tongue", face.tongue);
}

// `face` holds a carved shape here: its own default, or that of the face that it is like.
void ReadShape(toml::Section& file, FaceRecipe& face) {
  const std::string shape = file.Text("shape");
  if (shape == "carved") {
    face.shape = ReadCarved(file, std::get<Carved>(face.shape));
  } else if (shape == "warped") {
    face.shape = ReadWarped(file);
  } else if (shape == "turned") {
    face.shape = ReadTurned(file);
  } else if (shape == "modelled") {
    face.shape = ReadModelled(file, std::filesystem::path(face.file).parent_path());
  } else {
    file.Fault("shape", "must be \"carved\", \"warped\", \"turned\" or \"modelled\"" +
                            toml::DidYouMean(shape, {"carved", "warped", "turned", "modelled"}));
  }
}

}  // namespace kaori::sculpt
