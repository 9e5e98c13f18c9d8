// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/lattice_modes.hpp"

#include "ictools/lattice.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace plenum::study {

namespace {

/// Lattice points in a box, lower ends included, upper ends not.
template <int Dim>
std::vector<Vec<Dim>> pointsIn(const Lattice<Dim>& lattice, const Vec<Dim>& lower,
                               const Vec<Dim>& upper) {
  constexpr double rounding = 1e-9;
  std::vector<Vec<Dim>> points;
  for (const LatticeRow<Dim>& row : lattice.rows({lower, upper, {}}))
    for (std::int64_t i = 0; i < row.count; ++i) {
      const Vec<Dim> point = row.point(i);
      bool isInside = true;
      for (int a = 0; a < Dim; ++a)
        isInside &= point[a] > lower[a] - rounding && point[a] < upper[a] - rounding;
      if (isInside) points.push_back(point);
    }
  return points;
}

template <int Dim>
Lattice<Dim> latticeNamed(const std::string& name) {
  const std::vector<std::string>& known = latticeNames(Dim);
  if (std::ranges::count(known, name) == 0)
    throw InputError(fmt::format("no lattice '{}' in {} dimensions; there are {}", name, Dim,
                                 fmt::join(known, ", ")));
  Lattice<Dim> lattice(name, 1);
  lattice.placeAt({});
  return lattice;
}

/// F and (dF/dr)/r, where grad W = F R. The second one by a difference of F over a
/// hundred-thousandth of h: to some 1e-10 of the kernel where its second derivative is continuous,
/// and the mean of both sides where it jumps, as it does at the end of some kernels.
template <int Dim>
std::pair<double, double> derivatives(KernelId id, double r, double h) {
  const kernel::Any profile{id};
  const double factor = profile.sigma(Dim) * std::pow(h, -(Dim + 2));
  const double step = 1e-5;
  const double R = r / h;
  return {factor * profile.g(R),
          factor * (profile.g(R + step) - profile.g(R - step)) / (2 * step) / (h * r)};
}

/// Neighbours who stand just where a kernel ends, which a lattice has at some smoothing lengths.
bool isAtEnd(double r, double support) { return std::abs(r - support) < 1e-9 * support; }

/// The force itself jumps at the kernel's end: neighbours there have no linear theory.
bool endsWithJump(KernelId id) { return std::abs(kernel::Any{id}.g(2 - 1e-9)) > 1e-6; }

}  // namespace

template <int Dim>
double Mode<Dim>::wavelength() const {
  return 2 * kernel::pi / norm(k);
}

template <int Dim>
struct LatticeModes<Dim>::Matrix {
  Eigen::MatrixXcd D;
};

template <int Dim>
LatticeModes<Dim>::LatticeModes(const LatticeState& state) {
  const Lattice<Dim> lattice = latticeNamed<Dim>(state.lattice);
  edges_ = lattice.edges();
  sites_ = pointsIn<Dim>(lattice, Vec<Dim>{}, edges_);
  mass_ = lattice.cellVolume();
  const double h = state.smoothingLength, support = 2 * h;
  const kernel::Any profile{state.kernel};
  const double factor = mass_ * profile.sigma(Dim) * std::pow(h, -Dim);
  density_ = factor * profile.f(0.0);
  const Vec<Dim> reach = Vec<Dim>::filled(support + 1e-6);
  const std::vector<Vec<Dim>> around = pointsIn<Dim>(lattice, -reach, edges_ + reach);
  for (std::size_t s = 0; s < sites_.size(); ++s)
    for (const Vec<Dim>& point : around) {
      const Vec<Dim> R = sites_[s] - point;
      const double r = norm(R);
      if (r < 1e-6 || (r > support && !isAtEnd(r, support))) continue;
      if (isAtEnd(r, support) && endsWithJump(state.kernel)) continue;
      Vec<Dim> inCell = point;
      for (int a = 0; a < Dim; ++a)
        inCell[a] -= edges_[a] * std::floor(point[a] / edges_[a] + 1e-9);
      const auto site = std::ranges::min_element(
          sites_, {}, [&](const Vec<Dim>& other) { return norm(other - inCell); });
      const auto [F, dF] = derivatives<Dim>(state.kernel, r, h);
      neighbours_.push_back({s, static_cast<std::size_t>(site - sites_.begin()), R, F, dF});
      if (s == 0) density_ += factor * profile.f(r / h);
    }
  pressure_ = state.backgroundPressure + density_ - 1;
}

