// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace plenum::study {

/// The two programs that studies run.
struct Programs {
  std::filesystem::path ic, sph;
  std::string fingerprint;  ///< another one for other bytes of either program

  /// Whether either was built anew since it was found.
  bool haveChanged() const;

  /// Beside this program, where they are installed, or where CMake builds them; or in `folder` if
  /// that is not empty. Throws InputError that names where was looked.
  static Programs find(const std::filesystem::path& folder);

 private:
  std::filesystem::file_time_type icTime_, sphTime_;
};

}  // namespace plenum::study
