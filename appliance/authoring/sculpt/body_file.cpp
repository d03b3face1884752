#include "appliance/authoring/sculpt/body_file.h"

#include <algorithm>
#include <string>

namespace kaori::sculpt {
namespace {

bool AllPositive(glm::dvec3 v) {
  return v.x > 0 && v.y > 0 && v.z > 0;
}

Body ReadEllipsoid(Section& section) {
  section.AllowOnly({"ellipsoid", "centre", "radii", "mirrored", "blend"});
  Body body{.shape = Body::Shape::kEllipsoid, .a = section.Point("centre"), .b = section.Point("radii")};
  if (!AllPositive(body.b)) section.Fault("radii", "must be greater than 0");
  return body;
}

Body ReadCapsule(Section& section) {
  section.AllowOnly({"capsule", "from", "to", "radii", "mirrored", "blend"});
  Body body{.shape = Body::Shape::kCapsule, .a = section.Point("from"), .b = section.Point("to")};
  const std::vector<double> radii = section.Numbers("radii");
  if (radii.size() != 2) section.Fault("radii", "must have 2 entries");
  if (radii.size() == 2) body.radius_a_cm = radii[0], body.radius_b_cm = radii[1];
  if (body.a == body.b) section.Fault("to", "must differ from 'from'");
  return body;
}

Body ReadBox(Section& section) {
  section.AllowOnly({"box", "centre", "half", "rounding", "mirrored", "blend"});
  Body body{.shape = Body::Shape::kBox, .a = section.Point("centre"), .b = section.Point("half")};
  if (!AllPositive(body.b)) section.Fault("half", "must be greater than 0");
  body.radius_a_cm = section.NumberOr("rounding", 0);
  const double most_cm = std::min({body.b.x, body.b.y, body.b.z});
  if (!(body.radius_a_cm >= 0 && body.radius_a_cm <= most_cm))
    section.Fault("rounding", "must lie between 0 and the least of 'half'");
  return body;
}

}  // namespace

Body ReadBody(Section section) {
  const std::string_view shape = section.Has("capsule") ? "capsule"
                                 : section.Has("box")   ? "box"
                                                        : "ellipsoid";
  const std::string join = section.Word(shape);
  Body body = shape == "capsule" ? ReadCapsule(section)
              : shape == "box"   ? ReadBox(section)
                                 : ReadEllipsoid(section);
  if (join != "add" && join != "cut") section.Fault(shape, "must be \"add\" or \"cut\"");
  body.join = join == "cut" ? Body::Join::kCut : Body::Join::kAdd;
  body.mirrored = section.NumberOr("mirrored", 0) != 0;
  body.blend_cm = section.NumberOr("blend", 0);
  return body;
}

}  // namespace kaori::sculpt
