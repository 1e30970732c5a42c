// Vertices by vector arithmetic: eight parameters at once, packed for a vertex buffer. For display only: rounding
// depends on the processor, so no saved or hashed value comes from here.
#pragma once

#include <span>

#include "curve/cubic.h"

namespace coaster::curve {

// The instructions that a kernel uses. `baseline` is the instruction set of the whole program (SSE2 on x86-64) and runs
// everywhere.
enum class InstructionSet { baseline, avx2 };

// Returns the best instruction set of this machine, detected once.
InstructionSet best_processor();
std::span<const InstructionSet> available_processors();  // for tests: baseline, then avx2 where it runs

// Horner's rule: each vertex rounds independently. Differences: each of eight lanes steps by eight parameters with
// three additions and restarts every 64 vertices. A fourth addition, of the run's first point, prevents rounding errors
// of the size of the coordinates from accumulating. Both give exactly p0 and p3 at the ends and are finite for every
// cubic within the limits of coordinates.
enum class VectorMethod { horner, differences };

// Return the largest |vertex - exact| in m for control points at most `extent` from the origin and a control polygon
// `size` long, for any number of steps.
double vector_horner_error_bound(double extent, double size);
double vector_differences_error_bound(double extent, double size);
double track_error_bound(double extent, double size);  // for track_points()

// Writes B(i/n), i = 0..n, n = points.size() - 1 >= 1, of one curve.
void vector_polyline(VectorMethod method, const PreparedCubic& curve, std::span<glm::vec3> points,
                     InstructionSet on = best_processor());

// How the curves of a track follow each other in a buffer. `polylines`: n + 1 vertices each. `chain`: each curve ends
// at the start of the next, so n vertices each (i/n, i < n), and the last curve's p3 at the very end.
enum class VertexLayout { polylines, chain };

// Returns the number of vertices of `curves` curves of n steps in a layout: curves (n + 1), or curves n + 1. 0 without
// curves.
std::size_t track_vertices(std::size_t curves, int steps, VertexLayout layout);

// Writes the positions of a whole track by differences without the fourth addition: the fastest method, error below
// track_error_bound(). `out` holds track_vertices(). A chain of more than 32 MB whose steps are a multiple of 8, in
// memory aligned to 32 bytes, bypasses the caches.
void track_points(std::span<const PreparedCubic> curves, int steps, VertexLayout layout, std::span<glm::vec3> out,
                  InstructionSet on = best_processor());

}  // namespace coaster::curve
