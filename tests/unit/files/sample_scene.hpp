// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene with every state field, awkward numbers and all parts of /Plenum, for the file tests.
#pragma once

#include "particles/scene.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <random>
#include <string>

namespace plenum {

using test::TemporaryFolder;

inline FieldSet allStateFields() {
  FieldSet fields;
  for (const FieldInfo& info : fieldTable)
    if (info.isState) fields |= FieldSet{info.id};
  return fields;
}

template <int Dim>
void fillWithNoise(ParticleSet<Dim>& particles, double lower, double upper) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> uniform(lower, upper);
  particles.forEachField([&](const FieldInfo& info, auto values) {
    using Value = typename decltype(values)::value_type;
    std::uint64_t id = info.id == FieldId::id ? particles.size() : 0;
    for (Value& value : values) {
      if constexpr (std::is_same_v<Value, double>)
        value = uniform(random);
      else if constexpr (std::is_same_v<Value, std::int32_t>)
        value = static_cast<std::int32_t>(random() % 2);
      else if constexpr (std::is_same_v<Value, std::uint64_t>)
        value = id--;
      else
        for (double& x : value.components) x = uniform(random);
    }
  });
}

template <int Dim>
SceneInfo<Dim> sampleInfo() {
  SceneInfo<Dim> info;
  info.title = "A sample: <walls> & \"fluids\" in \xc3\xa9t\xc3\xa9";
  info.caseName = "cases/sample.toml";
  info.caseText = "title = \"sample\"\n" + std::string(100000, '#') + "\n";  // more than 64 KiB
  info.generator = "plenum-ic test";
  info.time = 0.1 + 0.2;
  info.startTime = 0.1;
  info.spacing = 1.0 / 3;
  info.kernel = "convex";
  info.smoothingLength = 0.5;
  info.domain.lower = Vec<Dim>::filled(-1);
  info.domain.upper = Vec<Dim>::filled(1);
  info.materials = {{"water", 1000, 12.5, 7, -3.25, 1e-3}, {"air", 1.2}};
  info.progress = {{"step", 12}, {"impulse", 1.0 / 3}};
  info.walls = {{"shaft", "lattice", 3, 1.0, 1, {{0, 0, 0}, {0, 0, 104.7}, {0.1, 0.2, 0.3}}},
                {"housing", "conformal", 4, 4.0 / 3, 2, {}}};
  RigidMotion& motion = info.walls[1].motion;
  motion.axis = {0.6, 0, -0.8};
  motion.oscillation = {{0.1, 1.0 / 3, -0.3}, {1.0 / 7, 0.5, 1, 9, 0.1 + 0.2}};
  motion.rocking = {1.0 / 9, {3}};
  motion.table = {{-1.0 / 3, 0, 1e-9}, {{1.0 / 7, 2, 3, 4}, {-1e-300, 0, 0, 0}, {5, 6, 7, 8}}};
  info.walls[0].motion.table = {{0, 5}, {{1, 0, 0, 0}, {0.1, 0, 0, 0}}};
  info.container.lower = Vec<Dim>::filled(-2);
  info.container.spacing = 0.25;
  info.container.step = 0.01;
  std::size_t cells = 1;
  for (int a = 0; a < Dim; ++a) {
    info.container.shape[static_cast<std::size_t>(a)] = 40 + a;
    cells *= static_cast<std::size_t>(40 + a);
  }
  for (std::size_t k = 0; k < cells; ++k)
    info.container.counts.push_back(static_cast<std::int8_t>(static_cast<int>(k % 255) - 127));
  info.quality = {{"psi6", 0.987654321}, {"bias", -1e-300}, {"nn min", 1.0 / 7}};
  return info;
}

/// `lower`..`upper` is where coordinates and all other numbers lie.
template <int Dim>
Scene<Dim> sampleScene(double lower = 0, double upper = 1, std::size_t nFluid = 37,
                       std::size_t nWalls = 13) {
  Scene<Dim> scene{sampleInfo<Dim>(), ParticleSet<Dim>(allStateFields(), nFluid, nWalls)};
  fillWithNoise(scene.particles, lower, upper);
  return scene;
}

template <int Dim>
void expectSameBits(const ParticleSet<Dim>& a, const ParticleSet<Dim>& b) {
  ASSERT_EQ(a.nFluid(), b.nFluid());
  ASSERT_EQ(a.nWalls(), b.nWalls());
  ASSERT_TRUE(a.fields() == b.fields());
  std::vector<std::string> bytes;
  b.forEachField([&](const FieldInfo&, auto values) {
    bytes.emplace_back(reinterpret_cast<const char*>(values.data()), values.size_bytes());
  });
  std::size_t k = 0;
  a.forEachField([&](const FieldInfo& info, auto values) {
    EXPECT_EQ(std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes()),
              bytes[k++])
        << info.name;
  });
}

template <int Dim>
void expectSame(const SceneInfo<Dim>& a, const SceneInfo<Dim>& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.caseName, b.caseName);
  EXPECT_EQ(a.caseText, b.caseText);
  EXPECT_EQ(a.generator, b.generator);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.startTime, b.startTime);
  EXPECT_EQ(a.progress, b.progress);
  EXPECT_EQ(a.spacing, b.spacing);
  EXPECT_EQ(a.kernel, b.kernel);
  EXPECT_EQ(a.smoothingLength, b.smoothingLength);
  EXPECT_EQ(a.domain.lower, b.domain.lower);
  EXPECT_EQ(a.domain.upper, b.domain.upper);
  EXPECT_EQ(a.domain.periodic, b.domain.periodic);
  ASSERT_EQ(a.materials.size(), b.materials.size());
  for (std::size_t k = 0; k < a.materials.size(); ++k) {
    EXPECT_EQ(a.materials[k].name, b.materials[k].name);
    EXPECT_EQ(a.materials[k].density, b.materials[k].density);
    EXPECT_EQ(a.materials[k].soundSpeed, b.materials[k].soundSpeed);
    EXPECT_EQ(a.materials[k].taitExponent, b.materials[k].taitExponent);
    EXPECT_EQ(a.materials[k].backgroundPressure, b.materials[k].backgroundPressure);
    EXPECT_EQ(a.materials[k].dynamicViscosity, b.materials[k].dynamicViscosity);
    EXPECT_EQ(a.materials[k].cavitationPressure, b.materials[k].cavitationPressure);
  }
  ASSERT_EQ(a.walls.size(), b.walls.size());
  for (std::size_t k = 0; k < a.walls.size(); ++k) {
    EXPECT_EQ(a.walls[k].name, b.walls[k].name);
    EXPECT_EQ(a.walls[k].method, b.walls[k].method);
    EXPECT_EQ(a.walls[k].layers, b.walls[k].layers);
    EXPECT_EQ(a.walls[k].thickness, b.walls[k].thickness);
    EXPECT_EQ(a.walls[k].density, b.walls[k].density);
    EXPECT_TRUE(a.walls[k].motion == b.walls[k].motion) << k;
  }
  EXPECT_EQ(a.container.lower, b.container.lower);
  EXPECT_EQ(a.container.spacing, b.container.spacing);
  EXPECT_EQ(a.container.step, b.container.step);
  EXPECT_EQ(a.container.shape, b.container.shape);
  EXPECT_EQ(a.container.counts, b.container.counts);
  EXPECT_EQ(a.quality, b.quality);
}

}  // namespace plenum
