// SPDX-License-Identifier: GPL-3.0-or-later
#include "studies/mode_growth.hpp"

#include "ictools/generate.hpp"
#include "particles/case_settings.hpp"
#include "particles/errors.hpp"
#include "solver/simulation.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <map>

namespace plenum::study {

namespace {

constexpr double amplitude = 1e-6;  // [d_ref], of the largest displacement some times that
constexpr double timeStep = 0.02;   // [d_ref/c]: (omega dt)^2/24 is below 1e-3 for all waves

template <int Dim>
std::string caseText(const LatticeState& state, const Vec<Dim>& box) {
  const std::array<const char*, 3> axes{"\"x\"", "\"y\"", "\"z\""};
  std::vector<std::string> lower, upper, periodic;
  for (int a = 0; a < Dim; ++a) {
    lower.emplace_back("0.0");
    upper.push_back(fmt::format("{:.17g}", box[a]));
    periodic.emplace_back(axes[static_cast<std::size_t>(a)]);
  }
  const std::string corners =
      fmt::format("lower = [{}]\nupper = [{}]", fmt::join(lower, ", "), fmt::join(upper, ", "));
  return fmt::format(R"(title = "waves of a lattice"
dimension = {}
spacing = 1.0
[domain]
{}
periodic = [{}]
[geometry.all.box]
{}
[[fluid]]
region = "all"
lattice = "{}"
lattice_origin = [{}]
density = 1.0
[solver]
kernel = "{}"
smoothing_length = {}
density = "summation"
sound_speed = 1.0
background_pressure = {}
integrator = "kick_drift_kick"
precision = "double"
time_step = {}
)",
                     Dim, corners, fmt::join(periodic, ", "), corners, state.lattice,
                     fmt::join(lower, ", "), state.kernel.name(), state.smoothingLength,
                     state.backgroundPressure, timeStep);
}

/// A lattice in the solver, and its displacement along one wave.
template <int Dim>
class WaveRun {
 public:
  WaveRun(const LatticeState& state, const LatticeModes<Dim>& modes, const Mode<Dim>& mode,
          const Vec<Dim>& k, const Vec<Dim>& box)
      : box_(box), simulation_(displaced(state, modes, mode, k)) {}

  /// Along the wave, over that of the start.
  double displacement() const {
    const ParticleSet<Dim>& particles = simulation_.particles();
    double along = 0, squares = 0;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      const Place& place = places_.at(particles[field::id][i]);
      Vec<Dim> u = particles[field::position][i] - place.rest;
      for (int a = 0; a < Dim; ++a) u[a] -= box_[a] * std::round(u[a] / box_[a]);
      along += dot(u, place.xi);
      squares += dot(place.xi, place.xi);
    }
    return along / (amplitude * squares);
  }

  double time() const { return simulation_.time(); }
  void step() { simulation_.step(timeStep); }

 private:
  struct Place {
    Vec<Dim> rest, xi;
  };

  Simulation<Dim> displaced(const LatticeState& state, const LatticeModes<Dim>& modes,
                            const Mode<Dim>& mode, const Vec<Dim>& k) {
    const CaseNode root = CaseNode::parse(caseText<Dim>(state, box_), "waves");
    const CaseSettings settings = readCase(root);
    Scene<Dim> scene = generate<Dim>(root, settings, "waves", [](const std::string&) {}).scene;
    ParticleSet<Dim>& particles = scene.particles;
    for (std::size_t i = 0; i < particles.size(); ++i) {
      Vec<Dim>& x = particles[field::position][i];
      Vec<Dim> inCell = x;
      for (int a = 0; a < Dim; ++a)
        inCell[a] -= modes.edges()[a] * std::floor(x[a] / modes.edges()[a] + 1e-6);
      std::size_t site = 0;
      for (std::size_t s = 1; s < modes.sites().size(); ++s)
        if (norm(modes.sites()[s] - inCell) < norm(modes.sites()[site] - inCell)) site = s;
      const double phase = dot(k, x);
      const Vec<Dim> xi = std::cos(phase) * mode.cosine[site] - std::sin(phase) * mode.sine[site];
      places_[particles[field::id][i]] = {x, xi};
      x += amplitude * xi;
      for (int a = 0; a < Dim; ++a) x[a] -= box_[a] * std::floor(x[a] / box_[a]);
    }
    return Simulation<Dim>(std::move(scene), settings.solverOrDefaults());
  }

  Vec<Dim> box_;
  std::map<std::int64_t, Place> places_;
  Simulation<Dim> simulation_;
};

/// omega^2 from the fifth zero of cos(omega t): (4 + 1/2) pi / omega.
template <int Dim>
double measureSwing(WaveRun<Dim>& run, double omega) {
  constexpr int nZeros = 5;
  const double patience = 3 * nZeros * kernel::pi / omega;
  int found = 0;
  double before = run.displacement(), timeBefore = 0;
  while (run.time() < patience) {
    run.step();
    const double now = run.displacement();
    if (before * now < 0 && ++found == nZeros) {
      const double zero = timeBefore + (run.time() - timeBefore) * before / (before - now);
      const double measured = (nZeros - 0.5) * kernel::pi / zero;
      return measured * measured;
    }
    before = now;
    timeBefore = run.time();
  }
  return std::nan("");  // does not swing
}

