#include "appliance/authoring/sculpt/delaunay.h"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <utility>

extern "C" {
#include <libqhull_r/qhull_ra.h>
}

namespace kaori::sculpt {
namespace {

// Shares below it come from rounding.
constexpr double kDust = 1e-7;

// The z of a cross product: twice the signed area of a triangle, positive counter-clockwise.
double Cross(glm::dvec2 a, glm::dvec2 b) {
  return a.x * b.y - a.y * b.x;
}

// One run of Qhull. Its memory ends with it.
class Hull {
 public:
  // qh_zero must come first: it makes the struct fit to be freed.
  explicit Hull(std::vector<double> coordinates) : coordinates_(std::move(coordinates)) {
    qh_zero(&hull_, nullptr);
    // d: Delaunay; Qbb, Qz: well scaled also for points on a circle; Qt: triangles only; Pp: no remarks.
    // What it has to say about bad input goes nowhere: the caller says it better.
    char options[] = "qhull d Qbb Qc Qz Qt Pp";
    ok_ = qh_new_qhull(&hull_, 2, static_cast<int>(coordinates_.size() / 2), coordinates_.data(), False,
                       options, nullptr, nowhere_.get()) == 0;
  }
  Hull(const Hull&) = delete;
  Hull& operator=(const Hull&) = delete;
  ~Hull() {
    qh_freeqhull(&hull_, !qh_ALL);
    int left = 0;
    int left_bytes = 0;
    qh_memfreeshort(&hull_, &left, &left_bytes);
  }

  // Facets of the lower hull of the paraboloid are the Delaunay triangles; those of the upper hull
  // are left out.
  std::vector<Corners3> Triangles() {
    std::vector<Corners3> triangles;
    if (!ok_) return triangles;
    qhT* qh = &hull_;  // The name that Qhull's loops expect.
    facetT* facet = nullptr;
    FORALLfacets {
      if (facet->upperdelaunay) continue;
      triangles.push_back(CornersOf(facet));
    }
    return triangles;
  }

 private:
  // Three vertices of a facet, in no order that means a winding.
  Corners3 CornersOf(facetT* facet) {
    Corners3 corners{};
    std::size_t count = 0;
    vertexT* vertex = nullptr;
    vertexT** vertexp = nullptr;
    FOREACHvertex_(facet->vertices) {
      if (count < corners.size())
        corners[count++] = static_cast<std::size_t>(qh_pointid(&hull_, vertex->point));
    }
    return corners;
  }

  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };

  // Before hull_, which writes to it.
  std::unique_ptr<std::FILE, Close> nowhere_{std::fopen("/dev/null", "w")};
  std::vector<double> coordinates_;
  qhT hull_{};
  bool ok_ = false;
};

}  // namespace

// Fewer than three points span nothing, and Qhull would complain of them.
std::vector<Corners3> Delaunay(const std::vector<glm::dvec2>& points) {
  if (points.size() < 3) return {};
  std::vector<double> coordinates;
  for (const glm::dvec2& p : points) coordinates.insert(coordinates.end(), {p.x, p.y});
  std::vector<Corners3> triangles = Hull(std::move(coordinates)).Triangles();
  for (Corners3& t : triangles) {
    // Qhull orients its facets in three dimensions; here the plane's sign is made.
    const bool clockwise = Cross(points[t[1]] - points[t[0]], points[t[2]] - points[t[0]]) < 0;
    if (clockwise) std::swap(t[1], t[2]);
  }
  return triangles;
}

// Barycentric coordinates by areas (Cramer's rule).
std::optional<glm::dvec3> SharesIn(glm::dvec2 a, glm::dvec2 b, glm::dvec2 c, glm::dvec2 p) {
  const double area = Cross(b - a, c - a);
  if (area == 0) return std::nullopt;
  const double share_b = Cross(p - a, c - a) / area;
  const double share_c = Cross(b - a, p - a) / area;
  return glm::dvec3(1 - share_b - share_c, share_b, share_c);
}

glm::dvec3 CleanShares(glm::dvec3 shares) {
  for (int i = 0; i < 3; ++i) {
    if (shares[i] < kDust) shares[i] = 0;
  }
  return shares / (shares.x + shares.y + shares.z);
}

}  // namespace kaori::sculpt
