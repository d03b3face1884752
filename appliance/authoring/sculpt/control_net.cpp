#include "appliance/authoring/sculpt/control_net.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "appliance/authoring/sculpt/delaunay.h"
#include "appliance/authoring/sculpt/point_surface.h"
#include "appliance/authoring/sculpt/texture_map.h"

namespace kaori::sculpt {
namespace {

// Steps of smoothing of the whole matrix. Three halve the roughness of the linear interpolant and cost a brow
// a fifth of its peak; none shows the triangulation in raking light, six flatten the brows.
constexpr int kSmoothSteps = 3;
// More around the lips, whose corners are drawn far on short triangles.
constexpr int kLipSmoothSteps = 6;
// A share below this: the uv lies too far outside the triangle. Edges of lips bow out of the chords
// between control points by less.
constexpr double kOutside = -0.1;
// Smaller ones cost a multiplication in each frame and cannot be seen.
constexpr double kLeastWeight = 1e-4;
// How much of the lip's motion the rings 7 to 10 of the bag feel: the deepest hardly moves.
constexpr std::array<double, kMouthRings - kLipContactRing> kIntoBag{1.0, 0.9, 0.6, 0.35};

// How a control point as written maps to columns of the net: two for a pair, one for both sides in the
// middle; border points have none, so their share of a row is lost and the motion fades out.
struct Column {
  std::optional<Index> left;
  std::optional<Index> right;
};

// Rows by vertex of the cage, columns by control point; dense while it is smoothed (2807 rows of about a
// hundred doubles), sparse in the cast.
class WeightTable {
 public:
  WeightTable(std::size_t rows, std::size_t columns) : columns_(columns), value_(rows * columns) {}

  double* row(std::size_t r) { return value_.data() + r * columns_; }
  const double* row(std::size_t r) const { return value_.data() + r * columns_; }
  std::size_t columns() const { return columns_; }

  // The first `rows` rows, without weights below kLeastWeight.
  face::SparseRows Sparse(std::size_t rows) const {
    face::SparseRows sparse;
    sparse.row_start.push_back(0);
    for (std::size_t r = 0; r < rows; ++r) {
      for (std::size_t c = 0; c < columns_; ++c) {
        if (row(r)[c] < kLeastWeight) continue;
        sparse.column.push_back(static_cast<Index>(c));
        sparse.weight.push_back(static_cast<float>(row(r)[c]));
      }
      sparse.row_start.push_back(static_cast<std::uint32_t>(sparse.column.size()));
    }
    return sparse;
  }

