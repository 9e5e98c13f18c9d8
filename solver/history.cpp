// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/history.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>

namespace plenum {

History::History(std::filesystem::path path) : path_(std::move(path)), out_(path_) {
  if (!out_) throw RunError(writeFailure(path_, errno));
}

void History::add(const std::vector<Figure>& figures) {
  std::string line;
  if (!hasHeader_) {
    for (const Figure& f : figures)
      line += (line.empty() ? "" : ",") + f.name + (f.unit.empty() ? "" : " [" + f.unit + "]");
    line += '\n';
    hasHeader_ = true;
  }
  std::string row;
  for (std::size_t k = 0; k < figures.size(); ++k)
    row += (k == 0 ? "" : ",") +
           (std::isnan(figures[k].value) ? "" : fmt::format("{:.12g}", figures[k].value));
  errno = 0;
  out_ << line << row << '\n' << std::flush;
  if (!out_) throw RunError(writeFailure(path_, errno != 0 ? errno : EIO));
}

}  // namespace plenum
