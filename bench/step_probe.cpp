// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench/step_probe.hpp"

#include "bench/clocks.hpp"
#include "bench/process_memory.hpp"
#include "bench/running_state.hpp"
#include "solver/simulation.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

namespace plenum::bench {

namespace {

constexpr int nParts = static_cast<int>(Part::count);

/// Steps of one kind: those that sort and search, or the others.
struct Laps {
  int n = 0;
  Times times;
  std::array<double, nParts> parts{};

  void add(const Times& t, const std::array<double, nParts>& p) {
    ++n;
    times = times + t;
    for (int k = 0; k < nParts; ++k)
      parts[static_cast<std::size_t>(k)] += p[static_cast<std::size_t>(k)];
  }
};

template <int Dim>
class StepProbe {
 public:
  StepProbe(Setup<Dim> setup, bool isRunning, std::size_t bytesBefore)
      : isRunning_(isRunning),
        bytesBefore_(bytesBefore),
        wallsReceive_(setup.settings.wallsEvolve()),
        sim_(std::move(setup.scene), setup.settings) {
    knowsPeak_ = forgetPeakMemory();
  }

  /// The list is made anew before the first step, and the last step is the last one before it is
  /// made anew again: whole cycles. Where this takes too long, their length is foreseen from the
  /// speed of the fastest particle.
  Measurement measure(const Request& request) {
    omp_set_num_threads(request.threads);
    step();
    const Interactions before = countInteractions(sim_.engine(), sim_.particles(), wallsReceive_);
    sim_.engine().forget();
    rebuilding_ = plain_ = {};
    int cycles = 0, stepsOfCycles = 0, steps = 0;
    for (double elapsed = 0;;) {
      const bool isPatient = elapsed < request.mostSeconds || rebuilding_.n + plain_.n < 4;
      if (!isPatient) break;
      const auto partsBefore = parts();
      const Times start = now();
      const bool rebuilt = step();
      const Times spent = now() - start;
      if (rebuilt && steps > 0) {
        ++cycles;
        stepsOfCycles += steps;
        steps = 0;
        if (elapsed >= request.seconds) break;
      }
      std::array<double, nParts> partsSpent = parts();
      for (std::size_t k = 0; k < partsSpent.size(); ++k) partsSpent[k] -= partsBefore[k];
      (rebuilt ? rebuilding_ : plain_).add(spent, partsSpent);
      ++steps;
      elapsed += spent.wall;
    }
    Measurement m =
        perStep(cycles > 0 ? double(stepsOfCycles) / cycles : foreseenCycle(), request.threads);
    const Interactions after = countInteractions(sim_.engine(), sim_.particles(), wallsReceive_);
    m.interactions = {0.5 * (before.all + after.all), 0.5 * (before.ofFluids + after.ofFluids)};
    return m;
  }

 private:
  /// Returns whether it sorted and searched.
  bool step() {
    const auto before = sim_.engine().nRebuilds();
    sim_.step(sim_.maxTimeStep());
    return sim_.engine().nRebuilds() != before;
  }

  std::array<double, nParts> parts() {
    std::array<double, nParts> seconds;
    for (int k = 0; k < nParts; ++k)
      seconds[static_cast<std::size_t>(k)] = sim_.engine().stopwatch().seconds(Part(k));
    return seconds;
  }

  double foreseenCycle() const {
    double fastest = 0;
    for (const Vec<Dim>& v : sim_.particles()[field::velocity].first(sim_.particles().nFluid()))
      fastest = std::max(fastest, norm(v));
    const double usable = 0.5 * typename Engine<Dim>::Options{}.skin * sim_.engine().support();
    return std::max(1.0, std::ceil(usable / (sim_.maxTimeStep() * fastest)));
  }

  Measurement perStep(double cycle, int threads) {
    const auto mean = [&](double rebuilding, double plain) {
      const double a = rebuilding / rebuilding_.n, b = plain_.n > 0 ? plain / plain_.n : 0;
      return (a + (cycle - 1) * b) / cycle;
    };
    Measurement m;
    m.seconds = mean(rebuilding_.times.counted(threads), plain_.times.counted(threads));
    m.wallSeconds = mean(rebuilding_.times.wall, plain_.times.wall);
    m.cpuSeconds = mean(rebuilding_.times.cpu, plain_.times.cpu);
    for (std::size_t k = 0; k < nParts; ++k)
      m.partSeconds[k] = mean(rebuilding_.parts[k], plain_.parts[k]);
    m.stepsPerRebuild = cycle;
    m.nSteps = rebuilding_.n + plain_.n;
    m.nFluid = static_cast<double>(sim_.particles().nFluid());
    m.nWalls = static_cast<double>(sim_.particles().nWalls());
    m.countedBytes = sim_.bytesPerParticle();
    if (knowsPeak_)
      m.processBytes =
          (static_cast<double>(peakMemory()) - static_cast<double>(bytesBefore_)) / m.n();
    m.isRunning = isRunning_;
    return m;
  }

  bool isRunning_;
  std::size_t bytesBefore_;  // that the process had without the scene
  bool wallsReceive_;
  bool knowsPeak_ = false;
  Simulation<Dim> sim_;
  Laps rebuilding_, plain_;
};

template <int Dim>
std::function<Measurement(const Request&)> make(const Case& c, const Choice& choice) {
  const std::size_t bytesBefore = presentMemory();
  omp_set_num_threads(omp_get_num_procs());
  const bool isRunning = isReallyRun(c, choice);
  Setup<Dim> setup = c.isIdealGas()    ? idealGas<Dim>(c.n)
                     : !c.isDamBreak() ? quietGas<Dim>(c.n)
                     : isRunning       ? damBreakRunning<Dim>(c.n, choice.states)
                                       : damBreakMade<Dim>(c.n);
  setup.settings.precision = c.precision;
  const auto probe = std::make_shared<StepProbe<Dim>>(std::move(setup), isRunning, bytesBefore);
  return [probe](const Request& request) { return probe->measure(request); };
}

}  // namespace

std::function<Measurement(const Request&)> stepProbe(const Case& c, const Choice& choice) {
  return c.dimension == 2 ? make<2>(c, choice) : make<3>(c, choice);
}

}  // namespace plenum::bench
