// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/particle_set.hpp"

#include "tests/support/permute.hpp"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

namespace plenum {
namespace {

FieldSet allFields() {
  FieldSet fields;
  for (const FieldInfo& info : fieldTable) fields |= FieldSet{info.id};
  return fields;
}

TEST(FieldTable, IsConsistent) {
  for (std::size_t k = 0; k < nFields; ++k) {
    EXPECT_EQ(static_cast<std::size_t>(fieldTable[k].id), k) << fieldTable[k].name;
    EXPECT_EQ(fieldNamed(fieldTable[k].name), fieldTable[k].id);
    for (std::size_t j = 0; j < k; ++j) {
      EXPECT_NE(fieldTable[j].name, fieldTable[k].name);
      EXPECT_NE(fieldTable[j].fileName, fieldTable[k].fileName);
    }
  }
  EXPECT_EQ(fieldNamed("nonsense"), std::nullopt);
}

TEST(FieldSet, Algebra) {
  constexpr FieldSet a{FieldId::mass, FieldId::density}, b{FieldId::density, FieldId::id};
  static_assert((a | b).has(FieldId::id) && a.without(b) == FieldSet{FieldId::mass});
  static_assert(FieldSet{}.empty() && !a.has(FieldId::pressure));
}

TEST(ParticleSet, ScopeDecidesTheLength) {
  const ParticleSet<2> particles(allFields(), 5, 3);
  EXPECT_EQ(particles[field::position].size(), 8u);
  EXPECT_EQ(particles[field::material].size(), 5u);
  EXPECT_EQ(particles[field::wall].size(), 3u);
  EXPECT_EQ(particles[field::normal].size(), 3u);
  particles.forEachField([&](const FieldInfo& info, auto values) {
    EXPECT_EQ(values.size(), particles.sizeOf(info.id)) << info.name;
  });
}

TEST(ParticleSet, NewFieldsAreZeroAndOldOnesKept) {
  ParticleSet<3> particles({FieldId::mass}, 2, 1);
  particles[field::mass][1] = 7;
  particles.add({FieldId::mass, FieldId::velocity});
  EXPECT_EQ(particles[field::mass][1], 7);
  EXPECT_EQ(particles[field::velocity][2], (Vec<3>{}));
  particles.remove({FieldId::mass});
  EXPECT_FALSE(particles.has(FieldId::mass));
  EXPECT_TRUE(particles.fields() == FieldSet{FieldId::velocity});
}

/// Each value says which particle it belongs to, so any mistake in an offset shows.
TEST(ParticleSet, PermuteMovesEveryFieldOfEveryScope) {
  ParticleSet<2> particles(allFields(), 5, 4);
  particles.forEachField([&](const FieldInfo& info, auto values) {
    using Value = typename decltype(values)::value_type;
    const std::size_t first = info.scope == Scope::walls ? 5 : 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const auto particle = static_cast<double>(first + k);
      if constexpr (std::is_arithmetic_v<Value>)
        values[k] = static_cast<Value>(particle);
      else
        values[k] = {{particle, -particle}};
    }
  });
  const std::vector<std::uint32_t> order{3, 0, 4, 1, 2, 8, 5, 7, 6};
  test::permute(particles, order);
  particles.forEachField([&](const FieldInfo& info, auto values) {
    using Value = typename decltype(values)::value_type;
    const std::size_t first = info.scope == Scope::walls ? 5 : 0;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double particle = order[first + k];
      if constexpr (std::is_arithmetic_v<Value>)
        EXPECT_EQ(values[k], static_cast<Value>(particle)) << info.name;
      else
        EXPECT_EQ(values[k], (Vec<2>{{particle, -particle}})) << info.name;
    }
  });
}

