// SPDX-License-Identifier: GPL-3.0-or-later
//
// Run-time choices become template arguments. Compiled once for each instruction set and precision:
// PLENUM_ISA and PLENUM_REAL.
#include "ictools/sum_loops.hpp"

#include "engine/instruction_set.hpp"
#include "engine/loop_profile.hpp"
#include "engine/pair_loop.hpp"
#include "ictools/arrangement_terms.hpp"

#include <algorithm>

namespace plenum {

namespace {

/// Builds the pass from the choice and sums it.
template <class Real, int Dim, class Profile, class... Terms>
void sumChosen(const TileWork<Dim, typename Real::Scalar>& work, const void* chosen) {
  const auto& choice = *static_cast<const SumChoice*>(chosen);
  const Pass<Profile, Terms...> pass{
      profileOf<Profile>(choice.smoothing.kernel.index()), choice.smoothing.length, {}};
  TileLoop<Real, Dim, Profile, Terms...>(work, pass).run();
}

/// With the kernel chosen; in double, where speed matters less, at run time.
template <class Real, int Dim, template <class> class Kind, class... Terms>
TileFunction<Dim, typename Real::Scalar> ofKernel(int kernel) {
  TileFunction<Dim, typename Real::Scalar> function = nullptr;
  const auto choose = [&]<class Profile>(Profile) {
    function = &sumChosen<Real, Dim, Kind<Profile>, Terms...>;
  };
  if constexpr (Dim > 1 && std::is_same_v<typename Real::Scalar, float>)
    withProfileAmong<kernel::WendlandC2>(kernel, choose);
  else
    choose(kernel::Any{});
  return function;
}

template <class Profile>
using Fixed = Profile;

}  // namespace

template <class Isa, class T, int Dim>
TileFunction<Dim, T> sumFunction(const SumChoice& choice) {
  using Real = Pack<T, std::min<int>(Isa::bytes / sizeof(T), clusterSize), Isa>;
  using namespace term;
  const int kernel = choice.smoothing.kernel.index();
  const bool adaptive = choice.smoothing.adaptive;
  switch (choice.sum) {
    case NeighbourSum::kernelSum:
      return adaptive ? ofKernel<Real, Dim, Adaptive, KernelSum>(kernel)
                      : ofKernel<Real, Dim, Fixed, KernelSum>(kernel);
    case NeighbourSum::pressure:
      return adaptive ? ofKernel<Real, Dim, Adaptive, OwnKernelPressure>(kernel)
                      : ofKernel<Real, Dim, Fixed, PressureDensityProduct>(kernel);
    case NeighbourSum::voronoi:
      return adaptive ? ofKernel<Real, Dim, Adaptive, VoronoiPush>(kernel) : nullptr;
    case NeighbourSum::quality:
      if constexpr (std::is_same_v<T, double>)
        if (adaptive)
          return ofKernel<Real, Dim, Adaptive, DensitySum, KernelSum, KernelGradientSum>(kernel);
  }
  return nullptr;
}

using Isa = isa::PLENUM_ISA;
template TileFunction<1, PLENUM_REAL> sumFunction<Isa, PLENUM_REAL, 1>(const SumChoice&);
template TileFunction<2, PLENUM_REAL> sumFunction<Isa, PLENUM_REAL, 2>(const SumChoice&);
template TileFunction<3, PLENUM_REAL> sumFunction<Isa, PLENUM_REAL, 3>(const SumChoice&);

}  // namespace plenum
