// A smooth curve through numbers that never overshoots them: piecewise cubic Hermite (Fritsch and Carlson
// 1980).
#pragma once

#include <vector>

namespace kaori::sculpt {

class Pchip {
 public:
  // `x` rises; `y` has as many numbers; two at least.
  Pchip(std::vector<double> x, std::vector<double> y);

  // Beyond the ends the outer cubic goes on.
  double At(double x) const;

 private:
  std::vector<double> x_;
  std::vector<double> y_;
  std::vector<double> slope_;
};

}  // namespace kaori::sculpt
