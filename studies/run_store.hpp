// SPDX-License-Identifier: GPL-3.0-or-later
//
// Runs of a study: each a case with settings, made by plenum-ic and run by plenum-sph in processes
// of their own, and kept in a folder, so that no run is made twice.
#pragma once

#include "studies/folder_lock.hpp"
#include "studies/outcome.hpp"
#include "studies/programs.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace plenum::study {

struct RunRequest {
  std::filesystem::path caseFile;
  std::vector<std::string> settings;  ///< "key=value", instead of the case's
  int threads = 1;
  bool quick = false;  ///< with the values of the case's table [quick]
  int repeat = 0;      ///< the same run again, for its time: 1, 2, ...
};

class RunStore {
 public:
  /// Keeps runs in `folder`, in one folder each, named by a key of the case as the settings leave
  /// it, the files that it names, the number of threads and the two programs. Throws InputError if
  /// another study has the folder.
  RunStore(std::filesystem::path folder, Programs programs, bool quiet);

  /// The outcomes, in the order of the requests; runs that are there already are not made again.
  /// `jobs` processes at once: one where times count. Shows progress under `label`. Throws
  /// InputError, before anything runs, if settings do not exist or cannot be combined.
  std::vector<RunOutcome> run(const std::vector<RunRequest>& requests, int jobs,
                              const std::string& label);

  /// One request, `nTimes` times, one after the other.
  std::vector<RunOutcome> repeated(RunRequest request, int nTimes, const std::string& label);

  /// Why plenum-ic would refuse a request's case, the first reason; empty: it would not.
  static std::string refusalOf(const RunRequest& request);
  /// Throws InputError that lists every request whose case it would not.
  static void requireUsable(const std::vector<RunRequest>& requests);

 private:
  std::filesystem::path folderOf(const RunRequest& request) const;
  RunOutcome make(const RunRequest& request, const std::filesystem::path& folder) const;

  FolderLock lock_;
  std::filesystem::path folder_;
  Programs programs_;
  bool quiet_;
};

}  // namespace plenum::study
