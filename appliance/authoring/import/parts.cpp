#include "appliance/authoring/import/parts.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "appliance/authoring/import/roles.h"

namespace kaori::import {
namespace {

// Radii of eyes that are taken for such: a child's is 11 mm, a stylised figure's up to three times as large.
// Buttons and beads are smaller.
constexpr float kSmallestEye_m = 0.006F;
constexpr float kLargestEye_m = 0.035F;
// Of the radius, root mean square: eyes have corneas, and some only a front half.
constexpr float kRoughBall = 0.08F;
// The same of all that one eye is made of, which may be several meshes; two balls are far above.
constexpr float kSeveralBalls = 0.2F;
constexpr float kPartsMiddle_m = 0.01F;  // A mouth's piece lies this near to the plane of symmetry.
// Of the jaw's largest motion; upper teeth hang on the skull and do not move at all, but for tools
// that blur weights.
constexpr float kStaysUp = 0.15F;
constexpr float kTongueWide = 0.8F;  // Of the teeth's width.
// Teeth that lie so little below the others are of the same row: single teeth differ in height.
constexpr float kLevel_m = 0.002F;

// A connected piece of the surface and its box, in the model's frame.
struct Piece {
  std::vector<Index> vertices;
  glm::vec3 least{1e9F};
  glm::vec3 most{-1e9F};
  glm::vec3 middle() const { return 0.5F * (least + most); }
};

// By the graph's numbers, so welded seams do not part a piece.
std::vector<Piece> PiecesOf(const Model& model, const MeshGraph& graph) {
  std::vector<Piece> pieces(graph.pieces());
  for (Index v = 0; v < model.positions.size(); ++v) {
    Piece& piece = pieces[graph.piece()[v]];
    piece.vertices.push_back(v);
    piece.least = glm::min(piece.least, model.positions[v]);
    piece.most = glm::max(piece.most, model.positions[v]);
  }
  return pieces;
}

// The ball through points by linear least squares: |p - c|^2 = r^2 is linear in c and r^2 - |c|^2, as 2 c.p +
// (r^2 - |c|^2) = |p|^2. Unknowns and normal matrix are doubles about the first vertex, since squares of
// positions far from the origin cancel out.
std::optional<face::EyeBall> Ball(const Model& model, const std::vector<Index>& vertices) {
  if (vertices.size() < 8) return std::nullopt;
  const glm::dvec3 origin(model.positions[vertices.front()]);
  glm::dmat4 normal(0.0);
  glm::dvec4 right(0.0);
  for (const Index v : vertices) {
    const glm::dvec3 p = glm::dvec3(model.positions[v]) - origin;
    const glm::dvec4 row(p, 1);
    normal += glm::outerProduct(row, row);
    right += row * glm::dot(p, p);
  }
  // All points lie in one plane (or are too small to tell).
  if (std::abs(glm::determinant(normal)) < 1e-30) return std::nullopt;
  const glm::dvec4 solved = glm::inverse(normal) * right;
  const glm::dvec3 centre = 0.5 * glm::dvec3(solved);
  const double square = solved.w + glm::dot(centre, centre);
  if (!(square > 0)) return std::nullopt;
  return face::EyeBall{glm::vec3(centre + origin), static_cast<float>(std::sqrt(square)), 0};
}

// How far vertices lie off a ball, of its radius, root mean square.
double Roughness(const Model& model, const std::vector<Index>& vertices, const face::EyeBall& ball) {
  double sum = 0;
  for (const Index v : vertices) {
    const double off = glm::distance(model.positions[v], ball.centre) - ball.radius_m;
    sum += off * off;
  }
  return std::sqrt(sum / static_cast<double>(vertices.size())) / ball.radius_m;
}

// Numbers of the model's vertices, ascending.
std::vector<Index> VerticesOf(const std::vector<PartOf>& parts, PartOf part) {
  std::vector<Index> vertices;
  for (Index v = 0; v < parts.size(); ++v)
    if (parts[v] == part) vertices.push_back(v);
  return vertices;
}

// A ball of an eye's size that is round, and of which at least half the height is there.
bool IsBall(const Model& model, const Piece& piece) {
  const auto ball = Ball(model, piece.vertices);
  if (!ball || ball->radius_m < kSmallestEye_m || ball->radius_m > kLargestEye_m) return false;
  const float height = piece.most.y - piece.least.y;
  return Roughness(model, piece.vertices, *ball) < kRoughBall && height > ball->radius_m;
}

// In small letters; empty where no mesh holds the vertex.
std::string MeshName(const Model& model, Index vertex) {
  for (const model::MeshRange& mesh : model.meshes) {
    if (!mesh.Holds(vertex)) continue;
    std::string name = mesh.name;
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
  }
  return {};
}

// How far a target moves a piece at most, compared with the farthest that it moves anything: 0..1. 0
// without a target.
float Moved(const Target* target, const Piece& piece) {
  if (target == nullptr) return 0;
  const auto length = [&](Index v) { return glm::length(target->offsets[v]); };
  float most = 1e-9F;
  for (const glm::vec3& offset : target->offsets) most = std::max(most, glm::length(offset));
  float here = 0;
  for (const Index v : piece.vertices) here = std::max(here, length(v));
  return here / most;
}

// Says of each piece what it is; the jaw and the tongue are known by their targets, where the artist made
// some. Borrows the model.
class Sorter {
 public:
  Sorter(const Model& model, const MeshGraph& graph)
      : model_(model),
        pieces_(PiecesOf(model, graph)),
        jaw_(FindTarget(model, "jaw_open")),
        tongue_(FindTarget(model, "tongue_out")) {}

