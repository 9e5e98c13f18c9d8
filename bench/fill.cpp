// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-bench-fill: what it costs to fill regions with lattice points, to read a mesh, and to
// check it. docs/benchmarks.md shows a table.
#include "ictools/fill.hpp"
#include "bench/meshes.hpp"
#include "geometry/box_shape.hpp"
#include "geometry/round_shapes.hpp"
#include "geometry/set_operation.hpp"
#include "geometry/surface_mesh.hpp"

#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <cmath>
#include <string>

namespace plenum::bench {

namespace {

/// User CPU time of this process so far [s].
double userSeconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_utime.tv_sec) +
         1e-6 * static_cast<double>(usage.ru_utime.tv_usec);
}

using Make = GeometryPtr<3> (*)();

GeometryPtr<3> ball() { return makeGeometry(Ball<3>{{}, 1}); }
GeometryPtr<3> box() { return makeGeometry(BoxShape<3>{{{{-1, -1, -1}}, {{1, 1, 1}}, {}}}); }
GeometryPtr<3> boxMinusCylinder() {
  return differenceOf<3>({box(), makeGeometry(Cylinder{{{0, 0, -1.2}}, {{0, 0, 1.2}}, 0.5})});
}

double one(const Vec<3>&) { return 1; }
GeometryPtr<3> mesh(int frequency, const RadiusAlong& radius) {
  return makeSurfaceMesh(starShapedMesh(frequency, radius), "mesh");
}
GeometryPtr<3> coarseSphere() { return mesh(32, one); }
GeometryPtr<3> fineSphere() { return mesh(158, one); }
GeometryPtr<3> roughPart() { return mesh(100, roughRadius); }

/// About `n` lattice points inside what `make` makes, positions only. The geometry is made anew for
/// each fill, outside of the time, so that what it builds when it is first asked counts.
void fill(benchmark::State& state, Make make, const std::string& lattice) {
  const auto n = static_cast<double>(state.range(0));
  std::size_t found = 0;
  double user = 0;
  for (auto _ : state) {
    state.PauseTiming();
    const GeometryPtr<3> region = make();
    const double spacing =
        std::cbrt(region->volume().value / n / Lattice<3>(lattice, 1).cellVolume());
    Lattice<3> points(lattice, spacing);
    points.startAt(region->bounds().lower);
    const double before = userSeconds();
    state.ResumeTiming();
    auto kept =
        latticePoints(points, region->bounds(), *region, {.upper = -surfaceRoundOff * spacing});
    benchmark::DoNotOptimize(kept.data());
    found = kept.size();
    state.PauseTiming();
    user += userSeconds() - before;
    kept = {};
    state.ResumeTiming();
  }
  state.counters["points"] = static_cast<double>(found);
  state.counters["user_s"] = user / static_cast<double>(state.iterations());
}

/// From triangles in memory to a geometry that may be asked: welding and all checks.
void check(benchmark::State& state, RadiusAlong radius) {
  const TriangleSoup soup = starShapedMesh(static_cast<int>(state.range(0)), radius);
  const double before = userSeconds();
  for (auto _ : state) benchmark::DoNotOptimize(makeSurfaceMesh(soup, "mesh"));
  state.counters["triangles"] = static_cast<double>(soup.triangles.size());
  state.counters["user_s"] = (userSeconds() - before) / static_cast<double>(state.iterations());
}

/// The first exact question, which builds the trees, and 10,000 others.
void ask(benchmark::State& state, Make make, std::size_t n) {
  for (auto _ : state) {
    state.PauseTiming();
    const GeometryPtr<3> region = make();
    std::vector<Vec<3>> points(n);
    for (std::size_t k = 0; k < n; ++k) {
      const double s = static_cast<double>(k);
      points[k] =
          (0.9 + 0.2 * std::fmod(s * 0.618, 1)) *
          direction(Vec<3>{{std::sin(s), std::sin(1.7 * s), std::sin(2.3 * s)}}, {{1, 0, 0}});
    }
    std::vector<double> distances(n);
    state.ResumeTiming();
    region->signedDistance(points, distances);
    benchmark::DoNotOptimize(distances.data());
  }
}

void registerAll() {
  const std::pair<const char*, Make> shapes[] = {{"ball", ball},
                                                 {"box", box},
                                                 {"box_minus_cylinder", boxMinusCylinder},
                                                 {"sphere_20480", coarseSphere},
                                                 {"sphere_499280", fineSphere},
                                                 {"rough_200000", roughPart}};
  for (const auto& [name, make] : shapes)
    for (const char* lattice : {"cubic", "hcp"})
      benchmark::RegisterBenchmark(
          (std::string("fill/") + name + "/" + lattice).c_str(),
          [make = make, lattice](benchmark::State& state) { fill(state, make, lattice); })
          ->Arg(1'000'000)
          ->Arg(10'000'000)
          ->Unit(benchmark::kMillisecond)
          ->Iterations(1)
          ->MeasureProcessCPUTime();
  for (const int frequency : {32, 158})
    benchmark::RegisterBenchmark("check/sphere", [](benchmark::State& state) { check(state, one); })
        ->Arg(frequency)
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1);
  benchmark::RegisterBenchmark("check/rough",
                               [](benchmark::State& state) { check(state, roughRadius); })
      ->Arg(100)
      ->Unit(benchmark::kMillisecond)
      ->Iterations(1);
  for (const auto& [name, make] : std::span(shapes).subspan(2))
    for (const std::size_t n : {1, 10'000})
      benchmark::RegisterBenchmark(
          (std::string("ask/") + name + "/" + std::to_string(n)).c_str(),
          [make = make, n](benchmark::State& state) { ask(state, make, n); })
          ->Unit(benchmark::kMillisecond)
          ->Iterations(1);
}

}  // namespace

}  // namespace plenum::bench

int main(int argc, char** argv) {
  plenum::bench::registerAll();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 1;
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
