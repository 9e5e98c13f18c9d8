// SPDX-License-Identifier: GPL-3.0-or-later
#include "ictools/make_set.hpp"

#include "ictools/generate.hpp"
#include "ictools/relaxation_progress.hpp"
#include "ictools/report.hpp"
#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "particles/picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <limits>
#include <type_traits>

namespace plenum {

namespace fs = std::filesystem;

namespace {

/// The report card takes ten times as long as making the particles, and more memory.
constexpr std::size_t mostReported = 2'000'000;

void warn(const std::string& message) {
  std::cout.flush();
  std::cerr << "plenum-ic: warning: " << message << std::endl;
}

/// Calls visit(std::integral_constant<int, Dim>) for the case's dimension.
template <class Visit>
void withDimension(int dimension, Visit&& visit) {
  if (dimension == 1) visit(std::integral_constant<int, 1>{});
  if (dimension == 2) visit(std::integral_constant<int, 2>{});
  if (dimension == 3) visit(std::integral_constant<int, 3>{});
}

bool isCase(const Options& options) { return fs::path(options.input).extension() != ".hdf"; }

/// Sets the values of --quick and --set.
void apply(const Options& options, CaseNode& root) {
  applyChanges(root, options.quick, options.set);
}

/// Gives the case a [relax] table with what the command line says of it.
void applyRelax(const Options& options, CaseNode& root) {
  if (root.find("relax") == nullptr || !options.method.empty())
    root.set("relax.method", options.method.empty() ? RelaxSettings{}.method : options.method);
  if (options.tolerance) root.set("relax.tolerance", fmt::format("{}", *options.tolerance));
  if (options.maxIterations)
    root.set("relax.max_iterations", fmt::format("{}", *options.maxIterations));
}

/// From "y=0.5".
Slice sliceOf(const std::string& text, int dimension) {
  const std::string asked = "--slice " + text + ": ";
  if (dimension != 3)
    throw InputError(
        fmt::format("{}the set has {} dimensions, only 3-D sets are cut", asked, dimension));
  const auto axis = std::string("xyz").find(text.substr(0, 1));
  double position = 0;
  const char* const end = text.data() + text.size();
  const auto parsed =
      std::from_chars(text.data() + std::min<std::size_t>(2, text.size()), end, position);
  if (text.size() < 3 || text[1] != '=' || axis == std::string::npos || parsed.ec != std::errc() ||
      parsed.ptr != end || !std::isfinite(position))
    throw InputError(asked + "must be an axis and a place in metres, as y=0.5");
  return {static_cast<int>(axis), position, 0};
}

/// A cut beside the set would show nothing, or an image of a periodic set that is not there.
template <int Dim>
void checkSlice(const std::string& text, const Slice& slice, const ParticleSet<Dim>& particles) {
  double lower = std::numeric_limits<double>::infinity(), upper = -lower;
  for (const Vec<Dim>& x : particles[field::position]) {
    lower = std::min(lower, x[slice.axis]);
    upper = std::max(upper, x[slice.axis]);
  }
  if (slice.position < lower || slice.position > upper)
    throw InputError(fmt::format("--slice {}: the set reaches from {:.4g} to {:.4g} m there", text,
                                 lower, upper));
}

/// What --column, --smooth and --range ask of a picture.
template <class PictureOptions>
void takeMap(const Options& options, int dimension, PictureOptions& picture) {
  if (!options.column.empty()) {
    if (dimension != 3)
      throw InputError(
          fmt::format("--column {}: the set has {} dimensions, only 3-D sets have columns",
                      options.column, dimension));
    picture.column = options.column[0] - 'x';
  }
  if (options.smooth && (dimension == 1 || (dimension == 3 && !picture.slice && !picture.column)))
    throw InputError("--smooth: is for 2-D sets and for --slice and --column of 3-D ones");
  picture.smooth = options.smooth;
  if (options.range.empty()) return;
  if (!(options.range[1] > options.range[0]))
    throw InputError(fmt::format("--range {:g} {:g}: the second must be larger", options.range[0],
                                 options.range[1]));
  picture.range = std::pair{options.range[0], options.range[1]};
}

/// The file to write: as asked, or the input's name with another ending in the current folder.
/// Throws InputError rather than replace the input.
fs::path outputPath(const Options& options, const char* ending, const char* suffix = "") {
  fs::path path = options.output;
  if (path.empty()) path = fs::path(options.input).stem().concat(suffix).concat(ending);
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
fs::path beside(const fs::path& path, const char* ending) {
  return fs::path(path).replace_extension(ending);
}

void writeReport(const fs::path& path, const Report& report) {
  writeTextFile(beside(path, ".report.txt"), printed(report));
  writeTextFile(beside(path, ".report.json"), json(report));
  drawReport(beside(path, ".report.png"), report);
}

/// Judges the set if that is asked for and affordable, and keeps the figures in it.
template <int Dim>
std::optional<Report> judged(const Options& options, const fs::path& path, Generated<Dim>& made) {
  if (options.noReport) return std::nullopt;
  if (made.scene.particles.size() > mostReported) {
    if (!options.quiet)
      std::cout << fmt::format(
          "no report card for more than {} particles: plenum-ic report {} "
          "makes one\n",
          mostReported, path.string());
    return std::nullopt;
  }
  Report report = reportOn(made.scene, made.profiles);
  for (const auto& figure : figuresOf(report)) made.scene.info.quality.push_back(figure);
  return report;
}

/// Ends a relaxation; the exit code. Warns of a tolerance that was not reached.
int judgedRelaxation(const RelaxationResult& result, bool mayFail, RelaxationProgress& progress) {
  progress.end(result);
  if (result.settled) return exitOk;
  warn(fmt::format(
      "the tolerance of [relax] is not reached ({}): the state of least scatter, {:.4g}, is "
      "kept{}",
      result.reason, result.best.scatter,
      mayFail ? ""
              : "; raise relax.tolerance or relax.max_iterations, or set "
                "relax.may_fail = true"));
  return mayFail ? exitOk : exitInputAtFault;
}

/// Makes the set of a case, or, with `placesOf`, lets it go on from an earlier one, and writes it
/// with its report card. Returns the exit code.
template <int Dim>
int makeSet(const Options& options, const CaseNode& root, const CaseSettings& settings,
            const fs::path& casePath, const fs::path& path, const Scene<Dim>* placesOf = nullptr) {
  RelaxationProgress progress(options.quiet);
  auto made = generate<Dim>(root, settings, casePath, warn, {progress.watch(), placesOf});
  int exitCode = exitOk;
  if (made.relaxation)
    exitCode = judgedRelaxation(*made.relaxation, readRelax(settings)->mayFail, progress);
  if (!options.quiet) std::cout << describe(made.scene);
  const std::optional<Report> report = judged(options, path, made);
  if (report && !options.quiet) std::cout << printed(*report);
  writeParticleFile(path, made.scene);
  if (report) writeReport(path, *report);
  if (made.relaxation && !options.noReport)
    writeHistory(beside(path, ".relaxation.csv"), *made.relaxation);
  if (!options.quiet)
    std::cout << fmt::format("  {}: {:.2f} MB\nnext: plenum-sph run {}\n", path.string(),
                             static_cast<double>(fs::file_size(path)) / 1e6, path.string());
  return exitCode;
}

int makeSetOfCase(const Options& options, CaseNode root, const fs::path& path) {
  apply(options, root);
  const CaseSettings settings = readCase(root);
  int exitCode = exitOk;
  withDimension(settings.dimension, [&](auto dimension) {
    exitCode = makeSet<dimension.value>(options, root, settings, options.input, path);
  });
  return exitCode;
}

}  // namespace

int runGenerate(const Options& options) {
  CaseNode root = CaseNode::load(options.input);  // says so at once if it is no case
  return makeSetOfCase(options, std::move(root), outputPath(options, ".hdf"));
}

int runRelax(const Options& options) {
  if (isCase(options)) {
    CaseNode root = CaseNode::load(options.input);
    applyRelax(options, root);
    return makeSetOfCase(options, std::move(root), outputPath(options, ".hdf"));
  }
  const fs::path path = outputPath(options, ".hdf", ".relaxed");
  return withParticleFile(options.input, [&]<int Dim>(const Scene<Dim>& scene) {
    CaseNode root = CaseNode::parse(scene.info.caseText, scene.info.caseName);
    applyRelax(options, root);
    apply(options, root);
    const CaseSettings settings = readCase(root);
    if (settings.dimension != Dim)
      throw InputError(fmt::format("{}: has {} dimensions, the case {}", options.input, Dim,
                                   settings.dimension));
    return makeSet<Dim>(options, root, settings, scene.info.caseName, path, &scene);
  });
}

int runPreview(const Options& options) {
  const fs::path path = outputPath(options, ".png");
  const auto draw = [&]<int Dim>(const Scene<Dim>& scene) {
    PictureOptions<Dim> picture = pictureOptions(scene.info, options.color);
    picture.width = options.width;
    if (!options.slice.empty()) {
      picture.slice = sliceOf(options.slice, Dim);
      checkSlice(options.slice, *picture.slice, scene.particles);
    }
    takeMap(options, Dim, picture);
    drawParticles(path, scene.particles, picture);
    if (!options.quiet) std::cout << path.string() << '\n';
  };
  if (fs::path(options.input).extension() != ".toml") {
    withParticleFile(options.input, draw);
    return exitOk;
  }
  CaseNode root = CaseNode::load(options.input);
  apply(options, root);
  const CaseSettings settings = readCase(root);
  withDimension(settings.dimension, [&](auto dimension) {
    draw(generate<dimension.value>(root, settings, options.input, warn).scene);
  });
  return exitOk;
}

}  // namespace plenum
