// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iostream>
#include <mutex>
#include <sstream>
#include <streambuf>
#include <string>

namespace plenum {

/// Sends std::cout to `buffer` for as long as this lives.
class ConsoleCapture {
 public:
  explicit ConsoleCapture(std::streambuf* buffer) : console_(std::cout.rdbuf(buffer)) {}
  ~ConsoleCapture() { std::cout.rdbuf(console_); }
  ConsoleCapture(const ConsoleCapture&) = delete;
  ConsoleCapture& operator=(const ConsoleCapture&) = delete;

 private:
  std::streambuf* console_;
};

/// gmsh between initialisation and finalisation, silent. It is one global state: sessions of
/// several threads wait for each other.
class GmshSession {
 public:
  GmshSession();
  ~GmshSession();
  GmshSession(const GmshSession&) = delete;
  GmshSession& operator=(const GmshSession&) = delete;

  /// Opens a CAD or mesh file. Lengths of STEP files are converted to metres from the unit that the
  /// file states; .geo, .brep and .msh state none and are taken as they are. Throws InputError that
  /// names the file if it is missing, of another kind, truncated or holds nothing.
  void open(const std::filesystem::path& path);

  /// Runs `work`; what gmsh throws (strings) becomes an InputError that begins with `source`.
  void guarded(const std::string& source, const std::function<void()>& work);

 private:
  std::unique_lock<std::mutex> lock_;
  std::ostringstream printed_;  ///< OpenCASCADE prints to std::cout whatever gmsh is told
  ConsoleCapture capture_{printed_.rdbuf()};
};

}  // namespace plenum
