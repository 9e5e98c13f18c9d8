// SPDX-License-Identifier: GPL-3.0-or-later
//
// A rounded determinant where its sign is sure, else an exact sum: Shewchuk (1997), "Adaptive
// precision floating-point arithmetic and fast robust geometric predicates",
// doi 10.1007/PL00009321.
#include "geometry/orientation.hpp"

#include <array>
#include <cmath>
#include <limits>

namespace plenum {

namespace {

/// A sum of doubles without any rounding: parts that do not overlap, the largest last.
class ExactSum {
 public:
  void addProduct(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }

  int sign() const {
    for (std::size_t k = n_; k-- > 0;)
      if (parts_[k] != 0) return parts_[k] > 0 ? 1 : -1;
    return 0;
  }

 private:
  void add(double x) {
    for (std::size_t k = 0; k < n_; ++k) {
      const double sum = x + parts_[k];
      const double part = sum - x;
      parts_[k] = (x - (sum - part)) + (parts_[k] - part);  // what rounding took away
      x = sum;
    }
    parts_[n_++] = x;
  }

  std::array<double, 12> parts_{};
  std::size_t n_ = 0;
};

}  // namespace

int orientation(const Vec<2>& a, const Vec<2>& b, const Vec<2>& q) {
  const double left = (a[0] - q[0]) * (b[1] - q[1]);
  const double right = (a[1] - q[1]) * (b[0] - q[0]);
  const double determinant = left - right;
  constexpr double half = std::numeric_limits<double>::epsilon() / 2;
  const double bound = (3 + 16 * half) * half * (std::abs(left) + std::abs(right));
  if (std::abs(determinant) > bound) return determinant > 0 ? 1 : -1;
  ExactSum sum;
  sum.addProduct(a[0], b[1]);
  sum.addProduct(-a[0], q[1]);
  sum.addProduct(-q[0], b[1]);
  sum.addProduct(-a[1], b[0]);
  sum.addProduct(a[1], q[0]);
  sum.addProduct(q[1], b[0]);
  return sum.sign();
}

}  // namespace plenum
