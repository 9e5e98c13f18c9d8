// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-ic: from a case file to a particle file.
#include "ictools/check.hpp"
#include "ictools/export_file.hpp"
#include "ictools/generate.hpp"
#include "ictools/ic_settings.hpp"
#include "ictools/report.hpp"
#include "particles/atomic_file.hpp"
#include "particles/command_line.hpp"
#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "particles/picture.hpp"
#include "particles/progress.hpp"
#include "particles/version.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <iostream>
#include <limits>
#include <optional>
#include <type_traits>

using namespace plenum;
namespace fs = std::filesystem;

namespace {

struct Options {
  std::string input;
  std::string output;
  std::string color = "velocity";
  std::vector<std::string> set;
  bool quiet = false;
  bool markdown = false;
  std::string kernel;          // of `report`
  double smoothingLength = 0;  // [d_ref]
  std::string json, png;
  bool noReport = false;
};

/// The report card takes ten times as long as making the particles, and more memory.
constexpr std::size_t mostReported = 2'000'000;

constexpr const char* examples = R"(
Examples:
  plenum-ic check cases/rotating_shaft.toml --json findings.json
  plenum-ic generate cases/rotating_shaft.toml
  plenum-ic generate cases/gas_box.toml -o box.hdf --set spacing=0.025 --set fluid[0].seed=2
  plenum-ic preview rotating_shaft.hdf -o shaft.png --color pressure
  plenum-ic info rotating_shaft.hdf
  plenum-ic export rotating_shaft.hdf -o shaft.csv
  plenum-ic report rotating_shaft.hdf --png report.png
  plenum-ic help-case

Exit code: 0 done, 1 the input is at fault, 2 failure.)";

void warn(const std::string& message) {
  std::cout.flush();
  std::cerr << "plenum-ic: warning: " << message << std::endl;
}

/// Shows how a relaxation goes on.
class RelaxationProgress {
 public:
  explicit RelaxationProgress(bool quiet) : quiet_(quiet) {}

  RelaxationWatch watch() {
    return [this](const RelaxationState& state) { show(state); };
  }

  /// To be called when it is over.
  void end(const RelaxationResult& result) {
    progress_->finish(fmt::format("scatter {:.3f} % at iteration {} of {}: {}",
                                  100 * result.best.scatter, result.best.iteration,
                                  result.history.back().iteration, result.reason));
    failed_ = !result.settled;
  }

  int exitCode() const { return failed_ ? exitInputAtFault : exitOk; }

 private:
  void show(const RelaxationState& state) {
    if (!progress_) progress_.emplace("relaxing", std::numeric_limits<double>::infinity(), quiet_);
    progress_->update(
        0, fmt::format("iteration {}: scatter {:.3f} %, moves {:.4f} d_ref", state.iteration,
                       100 * state.scatter, state.iteration == 0 ? 0 : state.move));
  }

  bool quiet_, failed_ = false;
  std::optional<Progress> progress_;
};

/// Calls visit(std::integral_constant<int, Dim>) for the case's dimension.
template <class Visit>
void withDimension(int dimension, Visit&& visit) {
  if (dimension == 1) visit(std::integral_constant<int, 1>{});
  if (dimension == 2) visit(std::integral_constant<int, 2>{});
  if (dimension == 3) visit(std::integral_constant<int, 3>{});
}

/// Reads the case with the values of --set, makes the scene and calls use(generated).
template <class Use>
void withGenerated(const Options& options, const RelaxationWatch& watch, Use&& use) {
  CaseNode root = CaseNode::load(options.input);
  for (const std::string& assignment : options.set) {
    const auto [key, value] = CaseNode::splitAssignment(assignment);
    root.set(key, value);
  }
  const CaseSettings settings = readCase(root);
  withDimension(settings.dimension, [&](auto dimension) {
    use(plenum::generate<dimension.value>(root, settings, options.input, warn, watch));
  });
}

/// The file to write: as asked, or the input's name with another ending in the current folder.
/// Throws InputError rather than replace the input.
fs::path outputPath(const Options& options, const char* ending) {
  fs::path path = options.output;
  if (path.empty()) path = fs::path(options.input).stem().concat(ending);
  std::error_code none;
  if (fs::equivalent(path, options.input, none))
    throw InputError(path.string() +
                     ": is the input and would be replaced; name another file with "
                     "--output");
  if (path.extension() != ending)
    throw InputError(fmt::format("{}: must end in {}", path.string(), ending));
  return path;
}

/// Beside the particle file.
void writeReport(const fs::path& path, const Report& report) {
  const auto beside = [&](const char* ending) { return fs::path(path).replace_extension(ending); };
  writeTextFile(beside(".report.txt"), printed(report));
  writeTextFile(beside(".report.json"), json(report));
  drawReport(beside(".report.png"), report);
}

int runGenerate(const Options& options) {
  CaseNode::load(options.input);  // says so at once if it is no case
  const fs::path path = outputPath(options, ".hdf");
  RelaxationProgress relaxing(options.quiet);
  withGenerated(options, relaxing.watch(), [&](auto made) {
    auto& scene = made.scene;
    if (made.relaxation) relaxing.end(*made.relaxation);
    if (!options.quiet) std::cout << describe(scene);
    std::optional<Report> report;
    const bool isLarge = scene.particles.size() > mostReported;
    if (isLarge && !options.quiet)
      std::cout << fmt::format("no report card for more than {} particles: plenum-ic report {} "
                               "makes one\n",
                               mostReported, path.string());
    if (!options.noReport && !isLarge) {
      report = reportOn(scene, made.profiles);
      for (const auto& figure : figuresOf(*report)) scene.info.quality.push_back(figure);
      if (!options.quiet) std::cout << printed(*report);
    }
    writeParticleFile(path, scene);
    if (report) writeReport(path, *report);
    if (options.quiet) return;
    std::cout << fmt::format("  {}: {:.2f} MB\nnext: plenum-sph run {}\n", path.string(),
                             static_cast<double>(fs::file_size(path)) / 1e6, path.string());
  });
  return relaxing.exitCode();
}

