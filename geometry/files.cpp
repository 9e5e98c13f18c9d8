// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/files.hpp"

#include "particles/errors.hpp"

namespace plenum {

template <int Dim>
GeometryPtr<Dim> readGeometryFile(const std::filesystem::path& path, const FileOptions<Dim>&) {
  throw InputError(path.string() + ": files are not read yet");
}

template GeometryPtr<2> readGeometryFile<2>(const std::filesystem::path&, const FileOptions<2>&);
template GeometryPtr<3> readGeometryFile<3>(const std::filesystem::path&, const FileOptions<3>&);

}  // namespace plenum
