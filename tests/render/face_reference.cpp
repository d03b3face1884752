#include "tests/render/face_reference.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/mat2x2.hpp>
#include <glm/matrix.hpp>

namespace kaori::tests {
namespace {

using face::Cast;

// Two columns: the image of a step along u and of one along v.
struct Columns {
  glm::dvec3 u{};
  glm::dvec3 v{};
};

glm::dvec2 PlaceInMetres(const face::ControlPoint& point) {
  return {static_cast<double>(point.uv.x) * 0.42, static_cast<double>(point.uv.y) * 0.31};
}

Positions PlacesOnFace(const Cast& cast, std::size_t face) {
  Positions places(cast.net.points.size());
  const auto& rows = cast.net.surface;
  for (std::size_t r = 0; r < places.size(); ++r) {
    for (auto i = rows.row_start[r]; i < rows.row_start[r + 1]; ++i) {
      const glm::dvec3 vertex{cast.faces[face].positions[rows.column[i]]};
      places[r] += static_cast<double>(rows.weight[i]) * vertex;
    }
  }
  return places;
}

// Least squares by conjugate directions would do as well; here each coordinate is a plane z = a u + b v, by
// Cramer.
Columns FitPlanes(const Cast& cast, const Positions& places, std::size_t at) {
  double uu = 0;
  double uv = 0;
  double vv = 0;
  Columns sums;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec2 step = PlaceInMetres(cast.net.points[i]) - PlaceInMetres(cast.net.points[at]);
    const double w = std::exp(-(step.x * step.x + step.y * step.y) / (2 * 0.016 * 0.016));
    uu += w * step.x * step.x;
    uv += w * step.x * step.y;
    vv += w * step.y * step.y;
    sums.u += w * step.x * (places[i] - places[at]);
    sums.v += w * step.y * (places[i] - places[at]);
  }
  const double d = uu * vv - uv * uv;
  return {(vv * sums.u - uv * sums.v) / d, (uu * sums.v - uv * sums.u) / d};
}

// The polar factor by Newton's iteration, without square roots of matrices.
Columns NearestRotation(Columns x) {
  for (int step = 0; step < 60; ++step) {
    const glm::dmat2 square{glm::dot(x.u, x.u), glm::dot(x.u, x.v), glm::dot(x.u, x.v), glm::dot(x.v, x.v)};
    const glm::dmat2 inverse = glm::inverse(square);
    x = {0.5 * (x.u + inverse[0][0] * x.u + inverse[0][1] * x.v),
         0.5 * (x.v + inverse[1][0] * x.u + inverse[1][1] * x.v)};
  }
  return x;
}

// Displacements of the control points of a face, metres.
Positions Carried(const Cast& cast, std::size_t face, std::size_t expression) {
  const Positions places = PlacesOnFace(cast, face);
  const double gain = static_cast<double>(cast.faces[face].expression_gain);
  Positions moved(places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    const glm::dvec3 d{cast.expressions[expression].displacement[i]};
    const Columns slope = FitPlanes(cast, places, i);
    const Columns turn = NearestRotation(slope);
    const double size = std::sqrt(glm::length(glm::cross(slope.u, slope.v)));
    moved[i] = gain * size * (d.x * turn.u + d.y * turn.v + d.z * glm::cross(turn.u, turn.v));
  }
  return moved;
}

Positions Displacement(const Cast& cast, std::size_t face, std::size_t expression) {
  const Positions moved = Carried(cast, face, expression);
  Positions out(cast.topology.vertex_count);
  const auto& rows = cast.net.to_cage;
  for (std::size_t r = 0; r < rows.rows(); ++r) {
    for (auto i = rows.row_start[r]; i < rows.row_start[r + 1]; ++i) {
      out[r] += static_cast<double>(rows.weight[i]) * moved[rows.column[i]];
    }
  }
  return out;
}

void AddScaled(Positions& sum, double weight, const Positions& term) {
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] += weight * term[v];
}

Positions Base(const Cast& cast, std::size_t face) {
  const auto& positions = cast.faces[face].positions;
  return {positions.begin(), positions.end()};
}

// As Composer says of outgrowths: withdrawn by 1 - (1 - 4 k (1 - k))^2, k the mean kind of the faces.
void WithdrawOutgrowths(const Cast& cast, const face::Terms& faces, Positions& shape) {
  double kind = 0;
  for (const face::Term& s : faces)
    kind += static_cast<double>(s.weight) * static_cast<double>(cast.faces[s.index].outgrowth_kind);
  const double mixed = std::max(4 * kind * (1 - kind), 0.0);
  const double gone = 1 - (1 - mixed) * (1 - mixed);
  for (const face::Term& s : faces) {
    const auto& ways = cast.faces[s.index].withdrawn;
    for (std::size_t i = 0; i < ways.size(); ++i)
      shape[cast.topology.outgrowth[i]] += static_cast<double>(s.weight) * gone * glm::dvec3(ways[i]);
  }
}

}  // namespace

Positions ReferenceComposite(const Cast& cast, std::size_t face, std::size_t expression) {
  Positions composite = Base(cast, face);
  AddScaled(composite, 1, Displacement(cast, face, expression));
  return composite;
}

Positions ReferenceShape(const Cast& cast, const face::Weights& weights) {
  Positions shape(cast.topology.vertex_count);
  for (const face::Term& s : weights.faces) {
    Positions own(shape.size());
    for (const face::Term& t : weights.expressions) {
      AddScaled(own, static_cast<double>(t.weight), Displacement(cast, s.index, t.index));
    }
    for (std::size_t v = 0; v < own.size(); ++v) {
      own[v] *= 1 - static_cast<double>(weights.mouth_given_away) *
                        static_cast<double>(cast.topology.mouth_share[v]);
    }
    for (const face::Term& c : weights.channels) {
      AddScaled(own, static_cast<double>(c.weight), Displacement(cast, s.index, c.index));
    }
    AddScaled(own, 1, Base(cast, s.index));
    AddScaled(shape, static_cast<double>(s.weight), own);
  }
  WithdrawOutgrowths(cast, weights.faces, shape);
  return shape;
}

double HeadHeight_m(const Cast& cast) {
  const auto [low, high] = std::ranges::minmax(cast.faces[0].positions, {}, &glm::vec3::y);
  return static_cast<double>(high.y - low.y);
}

double LargestError_m(const Positions& wanted, std::span<const glm::vec3> got) {
  double largest = 0;
  for (std::size_t v = 0; v < wanted.size(); ++v) {
    largest = std::max(largest, glm::distance(wanted[v], glm::dvec3(got[v])));
  }
  return largest;
}

}  // namespace kaori::tests
