// SPDX-License-Identifier: GPL-3.0-or-later
//
// The loops that are compiled for each instruction set: every list of terms, some kernels with a
// loop of their own and one of those that share a loop, against a double loop over particles.
#include "engine/derived_fields.hpp"
#include "engine/engine.hpp"
#include "engine/instruction_set.hpp"
#include "solver/pass_choice.hpp"
#include "tests/support/pair_sums.hpp"
#include "tests/support/random_particles.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <memory>
#include <numbers>
#include <random>
#include <string>

namespace plenum {
namespace {

constexpr InstructionSet allSets[] = {InstructionSet::baseline, InstructionSet::avx2,
                                      InstructionSet::avx512};

PassChoice choiceOf(const std::string& kernel, int termList) {
  PassChoice choice;
  choice.kernel = KernelId::named(kernel).index();
  choice.termList = termList;
  choice.smoothingLength = 0.15;
  std::get<term::MonaghanViscosity>(choice.terms) = {{0.8, 1.5, 0.01}, 10};
  std::get<term::MonaghanViscosityOfPhases>(choice.terms) = {{0.8, 1.5, 0.1}};
  std::get<term::HeatingViscosity>(choice.terms) = {{{0.8, 1.5, 0.1}}};
  std::get<term::BalsaraViscosity>(choice.terms) = {{{{0.8, 1.5, 0.1}}}};
  std::get<term::Conductivity>(choice.terms) = {0.7};
  std::get<term::LaminarViscosity>(choice.terms) = {0.3, 3};
  std::get<term::DensityDiffusion>(choice.terms) = {0.1, 10};
  std::get<term::Concentration>(choice.terms) = {20, 3};
  std::get<term::Collision>(choice.terms) = {0.3, 0.08};
  return choice;
}

/// Random values for the fields that a list reads and `randomParticles` does not have.
template <int Dim>
void addMissing(ParticleSet<Dim>& particles, FieldSet fields) {
  const FieldSet had = particles.fields();
  particles.add(fields);
  std::mt19937_64 generator(5);
  std::uniform_real_distribution<double> uniform(0.5, 1.5);
  particles.forEachField([&](const FieldInfo& info, auto values) {
    if (had.has(info.id)) return;
    using Value = typename decltype(values)::value_type;
    for (Value& value : values) {
      if constexpr (std::is_same_v<Value, double>)
        value = (info.id == FieldId::soundSpeed        ? 10
                 : info.id == FieldId::smoothingLength ? 0.1
                                                       : 1) *
                uniform(generator);
      else if constexpr (std::is_same_v<Value, Vec<Dim>>)
        for (int a = 0; a < Dim; ++a) value[a] = uniform(generator) - 1;
    }
  });
  // Neighbours at r -> 0 have the same density, else their diffusion has no bound.
  if (!fields.has(FieldId::densityGradient)) return;
  constexpr double k = 2 * std::numbers::pi;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double x = particles[field::position][i][0];
    particles[field::density][i] = 1 + 0.3 * std::sin(k * x);
    particles[field::densityGradient][i] = {};
    particles[field::densityGradient][i][0] = 0.3 * k * std::cos(k * x);
  }
}

template <int Dim, class List>
double deviationOf(InstructionSet set, Precision precision, const PassChoice& choice, List list) {
  const Box<Dim> box = test::unitBox<Dim>(true);
  auto particles = test::randomParticles<Dim>(box, 250, 60);
  addMissing(particles, storedFor(list.reads));
  typename Engine<Dim>::Options options{2 * choice.smoothingLength, 0.2, true, precision};
  options.adaptive = list.reads.has(field::smoothingLength);
  Engine<Dim> engine(box, options);
  engine.update(particles);
  PairPass<Dim> pass;
  pass.reads = list.reads;
  pass.writes = list.writes;
  pass.receivers = Group::all;
  pass.parameters = std::make_shared<const PassChoice>(choice);
  withInstructionSet(set, [&](auto isa) {
    pass.inFloat = tileFunction<decltype(isa), float, Dim>(choice);
    pass.inDouble = tileFunction<decltype(isa), double, Dim>(choice);
  });
  engine.run(pass, particles);
  const auto compare = [&]<template <class...> class L, class... Terms>(L<Terms...>) {
    using Profile = typename L<Terms...>::template ProfileOf<kernel::Any>;
    const Pass<Profile, Terms...> reference{profileOf<Profile>(choice.kernel),
                                            choice.smoothingLength,
                                            {std::get<Terms>(choice.terms)...}};
    return test::worstDeviation(
        engine, list.writes, particles,
        test::sumOfAllPairs<Dim>(reference, particles, box, Group::all, Group::all), Group::all);
  };
  return compare(list);
}

template <int Dim>
void expectEqualToDoubleLoop() {
  for (const InstructionSet set : allSets) {
    if (!isAvailable(set)) {
      std::cout << "  " << static_cast<int>(set) << ": not on this processor\n";
      continue;
    }
    for (const Precision precision : test::bothPrecisions) {
      if (precision == Precision::mixed && !hasLoops<Dim, float>) continue;
      std::cout << "  " << Dim << "-D, " << nameOf(set) << ", " << test::nameOf(precision)
                << ": largest deviation / typical sum of |terms|, by list:";
      int termList = 0;
      forEachTermList([&](auto list, auto) {
        double worst = 0;
        for (const char* kernel : {"cubic_spline", "wendland_c2", "convex", "quintic_spline"}) {
          const double deviation =
              deviationOf<Dim>(set, precision, choiceOf(kernel, termList), list);
          // The fourth power of W in term::Concentration has four times its error.
          // Diffusion divides a difference of densities, each rounded to float, by the distance
          // where the kernel has a slope at r = 0; in 1-D the closest pairs are very close.
          // The mean of two limiters and its product round twice more than viscosity alone.
          const double factor = list.writes.has(field::positionDivergence) ? 5
                                : list.reads.has(field::densityGradient)   ? 20
                                : list.reads.has(field::viscosityLimiter)  ? 1.5
                                                                           : 1;
          EXPECT_LE(deviation, factor * test::toleranceOf(precision))
              << nameOf(set) << ", " << test::nameOf(precision) << ", list " << termList << ", "
              << kernel;
          worst = std::max(worst, deviation);
        }
        std::cout << " " << worst;
        ++termList;
      });
      std::cout << "\n";
    }
  }
}

TEST(PairLoops, EqualADoubleLoopIn1D) { expectEqualToDoubleLoop<1>(); }
TEST(PairLoops, EqualADoubleLoopIn2D) { expectEqualToDoubleLoop<2>(); }
TEST(PairLoops, EqualADoubleLoopIn3D) { expectEqualToDoubleLoop<3>(); }

TEST(PairLoops, EveryListAndKernelHasALoop) {
  for (const InstructionSet set : allSets)
    withInstructionSet(set, [&](auto isa) {
      using Isa = decltype(isa);
      int termList = 0;
      forEachTermList([&](auto list, auto) {
        EXPECT_EQ(indexOf<decltype(list)>(), termList);
        for (const std::string& kernel : KernelId::names()) {
          const PassChoice choice = choiceOf(kernel, termList);
          EXPECT_EQ((tileFunction<Isa, float, 1>(choice)), nullptr) << "1-D is in double";
          EXPECT_NE((tileFunction<Isa, double, 1>(choice)), nullptr);
          EXPECT_NE((tileFunction<Isa, float, 2>(choice)), nullptr);
          EXPECT_NE((tileFunction<Isa, double, 2>(choice)), nullptr);
          EXPECT_NE((tileFunction<Isa, float, 3>(choice)), nullptr);
          EXPECT_NE((tileFunction<Isa, double, 3>(choice)), nullptr);
        }
        ++termList;
      });
    });
}

}  // namespace
}  // namespace plenum
