// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/recorder.hpp"

#include "particles/atomic_file.hpp"
#include "particles/errors.hpp"
#include "particles/particle_file.hpp"
#include "particles/picture.hpp"
#include "particles/version.hpp"
#include "particles/vtu_writer.hpp"
#include "solver/validation_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cctype>
#include <regex>

namespace plenum {

namespace fs = std::filesystem;

namespace {

/// A field that is named in [output]; it must be one that the run models.
template <int Dim>
FieldId modelledField(const std::string& name, const char* key, const ParticleSet<Dim>& particles) {
  std::vector<std::string> known;
  particles.forEachField([&](const FieldInfo& info, auto) {
    if (info.isState) known.emplace_back(info.name);
  });
  const auto id = fieldNamed(name);
  if (id && particles.has(*id) && infoOf(*id).isState) return *id;
  const std::string near = nearest(name, known);
  throw InputError(fmt::format("{} = \"{}\": {}; modelled here: {}{}", key, name,
                               id ? "this run does not model it" : "no such field",
                               fmt::join(known, ", "),
                               near.empty() ? "" : "; did you mean \"" + near + "\"?"));
}

/// The fields in VTU files.
template <int Dim>
FieldSet outputFields(const OutputSettings& output, const ParticleSet<Dim>& particles) {
  modelledField(output.picture, "output.picture", particles);
  FieldSet fields;
  for (const std::string& name : output.fields)
    fields |= {modelledField(name, "output.fields", particles)};
  if (!output.fields.empty()) return fields;
  particles.forEachField([&](const FieldInfo& info, auto) {
    if (info.isState) fields |= {info.id};
  });
  // Where walls stood at the start is of use to the run only.
  return fields.without({field::referencePosition, field::referenceNormal});
}

}  // namespace

template <int Dim>
Recorder<Dim>::Recorder(const RunOptions& options, const CaseSettings& settings,
                        const Simulation<Dim>& simulation)
    : options_(options),
      settings_(settings),
      fields_(outputFields(settings.outputOrDefaults(), simulation.particles())),
      series_(options.folder / (options.name + ".pvd")),
      earlierSteps_(simulation.nSteps()) {
  std::error_code error;
  fs::create_directories(options_.folder, error);
  if (error)
    throw RunError(fmt::format("{}: cannot be made: {}; choose another folder with --output",
                               options_.folder.string(), error.message()));
  const fs::path history = options_.folder / "history.csv";
  if (simulation.isContinued()) series_.continueUntil(simulation.time());
  removeOldFiles(simulation.isContinued());
  if (!simulation.isContinued()) {
    history_.emplace(history);
    return;
  }
  history_.emplace(history, simulation.time());
  if (!earlierRows().empty()) {
    row_ = earlierRows().back();
    earlierWallClock_ = valueOf(row_, "wall_clock");
  }
}

template <int Dim>
void Recorder<Dim>::removeOldFiles(bool isContinued) const {
  const std::string prefix = options_.name + "_", series = options_.name + ".pvd";
  const std::regex state(R"((\d{4,}\.vtu|end\.hdf|failed\.(hdf|vtu))(\.\d+\.tmp)?)");
  const std::regex vtu(R"(\d{4,}\.vtu)");
  const std::regex checkpoint(R"(checkpoint_\d+\.hdf)");
  std::vector<fs::path> old;
  bool hasCheckpoints = false, hasEnded = false;
  for (const auto& entry : fs::directory_iterator(options_.folder)) {
    const std::string file = entry.path().filename().string();
    if (entry.path().extension() == ".pvd" && file != series)
      throw InputError(fmt::format("{}: holds the run {} already; choose another with --output",
                                   options_.folder.string(), file));
    const std::string rest = file.starts_with(prefix) ? file.substr(prefix.size()) : "";
    const bool isCheckpoint = std::regex_match(rest, checkpoint);
    hasCheckpoints = hasCheckpoints || isCheckpoint;
    hasEnded = hasEnded || rest == "end.hdf" || rest == "failed.hdf";
    if (isContinued && isCheckpoint && std::stol(rest.substr(11)) <= earlierSteps_) continue;
    // What the run may go on from stays until a checkpoint or its end takes its place.
    if (isContinued && rest.ends_with(".hdf") && !isCheckpoint) continue;
    if (isContinued && std::regex_match(rest, vtu)) {
      if (series_.size() == 0)
        throw InputError(fmt::format(
            "{}: holds {} without the {} that lists it; go on in another folder with --output",
            options_.folder.string(), file, series));
      if (std::stoul(rest) < series_.size()) continue;
    }
    const bool isPicture = file == "first.png" && !isContinued;
    if (std::regex_match(rest, state) || isCheckpoint || isPicture ||
        (file == series && !isContinued) || file == "last.png" || file == "failed.png" ||
        file == "summary.json" || file == "validation.json")
      old.push_back(entry.path());
  }
  if (hasCheckpoints && !hasEnded && !isContinued && !options_.anew)
    throw InputError(fmt::format(
        "{0}: holds the checkpoints of a run that has not come to its end; go on with it by "
        "`plenum-sph resume {0}`, choose another folder with --output, or begin again with --anew",
        options_.folder.string()));
  for (const fs::path& path : old) fs::remove(path);
}

template <int Dim>
fs::path Recorder<Dim>::stateFile(std::size_t number) const {
  return options_.folder / fmt::format("{}_{:04}.vtu", options_.name, number);
}

template <int Dim>
double Recorder<Dim>::wallClock() const {
  return earlierWallClock_ +
         std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

template <int Dim>
void Recorder<Dim>::addState(const Simulation<Dim>& simulation) {
  const fs::path file = stateFile(series_.size());
  writeVtu(file, simulation.particles(), {simulation.time(), fields_});
  series_.add(simulation.time(), file);
}

template <int Dim>
void Recorder<Dim>::addRow(std::vector<Figure> row) {
  row_ = std::move(row);
  history_->add(row_);
}

template <int Dim>
void Recorder<Dim>::draw(const Simulation<Dim>& simulation, const std::string& fileName,
                         bool failed) const {
  const OutputSettings output = settings_.outputOrDefaults();
  auto picture = pictureOptions(simulation.info(), output.picture);
  if (output.look && !failed) {
    picture.smooth = output.look->smooth;
    const auto axis = std::string("xyz").find(output.look->along);
    if (axis != std::string::npos && output.look->at)
      picture.slice = Slice{static_cast<int>(axis), *output.look->at, 0};
    else if (axis != std::string::npos)
      picture.column = static_cast<int>(axis);
  }
  drawParticles(options_.folder / fileName, simulation.particles(), picture);
}

template <int Dim>
void Recorder<Dim>::drawFirst(const Simulation<Dim>& simulation) const {
  draw(simulation, "first.png");
}

template <int Dim>
void Recorder<Dim>::finish(const Simulation<Dim>& simulation,
                           const std::vector<ValidationResult>& validation,
                           std::optional<double> meanNeighbours, const ActivityClock& clock) const {
  draw(simulation, "last.png");
  writeParticleFile(options_.folder / (options_.name + "_end.hdf"), simulation.scene());
  writeSummary(simulation, meanNeighbours, clock);
  if (!validation.empty()) writeValidation(options_.folder / "validation.json", validation);
}

template <int Dim>
std::string Recorder<Dim>::saveFailed(const Simulation<Dim>& simulation) const noexcept {
  const fs::path file = options_.folder / (options_.name + "_failed.hdf");
  try {
    writeParticleFile(file, simulation.scene());
    writeVtu(options_.folder / (options_.name + "_failed.vtu"), simulation.particles(),
             {simulation.time(), std::nullopt});
    draw(simulation, "failed.png", true);
    return "the last state is in " + file.string();
  } catch (const std::exception& error) {
    return std::string("and the last state could not be saved: ") + error.what();
  }
}

template <int Dim>
double Recorder<Dim>::updatesPerSecond(const Simulation<Dim>& simulation,
                                       const ActivityClock& clock) const {
  const double updates = static_cast<double>(simulation.nSteps() - earlierSteps_) *
                         static_cast<double>(simulation.particles().nFluid());
  const double seconds = clock.seconds(Activity::stepping);
  return seconds > 0 ? updates / seconds : 0;
}

template <int Dim>
std::string Recorder<Dim>::speed(const Simulation<Dim>& simulation,
                                 const ActivityClock& clock) const {
  return fmt::format(
      "{:.3g} million updates of fluid particles a second ({:.3g} s; measures {:.3g} s, files "
      "{:.3g} s)",
      1e-6 * updatesPerSecond(simulation, clock), clock.seconds(Activity::stepping),
      clock.seconds(Activity::measuring), clock.seconds(Activity::writing));
}

template <int Dim>
void Recorder<Dim>::writeSummary(const Simulation<Dim>& simulation,
                                 std::optional<double> meanNeighbours,
                                 const ActivityClock& clock) const {
  using Json = nlohmann::ordered_json;
  const ParticleSet<Dim>& particles = simulation.particles();
  Json figures, units, fields = Json::array();
  for (const Figure& f : row_) {
    figures[f.name] = f.value;
    if (!f.unit.empty()) units[f.name] = f.unit;
  }
  particles.forEachField([&](const FieldInfo& info, auto) { fields.push_back(info.name); });
  Json parts;
  for (std::size_t k = 0; k < partNames.size(); ++k)
    parts[std::string(partNames[k])] =
        simulation.engine().stopwatch().seconds(static_cast<Part>(k));
  Json summary{
      {"title", simulation.info().title},
      {"case", simulation.info().caseName},
      {"program", fmt::format("plenum-sph {}", version)},
      {"dimension", Dim},
      {"fluid_particles", particles.nFluid()},
      {"wall_particles", particles.nWalls()},
      {"kernel", simulation.settings().kernel},
      {"smoothing_length_over_spacing", simulation.settings().smoothingLength},
      {"steps", simulation.nSteps()},
      {"wall_clock", wallClock()},
      {"measures", figures},
      {"units", units},
      {"fields", fields},
      {"bytes_per_particle", simulation.bytesPerParticle()},
      {"updates_per_second", updatesPerSecond(simulation, clock)},
      {"activity_seconds",
       {{"stepping", clock.seconds(Activity::stepping)},
        {"measuring", clock.seconds(Activity::measuring)},
        {"writing", clock.seconds(Activity::writing)}}},
      {"activity_cpu_seconds",
       {{"stepping", clock.cpuSeconds(Activity::stepping)},
        {"measuring", clock.cpuSeconds(Activity::measuring)},
        {"writing", clock.cpuSeconds(Activity::writing)}}},
      {"step_seconds", parts},
      {"precision", simulation.settings().precision},
      {"threads", omp_get_max_threads()},
  };
  if (meanNeighbours) summary["neighbours_mean"] = *meanNeighbours;
  writeTextFile(options_.folder / "summary.json", summary.dump(2) + "\n");
}

template class Recorder<1>;
template class Recorder<2>;
template class Recorder<3>;

}  // namespace plenum
