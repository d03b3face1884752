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

constexpr float kSmallestEye_m = 0.006F;
constexpr float kLargestEye_m = 0.035F;
constexpr float kRoughBall = 0.08F;      // Of the radius: eyes have corneas.
constexpr float kPartsMiddle_m = 0.01F;  // A mouth's piece lies this near to the plane of symmetry.
constexpr float kStaysUp = 0.15F;        // Of the jaw's largest motion.
constexpr float kTongueWide = 0.8F;      // Of the teeth's width.
constexpr float kLevel_m = 0.002F;       // Teeth so little below the others are of the same row.

struct Piece {
  std::vector<Index> vertices;
  glm::vec3 least{1e9F};
  glm::vec3 most{-1e9F};
  glm::vec3 middle() const { return 0.5F * (least + most); }
};

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

// |p - c|^2 = r^2 is linear in c and r^2 - |c|^2.
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
  if (std::abs(glm::determinant(normal)) < 1e-30) return std::nullopt;
  const glm::dvec4 solved = glm::inverse(normal) * right;
  const glm::dvec3 centre = 0.5 * glm::dvec3(solved);
  const double square = solved.w + glm::dot(centre, centre);
  if (!(square > 0)) return std::nullopt;
  return face::EyeBall{glm::vec3(centre + origin), static_cast<float>(std::sqrt(square)), 0};
}

bool IsBall(const Model& model, const Piece& piece) {
  const auto ball = Ball(model, piece.vertices);
  if (!ball || ball->radius_m < kSmallestEye_m || ball->radius_m > kLargestEye_m) return false;
  double sum = 0;
  for (const Index v : piece.vertices) {
    const double off = glm::distance(model.positions[v], ball->centre) - ball->radius_m;
    sum += off * off;
  }
  const double rough = std::sqrt(sum / static_cast<double>(piece.vertices.size()));
  const float height = piece.most.y - piece.least.y;
  return rough < kRoughBall * ball->radius_m && height > ball->radius_m;
}

std::string MeshName(const Model& model, Index vertex) {
  for (const MeshRange& mesh : model.meshes) {
    if (vertex < mesh.first || vertex >= mesh.first + mesh.count) continue;
    std::string name = mesh.name;
    std::ranges::transform(name, name.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return name;
  }
  return {};
}

// How far a target moves a piece at most, compared with the farthest that it moves anything.
float Moved(const Target* target, const Piece& piece) {
  if (target == nullptr) return 0;
  const auto length = [&](Index v) { return glm::length(target->offsets[v]); };
  float most = 1e-9F;
  for (const glm::vec3& offset : target->offsets) most = std::max(most, glm::length(offset));
  float here = 0;
  for (const Index v : piece.vertices) here = std::max(here, length(v));
  return here / most;
}

class Sorter {
 public:
  Sorter(const Model& model, const MeshGraph& graph)
      : model_(model),
        pieces_(PiecesOf(model, graph)),
        jaw_(FindTarget(model, "jaw_open")),
        tongue_(FindTarget(model, "tongue_out")) {}

  std::vector<PartOf> Sort() {
    std::vector<PartOf> parts(model_.positions.size(), PartOf::kSkin);
    const auto size = [](const Piece& piece) { return glm::distance(piece.least, piece.most); };
    const auto head = std::ranges::max_element(pieces_, {}, size);
    for (auto piece = pieces_.begin(); piece != pieces_.end(); ++piece) {
      if (piece == head) continue;
      const PartOf part = PartOfPiece(*piece, *head);
      for (const Index v : piece->vertices) parts[v] = part;
    }
    if (jaw_ == nullptr) SortMouth(parts);
    return parts;
  }

 private:
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

  bool IsNamedTeeth(const Piece& piece) const {
    const std::string name = MeshName(model_, piece.vertices.front());
    return name.find("teeth") != std::string::npos || name.find("tooth") != std::string::npos;
  }

  static void Name(const Piece& piece, PartOf part, std::vector<PartOf>& parts) {
    for (const Index v : piece.vertices) parts[v] = part;
  }

  static bool IsInMouth(const Piece& piece, const Piece& head) {
    return piece.middle().z > head.middle().z && piece.most.y < head.middle().y;
  }

  // No motion tells: the tongue is narrower than the teeth, the lower teeth lie below the upper ones.
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

std::optional<face::EyeBall> FitBall(const Model& model, const std::vector<PartOf>& parts, PartOf part) {
  std::vector<Index> vertices;
  for (Index v = 0; v < parts.size(); ++v)
    if (parts[v] == part) vertices.push_back(v);
  return Ball(model, vertices);
}

}  // namespace kaori::import
