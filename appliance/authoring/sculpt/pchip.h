// A smooth curve through numbers that never overshoots them: piecewise cubic Hermite (Fritsch and Carlson
// 1980).
#pragma once

#include <vector>

namespace kaori::sculpt {

// Used where a person gives few numbers and a mesh reads many: a curve that overshot would let lines of
// the mesh cross.
class Pchip {
 public:
  // `x` rises strictly; `y` has as many numbers; two at least: asserted. Two points give a straight line.
  Pchip(std::vector<double> x, std::vector<double> y);

  // Through every given point, with a continuous slope, and monotone between two of them. Beyond the ends the
  // outer cubic goes on. O(log n).
  double At(double x) const;

 private:
  // Knots, values, and the slopes that keep the curve monotone.
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> slope_;
};

}  // namespace kaori::sculpt
