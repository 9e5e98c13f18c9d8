// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/neighbour_sums.hpp"

#include "engine/instruction_set.hpp"
#include "ictools/arrangement_terms.hpp"
#include "ictools/sum_loops.hpp"

#include <stdexcept>

namespace plenum {

namespace {

struct Fields {
  FieldSet reads, writes;
};

template <class... Terms>
Fields fieldsOf() {
  return {(FieldSet{} | ... | Terms::reads), (FieldSet{} | ... | Terms::writes)};
}

Fields fieldsOf(NeighbourSum sum) {
  using namespace term;
  switch (sum) {
    case NeighbourSum::kernelSum:
      return fieldsOf<KernelSum>();
    case NeighbourSum::pressure:
      return fieldsOf<PressureDensityProduct>();
    case NeighbourSum::voronoi:
      return fieldsOf<VoronoiPush>();
    case NeighbourSum::quality:
      return fieldsOf<DensitySum, KernelSum, KernelGradientSum>();
  }
  return {};
}

}  // namespace

template <int Dim>
PairPass<Dim> neighbourPass(NeighbourSum sum, const Smoothing& smoothing, const Units& units,
                            Group receivers) {
  SumChoice choice{sum, smoothing};
  choice.smoothing.length /= units.length;
  const Fields fields = fieldsOf(sum);
  PairPass<Dim> pass;
  pass.reads = fields.reads;
  if (smoothing.adaptive) pass.reads |= FieldSet{field::smoothingLength};
  pass.writes = fields.writes;
  pass.receivers = receivers;
  withInstructionSet(instructionSet(), [&](auto isa) {
    pass.inFloat = sumFunction<decltype(isa), float, Dim>(choice);
    pass.inDouble = sumFunction<decltype(isa), double, Dim>(choice);
  });
  if (!pass) throw std::logic_error("no loop for that sum with one smoothing length for all");
  pass.parameters = std::make_shared<const SumChoice>(choice);
  return pass;
}

template PairPass<1> neighbourPass(NeighbourSum, const Smoothing&, const Units&, Group);
template PairPass<2> neighbourPass(NeighbourSum, const Smoothing&, const Units&, Group);
template PairPass<3> neighbourPass(NeighbourSum, const Smoothing&, const Units&, Group);

}  // namespace plenum
