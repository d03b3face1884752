#include "appliance/authoring/sculpt/body_file.h"

#include <algorithm>
#include <string>

#include <fmt/format.h>

namespace kaori::sculpt {
namespace {

// Of a body, in centimetres. Outside of it a length was meant in metres or in millimetres.
constexpr double kFarthestBody_cm = 60;
// Of its largest radius; the grid's cells are coarser.
constexpr double kLeastRadius_cm = 0.1;

// Radii of a body, or halves of a box: all positive, and the largest within the bounds.
void NeedSizes(toml::Section& section, std::string_view key, glm::dvec3 sizes) {
  if (!(sizes.x > 0 && sizes.y > 0 && sizes.z > 0)) return section.Fault(key, "must be greater than 0");
  const double most = std::max({sizes.x, sizes.y, sizes.z});
  if (most < kLeastRadius_cm || most > kFarthestBody_cm)
    section.Fault(
        key, fmt::format("the largest is {}, and must lie between {} and {}: lengths are centimetres", most,
                         kLeastRadius_cm, kFarthestBody_cm));
}

// The readers of one shape allow the keys of that shape alone, so that a word that is spelled wrongly
// is a fault.
Body ReadEllipsoid(toml::Section& section) {
  section.AllowOnly({"ellipsoid", "centre", "radii", "mirrored", "blend"});
  Body body{.shape = Body::Shape::kEllipsoid,
            .a = section.Point_cm("centre", kFarthestBody_cm),
            .b = section.Point("radii")};
  NeedSizes(section, "radii", body.b);
  return body;
}

// Two radii, for its two ends; the larger one counts against the bounds.
Body ReadCapsule(toml::Section& section) {
  section.AllowOnly({"capsule", "from", "to", "radii", "mirrored", "blend"});
  Body body{.shape = Body::Shape::kCapsule,
            .a = section.Point_cm("from", kFarthestBody_cm),
            .b = section.Point_cm("to", kFarthestBody_cm)};
  const std::vector<double> radii = section.Numbers("radii");
  if (radii.size() != 2) section.Fault("radii", "must have 2 entries");
  if (radii.size() == 2) {
    body.radius_a_cm = radii[0], body.radius_b_cm = radii[1];
    NeedSizes(section, "radii", {radii[0], radii[1], std::max(radii[0], radii[1])});
  }
  if (body.a == body.b) section.Fault("to", "must differ from 'from'");
  return body;
}

// Rounding takes its radius off the halves, so it can be no larger than the least of them.
Body ReadBox(toml::Section& section) {
  section.AllowOnly({"box", "centre", "half", "rounding", "mirrored", "blend"});
  Body body{.shape = Body::Shape::kBox,
            .a = section.Point_cm("centre", kFarthestBody_cm),
            .b = section.Point("half")};
  NeedSizes(section, "half", body.b);
  body.radius_a_cm = section.NumberOr("rounding", 0);
  const double most_cm = std::min({body.b.x, body.b.y, body.b.z});
  if (!(body.radius_a_cm >= 0 && body.radius_a_cm <= most_cm))
    section.Fault("rounding", "must lie between 0 and the least of 'half'");
  return body;
}

}  // namespace

// A body names its shape by the key whose value is "add" or "cut"; without such a key the fault
// is of "ellipsoid".
Body ReadBody(toml::Section section) {
  const std::string_view shape = section.Has("capsule") ? "capsule"
                                 : section.Has("box")   ? "box"
                                                        : "ellipsoid";
  const std::string join = section.Text(shape);
  Body body = shape == "capsule" ? ReadCapsule(section)
              : shape == "box"   ? ReadBox(section)
                                 : ReadEllipsoid(section);
  if (join != "add" && join != "cut") section.Fault(shape, "must be \"add\" or \"cut\"");
  body.join = join == "cut" ? Body::Join::kCut : Body::Join::kAdd;
  // 0 or 1 in the file.
  body.mirrored = section.NumberOr("mirrored", 0) != 0;
  body.blend_cm = section.NumberOr("blend", 0);
  return body;
}

}  // namespace kaori::sculpt
