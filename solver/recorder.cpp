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

template <int Dim>
std::optional<FieldSet> outputFields(const OutputSettings& output,
                                     const ParticleSet<Dim>& particles) {
  modelledField(output.picture, "output.picture", particles);
  if (output.fields.empty()) return std::nullopt;
  FieldSet fields;
  for (const std::string& name : output.fields)
    fields |= {modelledField(name, "output.fields", particles)};
  return fields;
}

}  // namespace

template <int Dim>
Recorder<Dim>::Recorder(const RunOptions& options, const CaseSettings& settings,
                        const Simulation<Dim>& simulation)
    : options_(options),
      settings_(settings),
      fields_(outputFields(settings.outputOrDefaults(), simulation.particles())),
      series_(options.folder / (options.name + ".pvd")) {
  std::error_code error;
  fs::create_directories(options_.folder, error);
  if (error)
    throw RunError(fmt::format("{}: cannot be made: {}; choose another folder with --output",
                               options_.folder.string(), error.message()));
  removeOldFiles();
  history_.emplace(options_.folder / "history.csv");
}

template <int Dim>
void Recorder<Dim>::removeOldFiles() const {
  const std::string prefix = options_.name + "_", series = options_.name + ".pvd";
  const std::regex state(R"((\d{4,}\.vtu|end\.hdf|failed\.(hdf|vtu))(\.\d+\.tmp)?)");
  std::vector<fs::path> old;
  for (const auto& entry : fs::directory_iterator(options_.folder)) {
    const std::string file = entry.path().filename().string();
    if (entry.path().extension() == ".pvd" && file != series)
      throw InputError(fmt::format("{}: holds the run {} already; choose another with --output",
                                   options_.folder.string(), file));
    const bool isState =
        file.starts_with(prefix) && std::regex_match(file.substr(prefix.size()), state);
    if (isState || file == series || file == "first.png" || file == "last.png" ||
        file == "summary.json" || file == "validation.json")
      old.push_back(entry.path());
  }
  for (const fs::path& path : old) fs::remove(path);
}

template <int Dim>
double Recorder<Dim>::wallClock() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

template <int Dim>
void Recorder<Dim>::addState(const Simulation<Dim>& simulation) {
  const fs::path file =
      options_.folder / fmt::format("{}_{:04}.vtu", options_.name, series_.size());
  writeVtu(file, simulation.particles(), {simulation.time(), fields_});
  series_.add(simulation.time(), file);
}

template <int Dim>
void Recorder<Dim>::addRow(std::vector<Figure> row) {
  row_ = std::move(row);
  history_->add(row_);
}

template <int Dim>
void Recorder<Dim>::draw(const Simulation<Dim>& simulation, const std::string& fileName) const {
  const auto picture = pictureOptions(simulation.info(), settings_.outputOrDefaults().picture);
  drawParticles(options_.folder / fileName, simulation.particles(), picture);
}

template <int Dim>
void Recorder<Dim>::drawFirst(const Simulation<Dim>& simulation) const {
  draw(simulation, "first.png");
}

template <int Dim>
void Recorder<Dim>::finish(const Simulation<Dim>& simulation,
                           const std::vector<ValidationResult>& validation) const {
  draw(simulation, "last.png");
  writeParticleFile(options_.folder / (options_.name + "_end.hdf"), simulation.scene());
  writeSummary(simulation);
  if (!validation.empty()) writeValidation(options_.folder / "validation.json", validation);
}

template <int Dim>
std::string Recorder<Dim>::saveFailed(const Simulation<Dim>& simulation) const noexcept {
  const fs::path file = options_.folder / (options_.name + "_failed.hdf");
  try {
    writeParticleFile(file, simulation.scene());
    writeVtu(options_.folder / (options_.name + "_failed.vtu"), simulation.particles(),
             {simulation.time(), std::nullopt});
    return "the last state is in " + file.string();
  } catch (const std::exception& error) {
    return std::string("and the last state could not be saved: ") + error.what();
  }
}

template <int Dim>
void Recorder<Dim>::writeSummary(const Simulation<Dim>& simulation) const {
  using Json = nlohmann::ordered_json;
  const ParticleSet<Dim>& particles = simulation.particles();
  Json figures, units, fields = Json::array();
  for (const Figure& f : row_) {
    figures[f.name] = f.value;
    if (!f.unit.empty()) units[f.name] = f.unit;
  }
  particles.forEachField([&](const FieldInfo& info, auto) { fields.push_back(info.name); });
  const double updates =
      static_cast<double>(simulation.nSteps()) * static_cast<double>(particles.nFluid());
  const Json summary{
      {"title", simulation.info().title},
      {"case", simulation.info().caseName},
      {"program", fmt::format("plenum-sph {}", version)},
      {"dimension", Dim},
      {"fluid_particles", particles.nFluid()},
      {"wall_particles", particles.nWalls()},
      {"kernel", simulation.settings().kernel},
      {"smoothing_length_over_spacing", simulation.settings().smoothingLength},
      {"measures", figures},
      {"units", units},
      {"fields", fields},
      {"bytes_per_particle", simulation.bytesPerParticle()},
      {"updates_per_second", updates / wallClock()},
  };
  writeTextFile(options_.folder / "summary.json", summary.dump(2) + "\n");
}

template class Recorder<1>;
template class Recorder<2>;
template class Recorder<3>;

}  // namespace plenum
