// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "particles/errors.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include <optional>
#include <string>
#include <vector>

namespace plenum {

/// Parses a command line of options. Returns the exit code if help or the version was asked for and
/// printed. Throws InputError, in one line, for anything that is unknown or wrong.
inline std::optional<int> parseOptions(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& done) {
    return app.exit(done);
  } catch (const CLI::ParseError& error) {
    throw InputError(std::string(error.what()) + "; see --help");
  }
  return std::nullopt;
}

/// Parses a command line of one subcommand and its options. Returns the exit code if help or the
/// version was asked for and printed. Throws InputError, in one line, for anything that is unknown
/// or missing.
inline std::optional<int> parseCommandLine(CLI::App& app, int argc, char** argv) {
  app.require_subcommand(0, 1);
  app.allow_extras();  // so that the message below can say what was not understood
  if (const auto done = parseOptions(app, argc, argv)) return done;
  const std::vector<std::string> unknown = app.remaining(true);
  std::vector<std::string> commands;
  for (const CLI::App* command : app.get_subcommands({})) commands.push_back(command->get_name());
  if (app.get_subcommands().empty())
    throw InputError(fmt::format(
        "{}; the commands are {}, see --help",
        unknown.empty() ? "no command given" : "unknown command '" + unknown.front() + "'",
        fmt::join(commands, ", ")));
  if (!unknown.empty())
    throw InputError(fmt::format("{}: unknown argument '{}'; see {} --help",
                                 app.get_subcommands().front()->get_name(), unknown.front(),
                                 app.get_subcommands().front()->get_name()));
  return std::nullopt;
}

}  // namespace plenum
