// SPDX-License-Identifier: GPL-3.0-or-later
#include "particles/errors.hpp"

#include <algorithm>
#include <csignal>
#include <iostream>
#include <new>
#include <numeric>
#include <vector>

namespace plenum {

int editDistance(const std::string& a, const std::string& b) {
  std::vector<int> row(b.size() + 1);
  std::iota(row.begin(), row.end(), 0);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    int diagonal = row[0];
    row[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int substituted = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({substituted, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

void ignoreFileSizeSignal() { std::signal(SIGXFSZ, SIG_IGN); }

int reportError(const char* program) {
  const auto say = [program](const std::string& message, int code) {
    std::cout.flush();
    std::cerr << program << ": " << message << std::endl;
    return code;
  };
  try {
    throw;
  } catch (const InputError& error) {
    return say(error.what(), exitInputAtFault);
  } catch (const std::bad_alloc&) {
    return say("out of memory; a larger spacing makes fewer particles", exitFailure);
  } catch (const std::exception& error) {
    return say(error.what(), exitFailure);
  } catch (...) {
    return say("unknown failure", exitFailure);
  }
}

}  // namespace plenum
