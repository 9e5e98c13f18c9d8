// SPDX-License-Identifier: GPL-3.0-or-later
//
// Round trips of the particle file: what is read is what was written, bit by bit.
#include "particles/particle_file.hpp"

#include "sample_scene.hpp"

#include "particles/errors.hpp"

#include <limits>

namespace plenum {
namespace {

template <class Dimension>
class ParticleFile : public testing::Test {};
using Dimensions = testing::Types<std::integral_constant<int, 1>, std::integral_constant<int, 2>,
                                  std::integral_constant<int, 3>>;
TYPED_TEST_SUITE(ParticleFile, Dimensions);

template <int Dim>
void expectRoundTrip(const Scene<Dim>& scene) {
  const TemporaryFolder folder;
  writeParticleFile(folder / "a.hdf", scene);
  EXPECT_EQ(folder.size(), 1u);
  EXPECT_EQ(particleFileDimension(folder / "a.hdf"), Dim);
  const Scene<Dim> read = readParticleFile<Dim>(folder / "a.hdf");
  expectSameBits(scene.particles, read.particles);
  expectSame(scene.info, read.info);
}

TYPED_TEST(ParticleFile, RoundTripInsideTheBox) {
  expectRoundTrip(sampleScene<TypeParam::value>());
}

TYPED_TEST(ParticleFile, RoundTripOfNegativeCoordinates) {
  expectRoundTrip(sampleScene<TypeParam::value>(-1e-3, 1e3));
}

TYPED_TEST(ParticleFile, RoundTripFarFromTheOrigin) {
  expectRoundTrip(sampleScene<TypeParam::value>(-1e9, -1e9 + 1e-3));
}

TYPED_TEST(ParticleFile, RoundTripOfTinyNumbersAndSignedZero) {
  auto scene = sampleScene<TypeParam::value>();
  scene.particles[field::position][0][0] = -std::numeric_limits<double>::denorm_min();
  scene.particles[field::position][1][0] = -0.0;
  scene.particles[field::velocity][2][0] = -0.0;
  expectRoundTrip(scene);
}

TYPED_TEST(ParticleFile, RoundTripOfPeriodicParticlesOutsideTheirBox) {
  auto scene = sampleScene<TypeParam::value>(-3, 3);
  scene.info.domain.periodic.fill(true);
  scene.particles[field::position][0][0] = -1 - 1e-17;
  scene.particles[field::position][1][0] = std::nextafter(-1.0, -2.0);
  expectRoundTrip(scene);
}

TYPED_TEST(ParticleFile, RoundTripWithoutWallsOrWithoutFluid) {
  constexpr int dim = TypeParam::value;
  expectRoundTrip(sampleScene<dim>(0, 1, 5, 0));
  expectRoundTrip(sampleScene<dim>(0, 1, 0, 5));
  expectRoundTrip(sampleScene<dim>(0, 1, 1, 0));
}

// Files are written in pieces of 65536 rows; here walls begin within the second.
TYPED_TEST(ParticleFile, RoundTripOfManyPieces) {
  constexpr int dim = TypeParam::value;
  expectRoundTrip(sampleScene<dim>(0, 1, 2 * 65536 - 7, 65536 + 9));
  auto scene = sampleScene<dim>(-1, 1, 65536, 65536);
  scene.particles.remove({FieldId::id, FieldId::velocity, FieldId::smoothingLength});
  expectRoundTrip(scene);
}

TYPED_TEST(ParticleFile, OnlyTheFieldsOfTheSetComeBack) {
  constexpr int dim = TypeParam::value;
  auto scene = sampleScene<dim>();
  scene.particles.remove({FieldId::velocity, FieldId::mass, FieldId::internalEnergy, FieldId::id,
                          FieldId::normal, FieldId::smoothingLength, FieldId::density});
  expectRoundTrip(scene);
}

TYPED_TEST(ParticleFile, ScratchFieldsAreNotWritten) {
  constexpr int dim = TypeParam::value;
  const TemporaryFolder folder;
  auto scene = sampleScene<dim>();
  scene.particles.add({FieldId::force, FieldId::velocityDivergence});
  writeParticleFile(folder / "a.hdf", scene);
  EXPECT_TRUE(readParticleFile<dim>(folder / "a.hdf").particles.fields() == allStateFields());
}

TYPED_TEST(ParticleFile, EmptyTablesAndMap) {
  auto scene = sampleScene<TypeParam::value>();
  scene.particles.remove({FieldId::material, FieldId::wall});
  scene.info = {};
  expectRoundTrip(scene);
}

TEST(ParticleFileDispatch, VisitsWithTheDimensionOfTheFile) {
  const TemporaryFolder folder;
  writeParticleFile(folder / "a.hdf", sampleScene<1>());
  writeParticleFile(folder / "b.hdf", sampleScene<3>());
  const auto dimension = []<int Dim>(const Scene<Dim>&) { return Dim; };
  EXPECT_EQ(withParticleFile(folder / "a.hdf", dimension), 1);
  EXPECT_EQ(withParticleFile(folder / "b.hdf", dimension), 3);
  EXPECT_THROW(readParticleFile<2>(folder / "a.hdf"), InputError);
}

TEST(ParticleFileDispatch, ReplacesAnOlderFile) {
  const TemporaryFolder folder;
  writeParticleFile(folder / "a.hdf", sampleScene<3>());
  writeParticleFile(folder / "a.hdf", sampleScene<2>());
  EXPECT_EQ(particleFileDimension(folder / "a.hdf"), 2);
}

}  // namespace
}  // namespace plenum
