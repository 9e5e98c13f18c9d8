// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/motion_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>

namespace plenum {

namespace {

constexpr int signalColumns = 5;

void writeColumns(const hdf5::Group& group, const std::string& name,
                  const std::vector<double>& values, int columns, const std::string& unit) {
  group.write(name, std::span<const double>(values), columns);
  group.setText("Unit", unit, name);
}

/// `signalOf(wall)` of every wall, a row each.
template <class SignalOf>
void writeSignals(const hdf5::Group& group, const std::string& name, const std::vector<Wall>& walls,
                  SignalOf&& signalOf) {
  std::vector<double> rows;
  for (const Wall& wall : walls) {
    const Harmonic& h = signalOf(wall);
    rows.insert(rows.end(), {h.frequency, h.phase, h.from, h.until, h.ramp});
  }
  writeColumns(group, name, rows, signalColumns, "1/s, rad, s, s, s");
  group.setText("Description", "frequency, phase, from, until, ramp", name);
}

template <class SignalOf>
void readSignals(const hdf5::Group& group, const std::string& name, std::vector<Wall>& walls,
                 SignalOf&& signalOf) {
  const auto rows = group.read<double>(name, walls.size(), signalColumns);
  for (std::size_t k = 0; k < walls.size(); ++k) {
    const double* row = rows.data() + k * signalColumns;
    signalOf(walls[k]) = Harmonic{row[0], row[1], row[2], row[3], row[4]};
  }
}

constexpr auto oscillationOf = [](auto& wall) -> auto& { return wall.motion.oscillation.harmonic; };
constexpr auto rockingOf = [](auto& wall) -> auto& { return wall.motion.rocking.harmonic; };

void writeTables(const hdf5::Group& group, const std::vector<Wall>& walls) {
  std::vector<std::int32_t> counts;
  std::vector<double> times, places;
  for (const Wall& wall : walls) {
    const MotionTable& table = wall.motion.table;
    counts.push_back(static_cast<std::int32_t>(table.times.size()));
    times.insert(times.end(), table.times.begin(), table.times.end());
    for (const auto& place : table.places) places.insert(places.end(), place.begin(), place.end());
  }
  group.write("TableRows", std::span<const std::int32_t>(counts));
  writeColumns(group, "TableTime", times, 1, "s");
  writeColumns(group, "TablePlace", places, MotionTable::nColumns, "m, m, m, rad");
  group.setText("Description", "x, y, z and angle; the rows of all walls, one wall after the other",
                "TablePlace");
}

void readTables(const hdf5::Group& group, std::vector<Wall>& walls) {
  const auto counts = group.read<std::int32_t>("TableRows", walls.size());
  std::size_t n = 0;
  for (const std::int32_t count : counts) {
    if (count < 0) group.fail("TableRows", fmt::format("has the value {}", count));
    n += static_cast<std::size_t>(count);
  }
  const auto shape = group.shape("TableTime");
  if (shape.size() != 1 || shape[0] != n)  // before anything of that length is allocated
    group.fail("TableTime", fmt::format("is no list of the {} rows that TableRows counts", n));
  const auto times = group.read<double>("TableTime", n);
  const auto places = group.read<double>("TablePlace", n, MotionTable::nColumns);
  std::size_t row = 0;
  for (std::size_t k = 0; k < walls.size(); ++k) {
    MotionTable& table = walls[k].motion.table;
    for (std::int32_t r = 0; r < counts[k]; ++r, ++row) {
      table.times.push_back(times[row]);
      std::copy_n(places.data() + row * MotionTable::nColumns, MotionTable::nColumns,
                  table.places.emplace_back().begin());
    }
  }
}

}  // namespace

void writeMotions(const hdf5::Group& group, const std::vector<Wall>& walls) {
  const auto some = [&](auto&& has) { return std::ranges::any_of(walls, has, &Wall::motion); };
  if (some([](const RigidMotion& m) { return m.axis != RigidMotion{}.axis; })) {
    std::vector<double> axes;
    for (const Wall& wall : walls)
      axes.insert(axes.end(), wall.motion.axis.begin(), wall.motion.axis.end());
    writeColumns(group, "Axis", axes, 3, "");
  }
  if (some([](const RigidMotion& m) { return m.oscillation != Oscillation{}; })) {
    std::vector<double> amplitudes;
    for (const Wall& wall : walls) {
      const auto& amplitude = wall.motion.oscillation.amplitude;
      amplitudes.insert(amplitudes.end(), amplitude.begin(), amplitude.end());
    }
    writeColumns(group, "OscillationAmplitude", amplitudes, 3, "m");
    writeSignals(group, "OscillationSignal", walls, oscillationOf);
  }
  if (some([](const RigidMotion& m) { return m.rocking != Rocking{}; })) {
    std::vector<double> amplitudes;
    for (const Wall& wall : walls) amplitudes.push_back(wall.motion.rocking.amplitude);
    writeColumns(group, "RockingAmplitude", amplitudes, 1, "rad");
    writeSignals(group, "RockingSignal", walls, rockingOf);
  }
  if (some([](const RigidMotion& m) { return !m.table.empty(); })) writeTables(group, walls);
}

void readMotions(const hdf5::Group& group, std::vector<Wall>& walls) {
  const std::size_t n = walls.size();
  if (group.has("Axis")) {
    const auto axes = group.read<double>("Axis", n, 3);
    for (std::size_t k = 0; k < n; ++k)
      std::copy_n(axes.data() + 3 * k, 3, walls[k].motion.axis.begin());
  }
  if (group.has("OscillationAmplitude")) {
    const auto amplitudes = group.read<double>("OscillationAmplitude", n, 3);
    for (std::size_t k = 0; k < n; ++k)
      std::copy_n(amplitudes.data() + 3 * k, 3, walls[k].motion.oscillation.amplitude.begin());
    readSignals(group, "OscillationSignal", walls, oscillationOf);
  }
  if (group.has("RockingAmplitude")) {
    const auto amplitudes = group.read<double>("RockingAmplitude", n);
    for (std::size_t k = 0; k < n; ++k) walls[k].motion.rocking.amplitude = amplitudes[k];
    readSignals(group, "RockingSignal", walls, rockingOf);
  }
  if (group.has("TableRows")) readTables(group, walls);
  for (const Wall& wall : walls)
    if (const auto fault = faultOf(wall.motion))
      group.fail(".", fmt::format("gives wall \"{}\" {}", wall.name, *fault));
}

}  // namespace plenum
