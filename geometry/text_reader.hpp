// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

namespace plenum {

/// The ending of a file's name in lower case, with its dot: ".step".
std::string extensionOf(const std::filesystem::path& path);

/// The file, open for reading. Throws InputError if it is missing, a folder, empty or not readable,
/// or if the memory does not suffice for what is made of it: `memoryPerByte` times its size.
std::ifstream openFile(const std::filesystem::path& path, double memoryPerByte = 1);

/// All bytes of a file. Throws InputError as `openFile` does.
std::string readWholeFile(const std::filesystem::path& path, double memoryPerByte = 1);

/// Words of a text, with their line for messages.
class TextReader {
 public:
  /// `text` must outlive the reader; `source` begins every message.
  TextReader(std::string_view text, std::string source) : rest_(text), source_(std::move(source)) {}

  /// The next word, "" at the end. Words are parted by blanks; `comment` to the end of the line is
  /// passed over.
  std::string_view word(char comment = '\0');

  /// The rest of the current line, without its end; moves to the next.
  std::string_view restOfLine();

  /// The next word as a finite number, or as a count.
  double number(char comment = '\0');
  std::size_t count(char comment = '\0');

  bool atEnd();
  int line() const { return line_; }
  std::string_view rest() const { return rest_; }

  /// Throws InputError "source:line: message".
  [[noreturn]] void fail(const std::string& message) const;

  /// The word as a finite number; fails if it is none.
  double toNumber(std::string_view word) const;

 private:
  void skipBlanks(char comment);

  std::string_view rest_;
  std::string source_;
  int line_ = 1;
};

}  // namespace plenum
