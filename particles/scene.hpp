// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a particle file holds: the particles and everything the solver must know about them.
#pragma once

#include "particles/box.hpp"
#include "particles/container_map.hpp"
#include "particles/particle_set.hpp"
#include "particles/rigid_motion.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace plenum {

/// A fluid's reference state. What is absent is as [solver] says.
struct Material {
  std::string name;
  double density = 1;                             ///< reference density rho_0 [kg/m^d]
  std::optional<double> soundSpeed = {};          ///< c [m/s]
  std::optional<double> taitExponent = {};        ///< gamma
  std::optional<double> backgroundPressure = {};  ///< p0 [Pa m^(3-d)]
  std::optional<double> dynamicViscosity = {};    ///< [Pa s m^(3-d)]
  std::optional<double> cavitationPressure = {};  ///< [Pa m^(3-d)]
};

struct Wall {
  std::string name;
  std::string method;    ///< "lattice" or "conformal"
  int layers = 0;        ///< thickness / spacing, as asked for
  double thickness = 0;  ///< depth to which particles stand behind the surface, or the
                         ///< way through the solid where that is less [m]
  double density = 1;    ///< [kg/m^d]
  RigidMotion motion;
};

/// Everything about a scene but its particles.
template <int Dim>
struct SceneInfo {
  std::string title;
  std::string caseName;        ///< path of the case file as given
  std::string caseText;        ///< the whole case file
  std::string generator;       ///< program and version that wrote the file
  double time = 0;             ///< [s]
  double startTime = 0;        ///< at which moving walls had their reference positions [s]
  double spacing = 0;          ///< d_ref [m]
  std::string kernel;          ///< that the set was made for; the solver may choose another
  double smoothingLength = 0;  ///< h [m]
  Box<Dim> domain;             ///< periodic axes are exact; open axes just contain all particles
  std::vector<Material> materials;
  std::vector<Wall> walls;
  ContainerMap<Dim> container;                          ///< the region in which fluid may be
  std::vector<std::pair<std::string, double>> quality;  ///< named figures of the particle set
  /// What a run that stopped here needs to go on with the same bits; empty in other files.
  std::vector<std::pair<std::string, double>> progress;
};

template <int Dim>
struct Scene {
  SceneInfo<Dim> info;
  ParticleSet<Dim> particles;
};

}  // namespace plenum
