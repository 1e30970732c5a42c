// Vertices by vector arithmetic: eight parameters at once, packed as a vertex buffer wants them. For the display:
// another processor may round otherwise, so nothing that is saved or hashed comes from here.
#pragma once

#include <span>

#include "curve/cubic.h"

namespace coaster::curve {

// The instructions that a kernel uses. `baseline` is what the whole program is compiled for (SSE2 on x86-64) and runs
// everywhere.
enum class Processor { baseline, avx2 };

// The best that this machine has, found out once.
Processor best_processor();
std::span<const Processor> available_processors();  // for tests: baseline, then avx2 where it runs

// Horner's rule: each vertex rounds on its own. Differences: each of eight lanes steps by eight parameters with three
// additions and starts anew every 64 vertices; a fourth addition, of the run's first point, keeps the rounding at the
// size of the coordinates from piling up. Both give exactly p0 and p3 at the ends and are finite for every cubic within
// the limits of coordinates.
enum class VectorMethod { horner, differences };

// Largest |vertex - exact| for control points at most `extent` from the origin and a control polygon `size` long, any
// number of steps.
double vector_horner_error_bound(double extent, double size);
double vector_differences_error_bound(double extent, double size);
double track_error_bound(double extent, double size);  // of the functions for whole tracks, below

// B(i/n), i = 0..n, n = points.size() - 1 >= 1, of one curve.
void vector_polyline(VectorMethod method, const PreparedCubic& curve, std::span<glm::vec3> points,
                     Processor on = best_processor());

// How the curves of a track follow each other in a buffer. `polylines`: n + 1 vertices each. `chain`: each curve's end
// is the next one's start, so n vertices each (i/n, i < n), and the last curve's p3 at the very end.
enum class TrackLayout { polylines, chain };

// Vertices that `curves` curves of n steps have in a layout: curves (n + 1), or curves n + 1. 0 without curves.
std::size_t track_vertices(std::size_t curves, int steps, TrackLayout layout);

// Positions of a whole track by differences without the fourth addition: the fastest, error below track_error_bound().
// `out` holds track_vertices(). A chain of more than 32 MB whose steps are a multiple of 8, in memory aligned to 32
// bytes, is written past the caches.
void track_points(std::span<const PreparedCubic> curves, int steps, TrackLayout layout, std::span<glm::vec3> out,
                  Processor on = best_processor());

struct TrackVertex {
  glm::vec3 position;
  glm::vec3 tangent;
};

// Positions with B'(t) in turn, 24 bytes a vertex; `out` as above, n + 1 vertices a curve (two curves may leave a joint
// with different speeds).
void track_vertices_with_tangents(std::span<const PreparedCubic> curves, int steps, std::span<TrackVertex> out,
                                  Processor on = best_processor());

// Positions as by track_points(), and beside them unit tangents, packed alike: 24 bytes a vertex in two arrays, each in
// the layout. A unit tangent is off by less than 24 u D / |B'| + 4e-7 (u = 2^-24, D = |c1| + 2 |c2| + 3 |c3|) besides
// the rounding of the coefficients; curves that slow down below D/64 somewhere (cusps, handles on their anchors) are
// done by unit_tangent() in double, which also gives cusps their limit direction.
void track_points_and_unit_tangents(std::span<const PreparedCubic> curves, int steps, TrackLayout layout,
                                    std::span<glm::vec3> points, std::span<glm::vec3> tangents,
                                    Processor on = best_processor());

}  // namespace coaster::curve
