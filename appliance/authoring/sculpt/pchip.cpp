#include "appliance/authoring/sculpt/pchip.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace kaori::sculpt {
namespace {

// One-sided slope of the parabola through three points, bent back where it would overshoot. h and d are the
// widths and the slopes of the two outermost intervals, the outer one first.
//
// F. N. Fritsch and R. E. Carlson, Monotone Piecewise Cubic Interpolation, SIAM J. Numer. Anal. 17 (1980);
// the end condition is that of PCHIP in SLATEC and MATLAB.
double EndSlope(double h0, double h1, double d0, double d1) {
  const double slope = ((2 * h0 + h1) * d0 - h0 * d1) / (h0 + h1);
  if (slope * d0 <= 0) return 0;
  if (d0 * d1 < 0 && std::abs(slope) > 3 * std::abs(d0)) return 3 * d0;
  return slope;
}

// The weighted harmonic mean of the slopes on either side; flat at an extreme. Brodlie's mean, which Fritsch
// and Butland (1984) showed to be monotone: w0 and w1 weigh by the widths of the two intervals.
double InnerSlope(double h0, double h1, double d0, double d1) {
  if (d0 * d1 <= 0) return 0;
  const double w0 = 2 * h1 + h0;
  const double w1 = h1 + 2 * h0;
  return (w0 + w1) / (w0 / d0 + w1 / d1);
}

}  // namespace

// h is the width of each interval and d the slope across it. With two points both ends get the one slope
// there is.
Pchip::Pchip(std::vector<double> x, std::vector<double> y) : x_(std::move(x)), y_(std::move(y)) {
  const std::size_t n = x_.size();
  assert(n >= 2 && y_.size() == n);
  std::vector<double> h(n - 1);
  std::vector<double> d(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = x_[i + 1] - x_[i];
    d[i] = (y_[i + 1] - y_[i]) / h[i];
  }
  slope_.assign(n, d[0]);
  if (n == 2) return;
  slope_.front() = EndSlope(h[0], h[1], d[0], d[1]);
  slope_.back() = EndSlope(h[n - 2], h[n - 3], d[n - 2], d[n - 3]);
  for (std::size_t i = 1; i + 1 < n; ++i) slope_[i] = InnerSlope(h[i - 1], h[i], d[i - 1], d[i]);
}

double Pchip::At(double x) const {
  // The interval that holds x; the first or the last one beyond the ends.
  const auto after = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  const auto i = static_cast<std::size_t>(after - x_.begin()) - 1;
  const double h = x_[i + 1] - x_[i];
  const double t = (x - x_[i]) / h;
  // The cubic Hermite basis: 3t^2 - 2t^3 for the right value, t(1-t)^2 and t^2(1-t) for the slopes.
  const double rise = t * t * (3 - 2 * t);
  const double from = t * (1 - t) * (1 - t);
  const double to = t * t * (1 - t);
  return y_[i] * (1 - rise) + y_[i + 1] * rise + h * (slope_[i] * from - slope_[i + 1] * to);
}

}  // namespace kaori::sculpt
