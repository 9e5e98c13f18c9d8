// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-sph: runs the particles of a particle file and writes what ParaView and meshio read.
// Read on in run.cpp (the run), simulation.cpp (the step), engine/pair_loop.hpp (the pairs).
#include "particles/command_line.hpp"
#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "particles/version.hpp"
#include "solver/checkpoints.hpp"
#include "solver/run.hpp"
#include "solver/simulation.hpp"
#include "solver/validation_report.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <csignal>
#include <iostream>

namespace plenum {

namespace {

struct CommandLine {
  std::filesystem::path file;
  std::filesystem::path folder;
  std::vector<std::string> changes;
  int threads = 0;
  bool quiet = false;
  bool anew = false;
  bool strict = false;
};

/// As asked, or as many as have work: a thread that waits for the others costs more than it gives.
/// The result does not depend on it.
int threadsFor(int asked, std::size_t nParticles) {
  constexpr std::size_t particlesPerThread = 4000;
  if (asked > 0) return asked;
  return static_cast<int>(std::min<std::size_t>(static_cast<std::size_t>(omp_get_max_threads()),
                                                1 + nParticles / particlesPerThread));
}

/// Calls body(); an InputError that does not name the particle file gets its name in front.
template <class Body>
int naming(const std::filesystem::path& file, Body&& body) {
  try {
    return body();
  } catch (const InputError& error) {
    const std::string message = error.what();
    const bool named = message.find(file.string()) != std::string::npos;
    throw InputError(named ? message : file.string() + ": " + message);
  }
}

void say(const RunResult& result, const RunOptions& options) {
  std::cout << "last state:\n" << printed(result.figures);
  if (!result.validation.empty())
    std::cout << "what the case says that it must show:\n" << printed(result.validation);
  std::cout << fmt::format(
      "written to {0}: open {1}.pvd in ParaView (paraview {0}/{1}.pvd), "
      "or a .vtu in meshio\n",
      options.folder.string(), options.name);
}

/// What nobody should overlook, --quiet or not.
void warn(const CommandLine& line, const RunResult& result) {
  const auto count = [&](const char* name) {
    const auto found = std::ranges::find(result.figures, name, &Figure::name);
    return found == result.figures.end() ? 0.0 : found->value;
  };
  if (count("left") > 0 || count("escaped") > 0)
    std::cerr << fmt::format(
        "plenum-sph: warning: at the end {:g} particles are outside of the container, in walls or "
        "beyond "
        "(left), and {:g} outside of the set's first bounds (escaped): a hole in the walls, an "
        "open rim, a "
        "time step that is too long, a wall_pressure that lets fluid through (docs/liquids.md, "
        "docs/gas.md); or "
        "the "
        "case names no container and the fluid has flowed out of its regions\n",
        count("left"), count("escaped"));
  const auto isOk = [](const ValidationResult& r) { return r.verdict == Verdict::ok; };
  const auto nOk = std::ranges::count_if(result.validation, isOk);
  if (line.strict && !allOk(result.validation))
    std::cerr << fmt::format(
        "plenum-sph: {} of {} expectations of [[validate]] are not met; see {}\n",
        static_cast<long>(result.validation.size()) - nOk, result.validation.size(),
        "validation.json");
}

/// Begins a run, or goes on with one that stopped.
int run(const CommandLine& line, bool isContinued) {
  return withParticleFile(line.file, [&](auto scene) {
    if (isContinued && scene.info.progress.empty())
      throw InputError("is no checkpoint and no end of a run; begin one with `plenum-sph run`");
    if (!isContinued) scene.info.progress.clear();
    omp_set_num_threads(threadsFor(line.threads, scene.particles.size()));
    RunOptions options;
    options.name = isContinued ? Checkpoints::runNameOf(line.file) : line.file.stem().string();
    options.folder = line.folder;
    if (options.folder.empty())
      options.folder = isContinued ? std::filesystem::absolute(line.file).parent_path()
                                   : std::filesystem::path(options.name + "_run");
    options.quiet = line.quiet;
    options.anew = line.anew;
    const CaseSettings settings = settingsOf(scene.info, line.changes, isContinued);
    const RunResult result = runScene(std::move(scene), settings, options);
    if (result.signal != 0) {
      std::cout << fmt::format("stopped by {}; go on with: plenum-sph resume {}\n",
                               result.signal == SIGINT ? "SIGINT" : "SIGTERM",
                               result.checkpoint.string());
      return static_cast<int>(128 + result.signal);
    }
    if (!line.quiet) say(result, options);
    warn(line, result);
    return static_cast<int>(line.strict && !allOk(result.validation) ? exitFailure : exitOk);
  });
}

int info(const CommandLine& line) {
  return withParticleFile(line.file, [&](auto scene) {
    scene.info.progress.clear();
    const CaseSettings settings = settingsOf(scene.info, line.changes);
    std::cout << fmt::format("{}\nmade by {} from {}, t = {:g} s\n", scene.info.title,
                             scene.info.generator, scene.info.caseName, scene.info.time);
    for (const auto& [name, value] : scene.info.quality)
      std::cout << fmt::format("  {:<32} {:.9g}\n", name, value);
    std::cout << "this run would model:\n"
              << describeModel(Simulation(std::move(scene), settings.solverOrDefaults()));
    return exitOk;
  });
}

void declare(CLI::App& app, CommandLine& line) {
  app.description(
      "plenum-sph runs the particles of a particle file.\n\n"
      "  plenum-sph run shaft.hdf                          as the case says\n"
      "  plenum-sph run shaft.hdf --set solver.kernel=wendland_c2_1d -o out/c2\n"
      "  plenum-sph resume shaft_run                       goes on from the last checkpoint "
      "there,\n"
      "                                                    with the bits of a run without a stop\n"
      "  plenum-sph info shaft.hdf                         what is in it, what would be modelled\n"
      "  plenum-sph help-case                              all keys that --set takes\n\n"
      "Exit code: 0 done, 1 the input is at fault, 2 the run failed (or, with --strict, does not\n"
      "show all that its case says in [[validate]]). SIGINT and SIGTERM (130, 143) let a run write "
      "a\n"
      "checkpoint and end; a second one ends it at once.");
  app.set_version_flag("--version", fmt::format("plenum-sph {}", version));
  const auto addCommon = [&](CLI::App* command, const char* what) {
    command->add_option("file", line.file, what)->required();
    command->add_option("--set", line.changes, "change a key of the case: section.key=value")
        ->allow_extra_args(false);
  };
  constexpr const char* particleFile = "particle file, made by plenum-ic";
  CLI::App* runCommand = app.add_subcommand("run", "run to the end time");
  CLI::App* resumeCommand = app.add_subcommand(
      "resume", "go on with a run that was stopped, or to a later solver.end_time");
  addCommon(runCommand, particleFile);
  addCommon(resumeCommand, "checkpoint, end file, or a folder with checkpoints of one run");
  runCommand->add_option("-o,--output", line.folder, "folder for all output [FILE's name + _run]");
  runCommand->add_flag("--anew", line.anew,
                       "begin again where the folder holds checkpoints of a run without an end");
  resumeCommand->add_option("-o,--output", line.folder, "folder for all output [that of FILE]");
  for (CLI::App* command : {runCommand, resumeCommand}) {
    command
        ->add_option("-j,--threads", line.threads,
                     "threads [one for 4000 particles, at most all cores]")
        ->check(CLI::Range(1, 1024));
    command->add_flag("-q,--quiet", line.quiet, "print errors only");
    command->add_flag("--strict", line.strict,
                      "exit code 2 unless every verdict on [[validate]] is ok");
  }
  addCommon(app.add_subcommand("info", "print what a file holds and what a run would model"),
            particleFile);
  app.add_subcommand("help-case",
                     "print the keys of [solver], [output], [measures] and [[validate]]");
}

int main(int argc, char** argv) {
  CLI::App app;
  CommandLine line;
  declare(app, line);
  if (const auto code = parseCommandLine(app, argc, argv)) return *code;
  if (app.got_subcommand("help-case")) {
    std::cout << solverSection().doc("[solver]").printed()
              << outputSection().doc("[output]").printed()
              << measureSection().doc("[measures]").printed()
              << validateSection().doc("[[validate]]").printed();
    return exitOk;
  }
  const bool isContinued = app.got_subcommand("resume");
  if (isContinued && std::filesystem::is_directory(line.file))
    line.file = Checkpoints::newestIn(line.file);
  return naming(line.file,
                [&] { return app.got_subcommand("info") ? info(line) : run(line, isContinued); });
}

}  // namespace

}  // namespace plenum

int main(int argc, char** argv) {
  return plenum::runProgram("plenum-sph", [&] { return plenum::main(argc, argv); });
}
