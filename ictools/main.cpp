// SPDX-License-Identifier: GPL-3.0-or-later
//
// plenum-ic: from a case file to a particle file.
#include "ictools/check.hpp"
#include "ictools/export_file.hpp"
#include "ictools/generate.hpp"
#include "ictools/ic_settings.hpp"
#include "ictools/make_set.hpp"
#include "ictools/report.hpp"
#include "particles/atomic_file.hpp"
#include "particles/command_line.hpp"
#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "particles/version.hpp"

#include <fmt/format.h>

#include <iostream>

using namespace plenum;

namespace {

constexpr const char* examples = R"(
Examples:
  plenum-ic check cases/rotating_shaft.toml --json findings.json
  plenum-ic generate cases/rotating_shaft.toml
  plenum-ic generate cases/gas_box.toml -o box.hdf --set spacing=0.025 --set fluid[0].seed=2
  plenum-ic relax rotating_shaft.hdf --tolerance 0.01
  plenum-ic preview rotating_shaft.hdf -o shaft.png --color pressure
  plenum-ic info rotating_shaft.hdf
  plenum-ic export rotating_shaft.hdf -o shaft.csv
  plenum-ic report rotating_shaft.hdf --png report.png
  plenum-ic help-case

Exit code: 0 done, 1 the input is at fault, 2 failure.)";

int runCheck(const Options& options) {
  const CheckReport report = checkCase(options.input, options.set, options.quick);
  if (!options.json.empty()) writeTextFile(options.json, toJson(report));
  if (!options.quiet || !report.findings.all().empty()) std::cout << describe(report);
  return report.findings.hasErrors() ? exitInputAtFault : exitOk;
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
    command->add_flag("--quick", options.quick, "with the values of the case's table [quick]");
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
  CLI::App* relax =
      app.add_subcommand("relax", "move particles until they stand evenly, as [relax] of a case");
  relax->add_option("INPUT", options.input, "particle file made here (.hdf) or case (.toml)")
      ->required();
  relax->add_option("-o,--output", options.output,
                    "particle file; absent: INPUT's name + .relaxed.hdf, or .hdf of a case");
  relax->add_option("--method", options.method, "packing, wvt or lloyd; absent: the case's");
  relax->add_option("--tolerance", options.tolerance,
                    "scatter of the kernel sum that must be reached; absent: the case's");
  relax->add_option("--max-iterations", options.maxIterations, "at most; absent: the case's");
  relax->add_flag("--no-report", options.noReport, "leave out the report card beside the file");
  addSet(relax);
  CLI::App* preview = app.add_subcommand("preview", "draw particles as PNG, without ParaView");
  preview->add_option("FILE", options.input, "particle file (.hdf) or case (.toml)")->required();
  preview->add_option("-o,--output", options.output, "picture; absent: FILE's name + .png");
  preview->add_option("--color", options.color,
                      "field that colours the particles, or type: fluids and walls apart");
  CLI::Option* slice =
      preview->add_option("--slice", options.slice, "cut through a 3-D set: y=0.5");
  preview
      ->add_option("--column", options.column,
                   "look through a 3-D set along x, y or z: column density, or the mean of another "
                   "field")
      ->check(CLI::IsMember({"x", "y", "z"}))
      ->excludes(slice);
  preview->add_flag("--smooth", options.smooth,
                    "a 2-D set or a slice smoothed by the particles' kernels instead of disks");
  preview->add_option("--range", options.range, "of the colours: LOWEST HIGHEST")->expected(2);
  preview->add_option("--width", options.width, "of the picture, in pixels")
      ->check(CLI::Range(200, 8000));
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
    if (relax->parsed()) return runRelax(options);
    if (preview->parsed()) return runPreview(options);
    if (exportTo->parsed()) return runExport(options);
    if (info->parsed()) return runInfo(options);
    if (report->parsed()) return runReport(options);
    return runHelpCase(options);
  });
}