  // The skin is found first, since what lies inside it depends on its box.
  std::vector<PartOf> Sort() {
    std::vector<PartOf> parts(model_.positions.size(), PartOf::kSkin);
    // By the diagonal of the box: the skin is the largest piece, whatever its number of vertices.
    const auto size = [](const Piece& piece) { return glm::distance(piece.least, piece.most); };
    const auto head = std::ranges::max_element(pieces_, {}, size);
    for (auto piece = pieces_.begin(); piece != pieces_.end(); ++piece) {
      if (piece == head) continue;
      const PartOf part = PartOfPiece(*piece, *head);
      for (const Index v : piece->vertices) parts[v] = part;
    }
    // Without a jaw's motion, PartOfPiece has called everything in the mouth upper teeth.
    if (jaw_ == nullptr) SortMouth(parts);
    return parts;
  }

 private:
  // The order of the tests matters: eyes lie to the sides; what is neither an eye nor inside the head is skin
  // (lashes, hair, a collar); names say more than motions.
  PartOf PartOfPiece(const Piece& piece, const Piece& head) const {
    const std::string name = MeshName(model_, piece.vertices.front());
    const float side = piece.middle().x - head.middle().x;
    if (IsBall(model_, piece) && std::abs(side) > kPartsMiddle_m)
      return side > 0 ? PartOf::kLeftEye : PartOf::kRightEye;
    if (std::abs(side) > kPartsMiddle_m || !IsInside(piece, head)) return PartOf::kSkin;
    const float jaw = Moved(jaw_, piece);
    if (name.find("tongue") != std::string::npos) return PartOf::kTongue;
    const bool teeth = IsNamedTeeth(piece);
    if (jaw_ == nullptr) return teeth || IsInMouth(piece, head) ? PartOf::kUpperTeeth : PartOf::kSkin;
    if (!teeth && Moved(tongue_, piece) > 0.5F) return PartOf::kTongue;
    return jaw < kStaysUp ? PartOf::kUpperTeeth : PartOf::kLowerTeeth;
  }

  // By the mesh's name in the file. A piece without the word may be teeth all the same: this only settles
  // doubts.
  bool IsNamedTeeth(const Piece& piece) const {
    const std::string name = MeshName(model_, piece.vertices.front());
    return name.find("teeth") != std::string::npos || name.find("tooth") != std::string::npos;
  }

  static void Name(const Piece& piece, PartOf part, std::vector<PartOf>& parts) {
    for (const Index v : piece.vertices) parts[v] = part;
  }

  // In the lower half of the head's front: a pharynx, or a stand inside the skull, is none of the mouth.
  static bool IsInMouth(const Piece& piece, const Piece& head) {
    return piece.middle().z > head.middle().z && piece.most.y < head.middle().y;
  }

  // No motion tells: the tongue is narrower than the teeth, the lower teeth lie below the upper ones, that is
  // below the mean height of all teeth.
  void SortMouth(std::vector<PartOf>& parts) const {
    float widest_m = 0;
    float sum = 0;
    std::vector<const Piece*> teeth;
    for (const Piece& piece : pieces_)
      if (parts[piece.vertices.front()] == PartOf::kUpperTeeth)
        widest_m = std::max(widest_m, piece.most.x - piece.least.x);
    for (const Piece& piece : pieces_) {
      if (parts[piece.vertices.front()] != PartOf::kUpperTeeth) continue;
      const bool narrow = piece.most.x - piece.least.x < kTongueWide * widest_m;
      if (narrow && !IsNamedTeeth(piece)) {
        Name(piece, PartOf::kTongue, parts);
      } else {
        teeth.push_back(&piece);
        sum += piece.middle().y;
      }
    }
    for (const Piece* piece : teeth)
      if (piece->middle().y < sum / static_cast<float>(teeth.size()) - kLevel_m)
        Name(*piece, PartOf::kLowerTeeth, parts);
  }

  // Within the head's box and no more than a part of it: a bonnet is wider, a throat is higher.
  static bool IsInside(const Piece& piece, const Piece& head) {
    const glm::vec3 room = head.most - head.least;
    const glm::vec3 size = piece.most - piece.least;
    return glm::all(glm::greaterThan(piece.least, head.least)) &&
           glm::all(glm::lessThan(piece.most, head.most)) && size.x < 0.6F * room.x && size.y < 0.3F * room.y;
  }

  const Model& model_;
  std::vector<Piece> pieces_;
  const Target* jaw_;
  const Target* tongue_;
};

}  // namespace

std::string_view NameOf(PartOf part) {
  switch (part) {
    case PartOf::kSkin:
      return "skin";
    case PartOf::kLeftEye:
      return "left eye";
    case PartOf::kRightEye:
      return "right eye";
    case PartOf::kUpperTeeth:
      return "upper teeth";
    case PartOf::kLowerTeeth:
      return "lower teeth";
    case PartOf::kTongue:
      return "tongue";
  }
  return "";
}

std::vector<PartOf> FindParts(const Model& model, const MeshGraph& graph) {
  return Sorter(model, graph).Sort();
}

// All vertices of the part together: cornea, iris and white may be meshes of their own.
std::optional<face::EyeBall> FitBall(const Model& model, const std::vector<PartOf>& parts, PartOf part) {
  return Ball(model, VerticesOf(parts, part));
}

// A side without an eye is DoubtsAbout's business.
bool IsOneBall(const Model& model, const std::vector<PartOf>& parts, PartOf part) {
  const std::vector<Index> vertices = VerticesOf(parts, part);
  const auto ball = Ball(model, vertices);
  return !ball || (ball->radius_m <= kLargestEye_m && Roughness(model, vertices, *ball) < kSeveralBalls);
}

}  // namespace kaori::import
