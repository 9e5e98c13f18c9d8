// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/csv_writer.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"
#include "particles/file_rows.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace plenum {

namespace {

/// One or more columns of one field.
struct Columns {
  std::string header;
  std::function<void(std::size_t row, std::string& line)> append;
};

/// The unit in `dim` dimensions: "kg/m^d" is "kg/m^3" in three and "kg/m" in one.
std::string unitIn(std::string_view unit, int dim) {
  if (unit == "Pa m^(3-d)") return dim == 3 ? "Pa" : dim == 2 ? "Pa m" : "Pa m^2";
  std::string text(unit);
  if (const std::size_t power = text.find("^d"); power != std::string::npos)
    text.replace(power, 2, dim == 1 ? "" : fmt::format("^{}", dim));
  return text;
}

template <int Dim, class Value>
Columns columnsOf(const ParticleSet<Dim>& particles, const FieldInfo& info,
                  std::span<const Value> values) {
  constexpr bool isVector = !std::is_arithmetic_v<Value>;
  const std::string unit = info.unit.empty() ? "" : fmt::format(" [{}]", unitIn(info.unit, Dim));
  Columns columns;
  for (int a = 0; a < (isVector ? Dim : 1); ++a)
    columns.header += fmt::format("{}{}{}{}", a > 0 ? "," : "", info.name,
                                  isVector ? std::string{'_', "xyz"[a]} : "", unit);
  // `rows` may refer to the set, which outlives the columns, or own what it holds.
  auto rows = std::make_shared<FileRows<FileNumber<Value>>>(rowsOf(particles, info, values));
  columns.append = [rows](std::size_t k, std::string& line) {
    const auto width = static_cast<std::size_t>(rows->components);
    for (std::size_t a = 0; a < (isVector ? Dim : 1); ++a)
      fmt::format_to(std::back_inserter(line), "{}{}", a > 0 ? "," : "",
                     rows->values[width * k + a]);
  };
  return columns;
}

template <int Dim>
std::vector<Columns> allColumns(const ParticleSet<Dim>& particles) {
  std::vector<Columns> all;
  particles.forEachField([&](const FieldInfo& info, auto values) {
    if (info.isState) all.push_back(columnsOf<Dim>(particles, info, values));
  });
  all.push_back({"type", [nFluid = particles.nFluid()](std::size_t k, std::string& line) {
                   line += k < nFluid ? '0' : '1';
                 }});
  return all;
}

}  // namespace

template <int Dim>
void writeCsv(const std::filesystem::path& path, const ParticleSet<Dim>& particles) {
  if (particles.size() == 0 || !particles.has(FieldId::position))
    throw InputError(path.string() + ": not written: there are no particles");
  const std::vector<Columns> columns = allColumns(particles);
  AtomicFile file(path);
  std::string text;
  for (const Columns& column : columns) text += (text.empty() ? "" : ",") + column.header;
  text += '\n';
  constexpr std::size_t piece = std::size_t{1} << 20;  // bytes that are written at a time
  for (std::size_t k = 0; k < particles.size(); ++k) {
    for (std::size_t c = 0; c < columns.size(); ++c) {
      if (c > 0) text += ',';
      columns[c].append(k, text);
    }
    text += '\n';
    if (text.size() < piece) continue;
    file.write(text);
    text.clear();
  }
  file.write(text);
  file.commit();
}

template void writeCsv(const std::filesystem::path&, const ParticleSet<1>&);
template void writeCsv(const std::filesystem::path&, const ParticleSet<2>&);
template void writeCsv(const std::filesystem::path&, const ParticleSet<3>&);

}  // namespace plenum