template <int Dim>
typename LatticeModes<Dim>::Matrix LatticeModes<Dim>::matrixAt(const Vec<Dim>& k) const {
  const auto n = static_cast<Eigen::Index>(sites_.size());
  const double P = pressure_ / (density_ * density_);
  const double dP = 1 / (density_ * density_) - 2 * P / density_;
  Eigen::MatrixXcd A = Eigen::MatrixXcd::Zero(n, n * Dim), B = Eigen::MatrixXcd::Zero(n * Dim, n),
                   H = Eigen::MatrixXcd::Zero(n * Dim, n * Dim);
  for (const Neighbour& j : neighbours_) {
    const std::complex<double> e = std::polar(1.0, -dot(k, j.R));
    const auto s = static_cast<Eigen::Index>(j.s), t = static_cast<Eigen::Index>(j.t);
    for (int a = 0; a < Dim; ++a) {
      const double gradient = j.F * j.R[a];
      A(s, s * Dim + a) += gradient;
      A(s, t * Dim + a) -= gradient * e;
      B(s * Dim + a, s) += gradient;
      B(s * Dim + a, t) += gradient * e;
      for (int b = 0; b < Dim; ++b) {
        const double second = (a == b ? j.F : 0.0) + j.dF * j.R[a] * j.R[b];
        H(s * Dim + a, s * Dim + b) += second;
        H(s * Dim + a, t * Dim + b) -= second * e;
      }
    }
  }
  return {mass_ * mass_ * dP * B * A + 2 * P * mass_ * H};
}

/// The matrix, with shifts of the whole lattice, which at k = 0 are no waves, lifted above all.
template <int Dim>
typename LatticeModes<Dim>::Matrix LatticeModes<Dim>::matrixWithoutShifts(const Vec<Dim>& k) const {
  Matrix matrix = matrixAt(k);
  if (norm(k) > 0) return matrix;
  constexpr double lift = 1e6;  // [c^2/d_ref^2], where the fastest waves have some ten
  const auto nSites = static_cast<Eigen::Index>(sites_.size());
  for (Eigen::Index s = 0; s < nSites; ++s)
    for (Eigen::Index t = 0; t < nSites; ++t)
      for (int a = 0; a < Dim; ++a)
        matrix.D(s * Dim + a, t * Dim + a) += lift / static_cast<double>(nSites);
  return matrix;
}

template <int Dim>
std::vector<double> LatticeModes<Dim>::omegaSquared(const Vec<Dim>& k) const {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(matrixAt(k).D,
                                                               Eigen::EigenvaluesOnly);
  return {solver.eigenvalues().begin(), solver.eigenvalues().end()};
}

namespace {

/// A wave vector, how much of a displacement it carries, and how much of that is along it.
template <int Dim>
struct Carrier {
  Vec<Dim> k{};
  double weight = -1, longitudinal = 0;
};

/// How much of the displacement xi_s exp(i k.r) goes as exp(i K.r) with K = k + G.
template <int Dim>
Carrier<Dim> carriedBy(const Vec<Dim>& K, const Vec<Dim>& k, const Eigen::VectorXcd& xi,
                       const std::vector<Vec<Dim>>& sites) {
  Eigen::Vector<std::complex<double>, Dim> amplitude =
      Eigen::Vector<std::complex<double>, Dim>::Zero();
  for (std::size_t s = 0; s < sites.size(); ++s)
    amplitude += xi.segment<Dim>(static_cast<Eigen::Index>(s) * Dim) *
                 std::polar(1.0, -dot(K - k, sites[s]));
  std::complex<double> along = 0;
  for (int a = 0; a < Dim; ++a) along += amplitude[a] * K[a];
  const double weight = amplitude.squaredNorm(), length = norm(K);
  const bool isWave = weight > 0 && length > 0;
  return {K, weight, isWave ? std::norm(along) / (weight * length * length) : 0};
}

/// The wave that carries most of a displacement. Waves whose vectors differ by a vector of the
/// cell's reciprocal lattice are told apart by how xi goes from site to site; of those that are the
/// same on all sites the longest counts.
template <int Dim>
Carrier<Dim> carrierOf(const Vec<Dim>& k, const Eigen::VectorXcd& xi,
                       const std::vector<Vec<Dim>>& sites, const Vec<Dim>& edges) {
  Carrier<Dim> best;
  const int many = static_cast<int>(sites.size());
  Vec<Dim> g = Vec<Dim>::filled(-many);
  for (;;) {
    Vec<Dim> K = k;
    for (int a = 0; a < Dim; ++a) K[a] += 2 * kernel::pi * g[a] / edges[a];
    const Carrier<Dim> found = carriedBy<Dim>(K, k, xi, sites);
    const bool isSame = found.weight > (1 - 1e-9) * best.weight;
    if (found.weight > (1 + 1e-9) * best.weight || (isSame && norm(K) < norm(best.k) - 1e-9))
      best = found;
    int axis = 0;
    while (axis < Dim && ++g[axis] > many) g[axis++] = -many;
    if (axis == Dim) return best;
  }
}

}  // namespace

