// The content of an openFVD or FVD++ project (.fvd), with every number checked. fvd.h makes a document of it.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/glm.hpp>

#include "base/status.h"

namespace coaster::exchange {

// The shape of a piece of a function between its start and its end: docs/forces.md has the formulas.
enum class FvdShape : std::uint8_t {
  linear,
  quadratic,
  cubic,
  quartic,
  quintic,
  sinusoidal,
  plateau,
  to_zero,   // rolls to the horizon
  free_form  // its points are not in the file
};

struct FvdPiece {
  FvdShape shape = FvdShape::linear;
  double from = 0, to = 0;         // s, m or degrees of turning
  double start = 0, change = 0;    // value at its start; change to its end or to its peak
  double form = 0;                 // shape of quadratic to quintic pieces and plateaus
  double centre = 0, tension = 0;  // shift of its middle; steepness there
  bool follows = false;            // it ends where the section does
};
using FvdFunction = std::vector<FvdPiece>;  // ascending, at least one

enum class FvdKind : std::uint8_t { straight, curved, forced, geometric, bezier };

struct FvdSection {
  FvdKind kind = FvdKind::straight;
  std::string name;
  bool free_speed = true;                                                  // else the train keeps `speed`
  double speed = 0;                                                        // m/s
  double angle = 0, radius = 0, direction = 0, lead_in = 0, lead_out = 0;  // curved: degrees, m
  bool upright = false;      // roll is relative to the horizon, not to a rotation-minimising frame
  bool by_distance = false;  // forced, geometric: functions of m, not of s
  FvdFunction roll;          // degrees per second (forced and geometric by distance: per metre), positive to the left
  FvdFunction vertical;      // forced: g; geometric: degrees of pitch per second or metre
  FvdFunction lateral;       // forced: g to the left; geometric: degrees of yaw to the left
};

struct FvdTrack {
  std::string name;
  glm::dvec3 position{0};               // m, of the heartline's start
  double roll = 0, pitch = 0, yaw = 0;  // degrees there, to the left, up and to the left of -Z
  double speed = 0;                     // m/s at the start
  double heart = 0;                     // m from the rails up to the heartline
  double friction = 0, resistance = 0;  // share of the weight; 1/m
  std::vector<FvdSection> sections;
  std::size_t others = 0;  // further tracks of the project, which are not read
};

inline constexpr std::size_t kMostFvdSections = 500, kMostFvdPieces = 500;  // sections of a track, pieces of a function

// Reads the first track. Code::bad_file with "NAME: error: at byte N: expected ..., found ..." for a file that ends
// early, versions other than v0.30 and v0.77, numbers that are not finite or beyond the limits of a track, and pieces
// that do not ascend.
base::Result<FvdTrack> read_fvd(std::string_view bytes, std::string_view name);

}  // namespace coaster::exchange
