// SPDX-License-Identifier: GPL-3.0-or-later
//
// write_samples FOLDER: the same particles as .hdf and .vtu, and the .vtu files as a .pvd series,
// for the checks in Python. Numbers of particles stand for the cases that a reader may stumble
// over: one particle, a block of the compressor that is exactly full, several blocks.
#include "particles/particle_file.hpp"
#include "particles/pvd_writer.hpp"
#include "particles/vtu_writer.hpp"

#include "sample_scene.hpp"

namespace {

template <int Dim>
void writeBoth(const std::filesystem::path& folder, const std::string& name,
               const plenum::Scene<Dim>& scene, plenum::PvdSeries& series) {
  plenum::writeParticleFile(folder / (name + ".hdf"), scene);
  plenum::writeVtu(folder / (name + ".vtu"), scene.particles, {.time = scene.info.time});
  series.add(0.5 * static_cast<double>(series.size()), folder / (name + ".vtu"));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 1;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  plenum::PvdSeries series(folder / "samples.pvd");
  writeBoth(folder, "inside_1d", plenum::sampleScene<1>(), series);
  writeBoth(folder, "inside_2d", plenum::sampleScene<2>(), series);
  writeBoth(folder, "inside_3d", plenum::sampleScene<3>(), series);
  writeBoth(folder, "shifted_1d", plenum::sampleScene<1>(-5e3, 1e4), series);
  writeBoth(folder, "shifted_2d", plenum::sampleScene<2>(-5e3, 1e4), series);
  writeBoth(folder, "shifted_3d", plenum::sampleScene<3>(-5e3, 1e4), series);
  writeBoth(folder, "one_2d", plenum::sampleScene<2>(0, 1, 1, 0), series);
  writeBoth(folder, "full_block_2d", plenum::sampleScene<2>(0, 1, 32000, 768), series);
  writeBoth(folder, "blocks_3d", plenum::sampleScene<3>(-1, 1, 90000, 10001), series);
  auto periodic = plenum::sampleScene<2>(-3, 3);
  periodic.info.domain.periodic.fill(true);
  writeBoth(folder, "periodic_2d", periodic, series);
  auto bare = plenum::sampleScene<2>();
  bare.particles.remove(plenum::allStateFields().without({plenum::FieldId::position}));
  writeBoth(folder, "bare_2d", bare, series);
}
