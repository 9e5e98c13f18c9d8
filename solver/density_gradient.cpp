// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/density_gradient.hpp"

#include "particles/number.hpp"

#include <Eigen/Dense>

namespace plenum {

template <int Dim>
Vec<Dim> correctedGradient(const Vec<Dim>& sum, const Vec<Dim>& diagonal, const Vec<Dim>& mixed) {
  Eigen::Matrix<double, Dim, Dim> moments;
  Eigen::Matrix<double, Dim, 1> right;
  for (int a = 0; a < Dim; ++a) {
    right[a] = sum[a];
    moments(a, a) = diagonal[a];
  }
  if constexpr (Dim == 2) moments(0, 1) = moments(1, 0) = mixed[0];
  if constexpr (Dim == 3)
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      moments(b, c) = moments(c, b) = mixed[a];
    }
  // The determinant of moments of this size that were the same in all directions is 1; of those at
  // a corner it is about a half. Less than this is nearly a line or a plane.
  constexpr double least = 1e-2;
  const double size = moments.trace() / Dim;
  Vec<Dim> gradient;
  if (!(size > 0 && moments.determinant() > least * power<Dim>(size))) return gradient;
  const Eigen::Matrix<double, Dim, 1> solved = moments.inverse() * right;
  for (int a = 0; a < Dim; ++a) gradient[a] = solved[a];
  return gradient;
}

template <int Dim>
void updateDensityGradient(Engine<Dim>& engine, const PairPass<Dim>& pass,
                           ParticleSet<Dim>& particles) {
  engine.run(pass, particles);
  const auto integrating = engine.stopwatch().lap(Part::integrate);
  const auto gradient = particles[field::densityGradient];
  engine.forEachSum(
      pass.receivers,
      [&](std::size_t i, const Vec<Dim>& sum, const Vec<Dim>& diagonal, const Vec<Dim>& mixed) {
        gradient[i] = correctedGradient<Dim>(sum, diagonal, mixed);
      },
      field::densityGradient, field::momentDiagonal, field::momentMixed);
}

template Vec<1> correctedGradient(const Vec<1>&, const Vec<1>&, const Vec<1>&);
template Vec<2> correctedGradient(const Vec<2>&, const Vec<2>&, const Vec<2>&);
template Vec<3> correctedGradient(const Vec<3>&, const Vec<3>&, const Vec<3>&);
template void updateDensityGradient(Engine<1>&, const PairPass<1>&, ParticleSet<1>&);
template void updateDensityGradient(Engine<2>&, const PairPass<2>&, ParticleSet<2>&);
template void updateDensityGradient(Engine<3>&, const PairPass<3>&, ParticleSet<3>&);

}  // namespace plenum
