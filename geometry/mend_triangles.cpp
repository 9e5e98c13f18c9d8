// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts of mending that go from triangle to triangle.
#include "geometry/mend_surface.hpp"
#include "geometry/surface_shells.hpp"

#include <algorithm>
#include <array>

namespace plenum {

namespace {

constexpr std::size_t none = static_cast<std::size_t>(-1);

using Triangle = std::array<std::size_t, 3>;

bool hasCorner(const Triangle& triangle, std::size_t corner) {
  return std::ranges::find(triangle, corner) != triangle.end();
}

/// The triangles of a soup at each of its corners, kept while triangles change.
class Corners {
 public:
  explicit Corners(const TriangleSoup& soup) : at_(soup.points.size()) {
    for (std::size_t t = 0; t < soup.triangles.size(); ++t) add(soup.triangles[t], t);
  }

  void add(const Triangle& triangle, std::size_t t) {
    for (std::size_t corner : triangle) at_[corner].push_back(t);
  }
  void remove(const Triangle& triangle, std::size_t t) {
    for (std::size_t corner : triangle) std::erase(at_[corner], t);
  }

  /// All triangles but `t` that have both corners.
  std::vector<std::size_t> others(const TriangleSoup& soup, std::size_t t, std::size_t a,
                                  std::size_t b) const {
    std::vector<std::size_t> found;
    for (std::size_t other : at_[a])
      if (other != t && hasCorner(soup.triangles[other], b)) found.push_back(other);
    return found;
  }

 private:
  std::vector<std::vector<std::size_t>> at_;
};

/// Which side (from corner k to the next) is the longest.
std::size_t longestSide(const TriangleSoup& soup, std::size_t t) {
  std::size_t longest = 0;
  double length = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double here = norm(soup.corner(t, (k + 1) % 3) - soup.corner(t, k));
    if (here <= length) continue;
    length = here;
    longest = k;
  }
  return longest;
}

/// What is done with a triangle without area.
enum class Outcome { kept, replaced, leftOut };

/// The flat triangle a-b-m, m on the long side a-b, and its neighbour n there become the two halves
/// of n: a-m-c and m-b-c, in n's order of corners.
Outcome takeOut(TriangleSoup& soup, std::size_t t, Corners& corners) {
  const Triangle flat = soup.triangles[t];
  const std::size_t k = longestSide(soup, t);
  const std::size_t a = flat[k], b = flat[(k + 1) % 3], m = flat[(k + 2) % 3];
  const auto across = corners.others(soup, t, a, b);
  const bool isFree =
      corners.others(soup, t, b, m).empty() && corners.others(soup, t, m, a).empty();
  if (isFree) {  // hangs on its long side, or on nothing
    corners.remove(flat, t);
    return Outcome::leftOut;
  }
  if (across.size() != 1) return Outcome::kept;
  const std::size_t n = across.front();
  const Triangle whole = soup.triangles[n];
  if (hasCorner(whole, m)) {  // the same three corners twice: a slit without width
    corners.remove(flat, t);
    corners.remove(whole, n);
    soup.triangles[n] = {none, none, none};
    return Outcome::leftOut;
  }
  corners.remove(flat, t);
  corners.remove(whole, n);
  for (std::size_t& corner : soup.triangles[n])
    if (corner == b) corner = m;
  soup.triangles[t] = whole;
  for (std::size_t& corner : soup.triangles[t])
    if (corner == a) corner = m;
  corners.add(soup.triangles[n], n);
  corners.add(soup.triangles[t], t);
  return Outcome::replaced;
}

}  // namespace

std::vector<Vec<3>> removeFlatTriangles(TriangleSoup& soup) {
  std::vector<Vec<3>> places;
  std::vector<std::size_t> flat;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    if (hasNoArea(soup, t)) flat.push_back(t);
  if (flat.empty()) return places;
  Corners corners(soup);
  // A half of a neighbour may be flat in its turn: several rounds, each shortening the long side.
  constexpr int maxRounds = 20;
  for (int round = 0; round < maxRounds && !flat.empty(); ++round) {
    std::vector<std::size_t> again;
    for (std::size_t t : flat) {
      if (soup.triangles[t][0] == none || !hasNoArea(soup, t)) continue;
      const Vec<3> center = soup.center(t);
      const Outcome outcome = takeOut(soup, t, corners);
      if (outcome == Outcome::leftOut) soup.triangles[t] = {none, none, none};
      if (outcome != Outcome::kept && round == 0) places.push_back(center);
      if (outcome != Outcome::leftOut && hasNoArea(soup, t)) again.push_back(t);
    }
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
      if (soup.triangles[t][0] != none && hasNoArea(soup, t)) again.push_back(t);
    std::ranges::sort(again);
    again.erase(std::unique(again.begin(), again.end()), again.end());
    flat = std::move(again);
  }
  std::erase_if(soup.triangles, [](const Triangle& t) { return t[0] == none; });
  return places;
}

std::vector<Vec<3>> turnCoherently(TriangleSoup& soup) {
  struct Neighbour {
    std::size_t triangle;
    bool agrees;
  };
  std::vector<std::vector<Neighbour>> neighbours(soup.triangles.size());
  bool isSheet = true;
  forEachEdge(sidesOf(soup), [&](std::span<const Side> edge) {
    if (edge.size() > 2) isSheet = false;
    if (edge.size() != 2) return;
    const bool agrees = edge[0].forward != edge[1].forward;
    neighbours[edge[0].triangle].push_back({edge[1].triangle, agrees});
    neighbours[edge[1].triangle].push_back({edge[0].triangle, agrees});
  });
  if (!isSheet) return {};

  enum State : char { unseen, kept, turned };
  std::vector<State> state(soup.triangles.size(), unseen);
  for (std::size_t first = 0; first < state.size(); ++first) {
    if (state[first] != unseen) continue;
    state[first] = kept;
    std::vector<std::size_t> part{first};
    for (std::size_t k = 0; k < part.size(); ++k)
      for (const Neighbour& next : neighbours[part[k]]) {
        const State wanted = next.agrees == (state[part[k]] == kept) ? kept : turned;
        State& here = state[next.triangle];
        if (here == unseen) part.push_back(next.triangle);
        if (here != unseen && here != wanted) return {};  // one side only, as a Moebius band
        here = wanted;
      }
    const auto nTurned =
        std::ranges::count_if(part, [&](std::size_t t) { return state[t] == turned; });
    if (2 * nTurned > std::ssize(part))
      for (std::size_t t : part) state[t] = state[t] == kept ? turned : kept;
  }
  std::vector<Vec<3>> places;
  for (std::size_t t = 0; t < state.size(); ++t)
    if (state[t] == turned) {
      places.push_back(soup.center(t));
      std::swap(soup.triangles[t][1], soup.triangles[t][2]);
    }
  return places;
}

}  // namespace plenum