int runCheck(const Options& options) {
  const CheckReport report = checkCase(options.input, options.set);
  if (!options.json.empty()) writeTextFile(options.json, toJson(report));
  if (!options.quiet || !report.findings.all().empty()) std::cout << describe(report);
  return report.findings.hasErrors() ? exitInputAtFault : exitOk;
}

int runPreview(const Options& options) {
  const fs::path path = outputPath(options, ".png");
  const auto draw = [&](const auto& scene) {
    drawParticles(path, scene.particles, pictureOptions(scene.info, options.color));
    if (!options.quiet) std::cout << path.string() << '\n';
  };
  if (fs::path(options.input).extension() == ".toml")
    withGenerated(options, {}, [&](const auto& made) { draw(made.scene); });
  else
    withParticleFile(options.input, draw);
  return exitOk;
}

/// Judges a file, with another kernel if asked.
int runReport(const Options& options) {
  withParticleFile(options.input, [&](auto scene) {
    if (!options.kernel.empty()) scene.info.kernel = KernelId::named(options.kernel).name();
    if (options.smoothingLength > 0) {
      const double factor =
          options.smoothingLength * scene.info.spacing / scene.info.smoothingLength;
      scene.info.smoothingLength *= factor;
      for (double& h : scene.particles[field::smoothingLength]) h *= factor;
    }
    const Report report = reportOn(scene);
    std::cout << printed(report);
    if (!options.json.empty()) writeTextFile(options.json, json(report));
    if (!options.png.empty()) drawReport(options.png, report);
  });
  return exitOk;
}

int runExport(const Options& options) {
  const std::size_t n = exportFile(options.input, options.output);
  if (!options.quiet) std::cout << fmt::format("{}: {} particles\n", options.output, n);
  return exitOk;
}

int runInfo(const Options& options) {
  withParticleFile(options.input, [&](const auto& scene) {
    std::cout << describe(scene)
              << fmt::format("  made by {} from {}, t = {:g} s\n", scene.info.generator,
                             scene.info.caseName, scene.info.time);
  });
  return exitOk;
}

int runHelpCase(const Options& options) {
  for (const SectionDoc& doc : caseDocs())
    std::cout << (options.markdown ? doc.markdown() : doc.printed() + "\n");
  return exitOk;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app{"plenum-ic: fills geometries with particles"};
  app.footer(examples);
  app.set_version_flag("--version", fmt::format("plenum-ic {}", version));
  const auto addSet = [&](CLI::App* command) {
    command
        ->add_option("--set", options.set, "a value of the case, instead of the file's: key=value")
        ->allow_extra_args(false);
    command->add_flag("-q,--quiet", options.quiet, "print errors and warnings only");
  };

  CLI::App* check = app.add_subcommand("check", "say all that is wrong with a case, and its cost");
  check->add_option("CASE", options.input, "case file (TOML)")->required();
  check->add_option("--json", options.json, "file for the findings, for programs");
  addSet(check);
  CLI::App* generate = app.add_subcommand("generate", "make a particle file from a case");
  generate->add_option("CASE", options.input, "case file (TOML)")->required();
  generate->add_option("-o,--output", options.output, "particle file; absent: CASE's name + .hdf");
  generate->add_flag("--no-report", options.noReport, "leave out the report card beside the file");
  addSet(generate);
  CLI::App* preview = app.add_subcommand("preview", "draw particles as PNG, without ParaView");
  preview->add_option("FILE", options.input, "particle file (.hdf) or case (.toml)")->required();
  preview->add_option("-o,--output", options.output, "picture; absent: FILE's name + .png");
  preview->add_option("--color", options.color, "field that colours the particles");
  addSet(preview);
  CLI::App* info = app.add_subcommand("info", "say what a particle file holds");
  info->add_option("FILE", options.input, "particle file (.hdf)")->required();
  CLI::App* report = app.add_subcommand("report", "judge a particle set: density, spacing, walls");
  report->add_option("FILE", options.input, "particle file (.hdf)")->required();
  report->add_option("--kernel", options.kernel, "judge with this kernel instead of the file's");
  report->add_option("--smoothing-length", options.smoothingLength, "h/d_ref instead of the file's")
      ->check(CLI::Range(0.5, 100.0));
  report->add_option("--json", options.json, "write the figures there");
  report->add_option("--png", options.png, "draw histograms there");
  CLI::App* exportTo = app.add_subcommand("export", "write the particles as .vtu or .csv");
  exportTo->add_option("FILE", options.input, "particle file (.hdf)")->required();
  exportTo->add_option("-o,--output", options.output, "NAME.vtu or NAME.csv")->required();
  exportTo->add_flag("-q,--quiet", options.quiet, "print errors only");
  CLI::App* helpCase = app.add_subcommand("help-case", "all keys of a case file");
  helpCase->add_flag("--markdown", options.markdown, "as tables for the docs");

  return runProgram("plenum-ic", [&] {
    if (const auto code = parseCommandLine(app, argc, argv)) return *code;
    if (check->parsed()) return runCheck(options);
    if (generate->parsed()) return runGenerate(options);
    if (preview->parsed()) return runPreview(options);
    if (exportTo->parsed()) return runExport(options);
    if (info->parsed()) return runInfo(options);
    if (report->parsed()) return runReport(options);
    return runHelpCase(options);
  });
}
