#include "appliance/authoring/import/worn.h"

#include <algorithm>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "appliance/authoring/import/head_shape.h"
#include "appliance/authoring/import/outline.h"

namespace kaori::import {
namespace {

// Of the differences that tell how a warp turns and stretches: finer than any of its pulls are apart, coarse
// enough for single precision.
constexpr float kStep_m = 1e-3F;

bool IsMouth(face::Part part) {
  return part == face::Part::kUpperTeeth || part == face::Part::kLowerTeeth || part == face::Part::kTongue;
}

bool HaveTeeth(const Heads& heads) {
  return std::ranges::find(heads.part, PartOf::kUpperTeeth) != heads.part.end();
}

// The show's cast with one face, which becomes its reference, and no more than its shape needs: textures and
// props are large.
HeadShape ShapeOfFace(const face::Cast& show, std::size_t face) {
  face::Cast alone;
  alone.topology = show.topology;
  alone.net = show.net;
  alone.faces = {show.faces[face]};
  alone.expressions = show.expressions;
  alone.blink = show.blink;
  return ShapeOfCast(alone);
}

// The motions are the first head's, also for the others: one topology, so vertices correspond.
HeadShape ShapeOfHead(const Heads& heads, const Head& head) {
  HeadShape shape = ShapeOfHeads(heads);
  shape.positions = head.positions;
  shape.eyes = head.eyes;
  return shape;
}

glm::vec3 Lead(const sculpt::Warp& warp, const glm::vec3& point) {
  return glm::vec3(warp(glm::dvec3(point)));
}

// How the warp turns and stretches what lies about a point: its Jacobian, column by column,
// by forward differences.
glm::mat3 Turning(const sculpt::Warp& warp, const glm::vec3& at) {
  const glm::vec3 led = Lead(warp, at);
  glm::mat3 turning;
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 beside = at;
    beside[axis] += kStep_m;
    turning[axis] = (Lead(warp, beside) - led) / kStep_m;
  }
  return turning;
}

// `otherwise` where the vector has no length.
glm::vec3 Unit(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

// A copy of the prop on another head. Teeth are brought to where the lending face wears them first
// (MouthFit), since its warp is from that face. Normals go by the inverse transpose, tangents along.
face::Prop Led(const face::Prop& prop, const face::MouthFit& fit, const face::Cast& show,
               const sculpt::Warp& warp) {
  face::Prop led = prop;
  for (face::PropVertex& vertex : led.vertices) {
    glm::vec3 at = vertex.position;
    if (IsMouth(prop.part)) at = (at - show.mouth_anchor) * fit.scale + show.mouth_anchor + fit.offset;
    const glm::mat3 turning = Turning(warp, at);
    vertex.position = Lead(warp, at);
    vertex.normal = Unit(glm::transpose(glm::inverse(turning)) * vertex.normal, vertex.normal);
    vertex.tangent = Unit(turning * vertex.tangent, vertex.tangent);
  }
  return led;
}

}  // namespace

// The last name stands for all heads behind it; heads without any name are like the show's first face.
std::vector<std::size_t> FacesToBeLike(const std::vector<std::string>& names, std::size_t heads,
                                       const face::Cast* show, Findings& findings) {
  std::vector<std::size_t> like(heads, 0);
  if (names.empty()) return like;
  if (show == nullptr) {
    findings.Add("--like", "", "there is no show whose faces could lend their look");
    return like;
  }
  // Names beyond the heads are of no use, but are checked all the same.
  for (std::size_t i = 0; i < std::max(heads, names.size()); ++i) {
    const std::string& name = names[std::min(i, names.size() - 1)];
    const auto face = std::ranges::find(show->faces, name, &face::Face::name);
    if (face == show->faces.end() && i < names.size())
      findings.Add("--like", name, "the show has no such face");
    if (face != show->faces.end() && i < heads)
      like[i] = static_cast<std::size_t>(face - show->faces.begin());
  }
  return like;
}

// Each head has a warp of its own, from the face that it is like.
std::string DressLike(const Heads& heads, const Lender& lender, face::Cast& cast) {
  if (lender.show == nullptr) return "hair and clothes: none; a show lends them";
  const bool lacks_teeth = !HaveTeeth(heads);
  std::string worn;
  for (std::size_t i = 0; i < heads.heads.size(); ++i) {
    const face::Face& like = lender.show->faces[lender.like[i]];
    face::Face& face = cast.faces[i];
    // From the face that lends to the head. None where landmarks are too few; the head then stays bare.
    const auto warp = sculpt::Warp::Through(
        OutlinePulls(ShapeOfFace(*lender.show, lender.like[i]), ShapeOfHead(heads, heads.heads[i])));
    if (!warp) continue;
    face.eye_look.iris = like.eye_look.iris;
    face.eye_surface = like.eye_surface;
    for (const int index : like.props) {
      const face::Prop& prop = lender.show->props[static_cast<std::size_t>(index)];
      if (IsMouth(prop.part) && !lacks_teeth) continue;
      face.props.push_back(static_cast<int>(cast.props.size()));
      cast.props.push_back(Led(prop, like.mouth, *lender.show, *warp));
      cast.props.back().name = heads.heads[i].name + " " + prop.name;
    }
    worn += fmt::format("{}{} as {}", worn.empty() ? "" : ", ", face.name, like.name);
  }
  return "hair and clothes: " + (worn.empty() ? std::string("none") : worn);
}

}  // namespace kaori::import
