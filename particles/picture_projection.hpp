// SPDX-License-Identifier: GPL-3.0-or-later
//
// From particles in space to dots in the plane of a picture. Only particles/*.cpp include this.
#pragma once

#include "particles/picture_frame.hpp"
#include "particles/scene.hpp"

#include <optional>
#include <vector>

namespace plenum {

/// Dots in the order in which they are drawn.
struct PlaneDots {
  struct Dot {
    double x;  ///< in the plane [m]
    double y;
    float depth;  ///< towards the viewer [m]
    std::uint32_t particle;
  };
  std::vector<Dot> dots;
  std::size_t nOutside = 0;     ///< particles outside the view, or nowhere (NaN)
  bool leavesWallsOut = false;  ///< walls between viewer and fluid are not among the dots
};

/// Bounds of walls and `container`; without them, of all particles but a few that flew away.
template <int Dim>
Box<Dim> defaultView(const ParticleSet<Dim>& particles, const std::optional<Box<Dim>>& container);

/// Edge of the cell that a particle has on average in the default view [m].
template <int Dim>
double estimatedSpacing(const ParticleSet<Dim>& particles,
                        const std::optional<Box<Dim>>& container);

/// Bounds of the cells of the container map that lie inside, and of the domain's periodic axes.
template <int Dim>
std::optional<Box<Dim>> containerBounds(const SceneInfo<Dim>& info);

/// Particles inside `shown`, seen along the third axis; those outside `view` are counted.
template <int Dim>
PlaneDots dotsInPlane(const ParticleSet<Dim>& particles, const Box<Dim>& view,
                      const Box<Dim>& shown, int horizontal, int vertical);

/// Particles inside `view`, seen from the front right and somewhat above (z is up).
PlaneDots dotsInSpace(const ParticleSet<3>& particles, const Box<3>& view);

/// The edges of the view's box behind the particles, with numbers in metres.
class SpaceAxes {
 public:
  SpaceAxes(const Box<3>& box, int width);
  PlaneView view() const { return view_; }  ///< box and numbers
  void draw(PictureFrame& frame) const;

 private:
  void drawNumbers(PictureFrame& frame, int axis, const Vec<3>& start) const;

  Box<3> box_;
  PlaneView view_;
};

}  // namespace plenum