TEST(ParticleSet, PermutingAndBackIsTheIdentity) {
  ParticleSet<1> particles({FieldId::id, FieldId::wall}, 100, 50);
  std::iota(particles[field::id].begin(), particles[field::id].end(), 1u);
  std::vector<std::uint32_t> order(150), inverse(150);
  for (std::uint32_t k = 0; k < 100; ++k) order[k] = 37 * k % 100;
  for (std::uint32_t k = 0; k < 50; ++k) order[100 + k] = 100 + 7 * k % 50;
  for (std::uint32_t k = 0; k < 150; ++k) inverse[order[k]] = k;
  test::permute(particles, order);
  EXPECT_EQ(particles[field::id][1], 38u);
  test::permute(particles, inverse);
  for (std::uint64_t k = 0; k < 150; ++k) EXPECT_EQ(particles[field::id][k], k + 1);
}

/// Of each field the value that says which particle it belonged to.
ParticleSet<2> numbered(std::size_t nFluid, std::size_t nWalls) {
  ParticleSet<2> set({field::id, field::mass, field::position, field::material, field::wall},
                     nFluid, nWalls);
  for (std::size_t i = 0; i < set.size(); ++i) {
    set[field::id][i] = i;
    set[field::mass][i] = static_cast<double>(i);
    set[field::position][i] = {{static_cast<double>(i), 0}};
    if (i < nFluid)
      set[field::material][i] = static_cast<std::int32_t>(i);
    else
      set[field::wall][i - nFluid] = static_cast<std::int32_t>(i);
  }
  return set;
}

void expectFluids(const ParticleSet<2>& set, const std::vector<std::uint64_t>& expected) {
  ASSERT_EQ(set.nFluid(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_EQ(set[field::id][i], expected[i]);
    EXPECT_EQ(set[field::mass][i], static_cast<double>(expected[i]));
    EXPECT_EQ(set[field::position][i][0], static_cast<double>(expected[i]));
    EXPECT_EQ(set[field::material][i], static_cast<std::int32_t>(expected[i]));
  }
}

TEST(ParticleSet, FluidsLeaveAndCopiesJoinBeforeTheWalls) {
  using Indices = std::vector<std::uint32_t>;
  const auto exchanged = [](const Indices& removed, const Indices& copied,
                            const std::vector<std::uint64_t>& expected) {
    ParticleSet<2> set = numbered(6, 2);
    set.exchangeFluids(removed, copied);
    expectFluids(set, expected);
    ASSERT_EQ(set.size(), expected.size() + 2);
    for (std::size_t w = 0; w < 2; ++w) {
      EXPECT_EQ(set[field::id][expected.size() + w], 6 + w);
      EXPECT_EQ(set[field::wall][w], static_cast<std::int32_t>(6 + w));
    }
  };
  exchanged({}, {}, {0, 1, 2, 3, 4, 5});
  exchanged({1, 4}, {}, {0, 2, 3, 5});
  exchanged({}, {5, 0}, {0, 1, 2, 3, 4, 5, 5, 0});
  exchanged({0, 1}, {2, 3, 4}, {2, 3, 4, 5, 2, 3, 4});
  exchanged({2, 3, 5}, {1}, {0, 1, 4, 1});
  exchanged({5}, {5}, {0, 1, 2, 3, 4, 5});
  exchanged({0, 1, 2, 3, 4, 5}, {}, {});
}

TEST(ParticleSet, FluidsOfASetAreCopiedWithoutWalls) {
  const ParticleSet<2> set = numbered(6, 2).fluidsOf(std::vector<std::uint32_t>{4, 1});
  expectFluids(set, {4, 1});
  EXPECT_EQ(set.nWalls(), 0u);
  EXPECT_FALSE(set.has(field::wall));
}

TEST(ParticleSet, BytesPerParticle) {
  EXPECT_EQ(ParticleSet<2>().bytesPerParticle(), 0);
  EXPECT_EQ(ParticleSet<2>({FieldId::position, FieldId::mass}, 10, 0).bytesPerParticle(), 24);
}

}  // namespace
}  // namespace plenum
