// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/csv_writer.hpp"

#include "particles/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

namespace plenum {
namespace {

std::string textOf(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(CsvWriter, WritesALineForEachParticleWithAllDigits) {
  const test::TemporaryFolder folder;
  ParticleSet<2> particles(
      {FieldId::position, FieldId::density, FieldId::id, FieldId::material, FieldId::normal}, 1, 1);
  particles[field::position][0] = {{0.1 + 0.2, -0.0}};
  particles[field::position][1] = {{1e-300, 1e22}};
  particles[field::density][1] = 1000;
  particles[field::id][0] = 18446744073709551615u;
  particles[field::material][0] = 0;
  particles[field::normal][0] = {{0, 1}};
  writeCsv(folder.path() / "p.csv", particles);
  EXPECT_EQ(textOf(folder.path() / "p.csv"),
            "position_x [m],position_y [m],density [kg/m^2],id,material,normal_x,normal_y,type\n"
            "0.30000000000000004,-0,0,18446744073709551615,0,0,0,0\n"
            "1e-300,1e+22,1000,0,-1,0,1,1\n");
}

TEST(CsvWriter, UnitsAreThoseOfTheDimension) {
  const test::TemporaryFolder folder;
  const auto headerOf = [&](auto particles) {
    writeCsv(folder.path() / "p.csv", particles);
    const std::string text = textOf(folder.path() / "p.csv");
    return text.substr(0, text.find('\n'));
  };
  const FieldSet fields{FieldId::position, FieldId::density, FieldId::pressure};
  EXPECT_EQ(headerOf(ParticleSet<1>(fields, 1, 0)),
            "position_x [m],density [kg/m],pressure [Pa m^2],type");
  EXPECT_EQ(headerOf(ParticleSet<3>(fields, 0, 1)),
            "position_x [m],position_y [m],position_z [m],density [kg/m^3],pressure [Pa],type");
}

TEST(CsvWriter, RefusesAnEmptySet) {
  const test::TemporaryFolder folder;
  EXPECT_THROW(writeCsv(folder.path() / "p.csv", ParticleSet<2>({FieldId::position}, 0, 0)),
               InputError);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "p.csv"));
  EXPECT_THROW(writeCsv(folder.path() / "no" / "p.csv", ParticleSet<2>({FieldId::position}, 1, 0)),
               RunError);
}

}  // namespace
}  // namespace plenum