 private:
  std::size_t columns_;
  std::vector<double> value_;
};

// Points of the left half in the file's order, then the border, and the triangulation of both. The right half
// is its mirror image, and is never triangulated by itself.
struct HalfNet {
  std::vector<glm::dvec2> uv_cm;
  std::vector<Column> column;
  std::vector<Key> vertex;  // What the point lies on, where that is the edge of a lid or a lip.
  std::vector<Corners3> triangles;
};

// Fills the points of `net` on the way, which fixes their order.
HalfNet MakeHalfNet(const ExpressionFile& file, face::ControlNet& net) {
  HalfNet half;
  const auto add = [&net](const std::string& name, glm::dvec2 uv_cm) {
    net.points.push_back({name, glm::vec2(UnitFromUv(uv_cm))});
    return static_cast<Index>(net.points.size() - 1);
  };
  for (const AuthoredPoint& point : file.points) {
    half.uv_cm.push_back(point.uv_cm);
    half.vertex.push_back(point.vertex.value_or(Key{}));
    if (point.paired) {
      const Index left = add(point.name + ".l", point.uv_cm);
      half.column.push_back({left, add(point.name + ".r", point.uv_cm * glm::dvec2(-1, 1))});
    } else {
      // Exactly in the middle, though its vertex may lie beside it by a rounding.
      const Index middle = add(point.name, {0, point.uv_cm.y});
      half.column.push_back({middle, middle});
    }
  }
  for (glm::dvec2 uv_cm : file.border_cm) {
    half.uv_cm.push_back(uv_cm);
    half.vertex.push_back({});
    half.column.push_back({});
  }
  half.triangles = Delaunay(half.uv_cm);
  return half;
}

// The vertex whose uv stands for `key`, and how much of its motion is felt there. What lies behind the
// edges has uv inside the holes, where no triangle means anything.
struct Lender {
  Key key;
  double share = 1;
};

// Rings behind the lid's edge follow it wholly; those of the mouth's bag less and less.
Lender LenderOf(const Key& key) {
  if (key.region == Region::kEye && key.b > kLidRing) return {{key.region, key.a, kLidRing}, 1};
  if (key.region == Region::kMouth && key.b > kLipContactRing) {
    return {{key.region, key.a, kLipContactRing},
            kIntoBag[static_cast<std::size_t>(key.b - kLipContactRing - 1)]};
  }
  return {key, 1};
}

// Above (1) or below (-1) the slit of the eye or the mouth; 0 in its corners and elsewhere. Corners belong
// to both sides.
int SideOfSlit(const Key& key) {
  if (key.region == Region::kMouth) return key.a == kMouthCorner ? 0 : key.a < kMouthCorner ? 1 : -1;
  if (key.region != Region::kEye || key.a % (kEyeRim / 2) == 0) return 0;
  return key.a < kEyeRim / 2 ? 1 : -1;
}

// A vertex of the upper lip must not move with a control point of the lower one.
bool AreOpposed(const Key& a, const Key& b) {
  return a.region == b.region && SideOfSlit(a) * SideOfSlit(b) < 0;
}

// All shares 0: no triangle.
struct Found {
  Corners3 corners{};
  glm::dvec3 shares{};
  double inside = kOutside;  // The smallest share: how deep the uv lies in the triangle.
};

// The triangle that holds the uv. Between two points on its edge a lip bows into the slit, where triangles
// reach over to the other lip: those are passed over for the one that the uv misses by least.
Found FindTriangle(const HalfNet& net, glm::dvec2 uv_cm, const Key& key) {
  Found best;
  for (const Corners3& t : net.triangles) {
    const auto opposed = [&](std::size_t corner) { return AreOpposed(net.vertex[corner], key); };
    if (std::any_of(t.begin(), t.end(), opposed)) continue;
    const auto shares = SharesIn(net.uv_cm[t[0]], net.uv_cm[t[1]], net.uv_cm[t[2]], uv_cm);
    if (!shares) continue;
    const double inside = std::min({shares->x, shares->y, shares->z});
    if (inside > best.inside) best = {t, CleanShares(*shares), inside};
  }
  return best;
}

// Writes the shares of the triangle's corners into the columns of the vertex's own side. False where no
// triangle holds the uv.
bool FillRow(const HalfNet& net, glm::dvec2 uv_cm, const CageVertex& vertex, const Lender& lender,
             double* row) {
  const Found found = FindTriangle(net, uv_cm, lender.key);
  if (found.shares == glm::dvec3(0)) return false;
  for (int i = 0; i < 3; ++i) {
    const Column& column = net.column[found.corners[static_cast<std::size_t>(i)]];
    const std::optional<Index>& c = vertex.side > 0 ? column.left : column.right;
    if (c) row[*c] += found.shares[i] * lender.share;
  }
  return true;
}

// The paper's interpolant, before smoothing: W of P = B + W d, as ControlNet writes it.
Result<WeightTable> LinearWeights(const Cage& cage, const HalfShape& reference, const HalfNet& net,
                                  std::size_t points) {
  WeightTable table(cage.vertices.size(), points);
  for (Index v = 0; v < cage.moving_count; ++v) {
    const Lender lender = LenderOf(cage.key(v));
    const glm::dvec2 uv_cm = reference.uv_cm[cage.half.At(lender.key.region, lender.key.a, lender.key.b)];
    if (!FillRow(net, uv_cm, cage.vertices[v], lender, table.row(v))) {
      return FailInput(fmt::format("control points: no triangle of theirs holds the place ({:.2f}, {:.2f})",
                                   uv_cm.x, uv_cm.y));
    }
  }
  return table;
}

// The edges of lips and lids, and what lies behind them, stay as they are: smoothing would mix the two sides
// of a slit.
bool IsSmoothed(const Key& key) {
  return !(key.region == Region::kEye && key.b >= kLidRing) &&
         !(key.region == Region::kMouth && key.b >= kLipContactRing);
}

bool IsAroundLips(const Key& key) {
  return key.region == Region::kMouth && key.b < kLipContactRing;
}

using Choice = bool (*)(const Key& key);

// W <- 0.5 W + 0.5 mean(W of the neighbours), for the chosen rows. Rows beyond the moving vertices are zero
// and stay so: they are read as neighbours.
void SmoothOnce(const Cage& cage, const std::vector<std::vector<Index>>& neighbours, Choice chosen,
                WeightTable& table) {
  const WeightTable before = table;
  for (Index v = 0; v < cage.moving_count; ++v) {
    if (!chosen(cage.key(v))) continue;
    const double each = 0.5 / static_cast<double>(neighbours[v].size());
    double* row = table.row(v);
    for (std::size_t c = 0; c < table.columns(); ++c) {
      double sum = 0;
      for (Index n : neighbours[v]) sum += before.row(n)[c];
      row[c] = 0.5 * before.row(v)[c] + each * sum;
    }
  }
}

}  // namespace

// The linear weights come first and are whole for all points; smoothing then mixes rows of vertices that are
// joined.
Result<face::ControlNet> MakeControlNet(const Cage& cage, const HalfShape& reference,
                                        const ExpressionFile& file) {
  face::ControlNet net;
  const HalfNet half = MakeHalfNet(file, net);
  if (half.triangles.empty()) return FailInput("control points: they do not span the face");
  Result<WeightTable> table = LinearWeights(cage, reference, half, net.points.size());
  if (!table) return tl::unexpected(table.error());
  const std::vector<std::vector<Index>> neighbours = Neighbours(cage);
  for (int step = 0; step < kSmoothSteps; ++step) SmoothOnce(cage, neighbours, IsSmoothed, *table);
  for (int step = 0; step < kLipSmoothSteps; ++step) SmoothOnce(cage, neighbours, IsAroundLips, *table);
  net.to_cage = table->Sparse(cage.moving_count);
  net.surface = PointsOnSurface(cage, reference, file.points);
  return net;
}

}  // namespace kaori::sculpt