template <int Dim>
Mode<Dim> LatticeModes<Dim>::modeAt(const Vec<Dim>& k, std::size_t branch) const {
  return modeOf(matrixAt(k), k, branch);
}

template <int Dim>
Mode<Dim> LatticeModes<Dim>::modeOf(const Matrix& matrix, const Vec<Dim>& k,
                                    std::size_t branch) const {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(matrix.D);
  const Eigen::VectorXcd xi = solver.eigenvectors().col(static_cast<Eigen::Index>(branch));
  const Carrier<Dim> carrier = carrierOf<Dim>(k, xi, sites_, edges_);
  Mode<Dim> mode{solver.eigenvalues()[static_cast<Eigen::Index>(branch)],
                 carrier.k,
                 carrier.longitudinal,
                 {},
                 {}};
  for (std::size_t s = 0; s < sites_.size(); ++s) {
    Vec<Dim> real{}, imaginary{};
    for (int a = 0; a < Dim; ++a) {
      const std::complex<double> value = xi[static_cast<Eigen::Index>(s) * Dim + a];
      real[a] = value.real();
      imaginary[a] = value.imag();
    }
    mode.cosine.push_back(real);
    mode.sine.push_back(imaginary);
  }
  return mode;
}

template <int Dim>
Mode<Dim> LatticeModes<Dim>::lowest(int n) const {
  // All lattices here are their own mirror images along the axes, so an eighth of the zone will do.
  Vec<Dim> best{};
  double least = std::numeric_limits<double>::infinity();
  const auto tryAt = [&](const Vec<Dim>& k) {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXcd> solver(matrixWithoutShifts(k).D,
                                                                 Eigen::EigenvaluesOnly);
    const double value = solver.eigenvalues()[0];
    if (value >= least) return false;
    least = value;
    best = k;
    return true;
  };
  std::array<int, 3> at{};
  for (;;) {
    Vec<Dim> k{};
    for (int a = 0; a < Dim; ++a)
      k[a] = kernel::pi / edges_[a] * at[static_cast<std::size_t>(a)] / n;
    tryAt(k);
    int axis = 0;
    while (axis < Dim && ++at[static_cast<std::size_t>(axis)] > n)
      at[static_cast<std::size_t>(axis++)] = 0;
    if (axis == Dim) break;
  }
  for (double step = 0.5 * kernel::pi / n; step > 1e-4; step /= 2)
    for (bool moved = true; moved;) {
      moved = false;
      for (int a = 0; a < Dim; ++a)
        for (const double side : {-1.0, 1.0}) {
          Vec<Dim> k = best;
          k[a] += side * step / edges_[a];
          // Sound of long waves is nearly at rest, and no wave that is looked for.
          if (norm(k) > 0.5 * kernel::pi / n / norm(edges_)) moved |= tryAt(k);
        }
    }
  return modeOf(matrixWithoutShifts(best), best, 0);
}

template struct Mode<1>;
template struct Mode<2>;
template struct Mode<3>;
template class LatticeModes<1>;
template class LatticeModes<2>;
template class LatticeModes<3>;

}  // namespace plenum::study