/// omega^2 = -s^2 from cosh(s t), when it is above some hundred, or from the end of it.
template <int Dim>
double measureGrowth(WaveRun<Dim>& run, double rate) {
  constexpr double enough = 200;  // times the start: 2e-4 d_ref is still linear
  const double patience = 3 * std::acosh(enough) / rate;
  while (run.time() < patience && run.displacement() < enough) run.step();
  const double grown = run.displacement();
  if (grown <= 1) return std::nan("");  // does not grow
  const double measured = std::acosh(grown) / run.time();
  return -measured * measured;
}

template <int Dim>
Vec<Dim> waveVector(const LatticeModes<Dim>& modes, int nCells, const std::array<int, 3>& waves) {
  Vec<Dim> k{};
  for (int a = 0; a < Dim; ++a)
    k[a] = 2 * kernel::pi * waves[static_cast<std::size_t>(a)] / (nCells * modes.edges()[a]);
  return k;
}

}  // namespace

double MeasuredMode::deviation() const {
  return std::sqrt(measured / omegaSquared) - 1;  // not a number where only one of them grows
}

template <int Dim>
MeasuredMode measureMode(const LatticeState& state, int nCells, const std::array<int, 3>& waves,
                         std::size_t branch) {
  const LatticeModes<Dim> modes(state);
  const Vec<Dim> k = waveVector(modes, nCells, waves);
  const Mode<Dim> mode = modes.modeAt(k, branch);
  WaveRun<Dim> run(state, modes, mode, k, static_cast<double>(nCells) * modes.edges());
  const double rate = std::sqrt(std::abs(mode.omegaSquared));
  const double measured =
      mode.omegaSquared > 0 ? measureSwing(run, rate) : measureGrowth(run, rate);
  return {state, waves, branch, mode.omegaSquared, measured, mode.longitudinal};
}

template <int Dim>
std::vector<MeasuredMode> measureExtremes(const LatticeState& state, int nCells) {
  const LatticeModes<Dim> modes(state);
  std::array<int, 3> slowest{}, fastest{};
  double least = 0, most = 0;
  for (int x = 0; x <= nCells / 2; ++x)
    for (int y = 0; y <= nCells / 2; ++y)
      for (int z = 0; z <= (Dim > 2 ? nCells / 2 : 0); ++z) {
        const std::array waves{x, y, z};
        if (x + y + z == 0) continue;
        const std::vector<double> squares = modes.omegaSquared(waveVector(modes, nCells, waves));
        if (squares.front() < least) {
          least = squares.front();
          slowest = waves;
        }
        if (squares.back() > most) {
          most = squares.back();
          fastest = waves;
        }
      }
  std::vector<MeasuredMode> measured;
  // A swing takes 4.5 pi/omega to measure. Rounding, 1e-10 of the displacement, grows to all of it
  // in 23 growth times: what grows faster than the wave swings would drown it.
  if (most > 1e-6 && most > -least)
    measured.push_back(measureMode<Dim>(state, nCells, fastest, modes.nBranches() - 1));
  if (least < -1e-6) measured.push_back(measureMode<Dim>(state, nCells, slowest, 0));
  return measured;
}

std::string tableOf(const std::vector<MeasuredMode>& modes) {
  std::string text =
      fmt::format("{:<20}{:<11}{:>8}{:>6}{:>12}{:>13}{:>13}{:>11}\n", "kernel", "lattice",
                  "h/d_ref", "p0", "waves", "omega^2", "measured", "deviation");
  for (const MeasuredMode& m : modes)
    text += fmt::format("{:<20}{:<11}{:>8g}{:>6g}{:>12}{:>13.5g}{:>13.5g}{:>9.3f} %\n",
                        m.state.kernel.name(), m.state.lattice, m.state.smoothingLength,
                        m.state.backgroundPressure, fmt::format("{}", fmt::join(m.waves, " ")),
                        m.omegaSquared, m.measured, 100 * m.deviation());
  return text;
}

std::string csvOf(const std::vector<MeasuredMode>& modes) {
  std::string text =
      "kernel,lattice,h/d_ref,p0 [rho0 c^2],waves x,waves y,waves z,longitudinal,"
      "omega^2 [c^2/d_ref^2],measured [c^2/d_ref^2],deviation of its root\n";
  for (const MeasuredMode& m : modes)
    text += fmt::format("{},{},{:g},{:g},{},{:.3f},{:.6g},{:.6g},{:.3g}\n", m.state.kernel.name(),
                        m.state.lattice, m.state.smoothingLength, m.state.backgroundPressure,
                        fmt::join(m.waves, ","), m.longitudinal, m.omegaSquared, m.measured,
                        m.deviation());
  return text;
}

template MeasuredMode measureMode<2>(const LatticeState&, int, const std::array<int, 3>&,
                                     std::size_t);
template MeasuredMode measureMode<3>(const LatticeState&, int, const std::array<int, 3>&,
                                     std::size_t);
template std::vector<MeasuredMode> measureExtremes<2>(const LatticeState&, int);
template std::vector<MeasuredMode> measureExtremes<3>(const LatticeState&, int);

}  // namespace plenum::study
