// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/vtu_writer.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"
#include "particles/file_rows.hpp"
#include "particles/vtk_blocks.hpp"

#include <fmt/format.h>

#include <numeric>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace plenum {

namespace {

template <class T>
constexpr std::string_view vtkType();
template <>
constexpr std::string_view vtkType<double>() {
  return "Float64";
}
template <>
constexpr std::string_view vtkType<std::int32_t>() {
  return "Int32";
}
template <>
constexpr std::string_view vtkType<std::int64_t>() {
  return "Int64";
}
template <>
constexpr std::string_view vtkType<std::uint64_t>() {
  return "UInt64";
}
template <>
constexpr std::string_view vtkType<std::uint8_t>() {
  return "UInt8";
}

/// The arrays of the file: elements of the XML part that point into the data behind it.
class Appended {
 public:
  /// The XML element of an array whose values are appended. meshio stumbles over
  /// NumberOfComponents="1", so scalars do not say it.
  template <class T>
  std::string add(std::string_view name, std::span<const T> values, int components = 1) {
    const std::string width =
        components == 1 ? "" : fmt::format(" NumberOfComponents=\"{}\"", components);
    const std::string element =
        fmt::format("<DataArray type=\"{}\" Name=\"{}\"{} format=\"appended\" offset=\"{}\"/>\n",
                    vtkType<T>(), name, width, offset_);
    arrays_.push_back(vtkCompressed(values.data(), values.size_bytes()));
    offset_ += arrays_.back().size();
    return element;
  }

  const std::vector<std::string>& arrays() const { return arrays_; }

 private:
  std::vector<std::string> arrays_;
  std::size_t offset_ = 0;
};

template <int Dim>
FieldSet chosenFields(const std::filesystem::path& path, const ParticleSet<Dim>& particles,
                      const VtuOptions& options) {
  FieldSet fields;
  for (const FieldInfo& info : fieldTable) {
    const bool wanted =
        options.fields ? options.fields->has(info.id) : info.isState && particles.has(info.id);
    if (!wanted) continue;
    if (!particles.has(info.id))
      throw InputError(
          fmt::format("{}: not written: this run does not model the field '{}'; "
                      "leave it out of output.fields",
                      path.string(), info.name));
    fields |= FieldSet{info.id};
  }
  return fields;
}

template <int Dim>
std::string pointData(const ParticleSet<Dim>& particles, FieldSet fields, Appended& appended) {
  std::string xml = "<PointData>\n";
  particles.forEachField([&](const FieldInfo& info, auto values) {
    if (!fields.has(info.id) || info.id == FieldId::position) return;
    const auto rows = rowsOf(particles, info, values);
    xml += appended.add(info.name, rows.values, rows.components);
  });
  const std::vector<std::uint8_t> types = particleTypes(particles);
  xml += appended.add<std::uint8_t>("type", types);
  return xml + "</PointData>\n";
}

std::string cells(std::size_t n, Appended& appended) {
  std::vector<std::int64_t> numbers(n + 1);
  std::iota(numbers.begin(), numbers.end(), std::int64_t{0});
  const std::span<const std::int64_t> all(numbers);
  const std::vector<std::uint8_t> vertices(n, 1);  // VTK_VERTEX
  return "<Cells>\n" + appended.add("connectivity", all.first(n)) +
         appended.add("offsets", all.last(n)) + appended.add<std::uint8_t>("types", vertices) +
         "</Cells>\n";
}

}  // namespace

template <int Dim>
void writeVtu(const std::filesystem::path& path, const ParticleSet<Dim>& particles,
              const VtuOptions& options) {
  const std::size_t n = particles.size();
  if (n == 0 || !particles.has(FieldId::position))
    throw InputError(path.string() + ": not written: there are no particles");
  Appended appended;
  const auto points = rowsOf(particles, infoOf(FieldId::position), particles[field::position]);
  std::string xml =
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\">\n<UnstructuredGrid>\n"
      "<FieldData>\n";
  xml += fmt::format(
      "<DataArray type=\"Float64\" Name=\"TimeValue\" NumberOfTuples=\"1\" format=\"ascii\">\n"
      "{}\n</DataArray>\n</FieldData>\n",
      options.time);
  xml += fmt::format("<Piece NumberOfPoints=\"{0}\" NumberOfCells=\"{0}\">\n", n);
  xml += "<Points>\n" + appended.add("Points", points.values, 3) + "</Points>\n";
  xml += cells(n, appended);
  xml += pointData(particles, chosenFields(path, particles, options), appended);
  xml += "</Piece>\n</UnstructuredGrid>\n<AppendedData encoding=\"raw\">\n_";

  AtomicFile file(path);
  file.write(xml);
  for (const std::string& array : appended.arrays()) file.write(array);
  file.write("\n</AppendedData>\n</VTKFile>\n");
  file.commit();
}

template void writeVtu(const std::filesystem::path&, const ParticleSet<1>&, const VtuOptions&);
template void writeVtu(const std::filesystem::path&, const ParticleSet<2>&, const VtuOptions&);
template void writeVtu(const std::filesystem::path&, const ParticleSet<3>&, const VtuOptions&);

}  // namespace plenum
