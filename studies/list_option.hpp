// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/command_line.hpp"
#include "studies/lists.hpp"

#include <fmt/ranges.h>

#include <string>
#include <vector>

namespace plenum::study {

/// Values behind one option, with commas between.
template <class Value>
void addList(CLI::App& command, const std::string& name, std::vector<Value>& values,
             const char* help) {
  command
      .add_option_function<std::string>(
          name, [name, &values](const std::string& text) { readList(name, text, values); }, help)
      ->type_name("LIST")
      ->default_str(fmt::format("{}", fmt::join(values, ",")));
}

}  // namespace plenum::study
