// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/files.hpp"
#include "particles/errors.hpp"
#include "tests/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <string>
#include <vector>

namespace plenum::test {

/// A file with this content, until the program ends.
inline std::filesystem::path writeFile(const std::string& name, const std::string& content) {
  static const TemporaryFolder folder;
  std::ofstream(folder.path() / name, std::ios::binary) << content;
  return folder.path() / name;
}

/// `run` throws an InputError whose message has all of `words`.
template <class Run>
void expectError(Run&& run, const std::vector<std::string>& words) {
  try {
    run();
    ADD_FAILURE() << "no error; expected one with '" << words.front() << "'";
  } catch (const InputError& error) {
    const std::string message = error.what();
    for (const std::string& word : words)
      EXPECT_NE(message.find(word), std::string::npos) << "'" << word << "' in: " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << "more than one line: " << message;
  }
}

/// Reading a file of this name and content fails with all of `words`, the name among them.
template <int Dim>
void expectFileError(const std::string& name, const std::string& content,
                     std::vector<std::string> words) {
  const auto path = writeFile(name, content);
  words.push_back(path.string());
  expectError([&] { readGeometryFile<Dim>(path); }, words);
}

}  // namespace plenum::test
