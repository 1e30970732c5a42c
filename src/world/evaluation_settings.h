// Settings of evaluation: polylines and the displayed length. Changing one derives the track again.
#pragma once

#include <cstdint>

#include "curve/arc_length.h"
#include "curve/evaluators.h"
#include "world/setting_row.h"

namespace coaster::world {

// Invariant: the polylines of the document fit into the vertex budget.
struct Evaluation {
  curve::EvaluatorId evaluator = curve::kDefaultEvaluator;
  int steps = 64;                           // per segment
  std::int64_t vertex_budget = 16'000'000;  // for all polylines together
  curve::ArcLengthId arc_length{};
  friend bool operator==(const Evaluation&, const Evaluation&) = default;

  static constexpr auto kRows =
      std::tuple{setting(&Evaluation::evaluator, "evaluator", "Method that evaluates the polylines."),
                 setting(&Evaluation::steps, "resolution", "Steps per segment of the polylines.",
                         {.low = curve::kMinSteps, .high = curve::kMaxSteps}),
                 setting(&Evaluation::vertex_budget, "vertex_budget",
                         "Limit of the vertices of all polylines together.", {.low = 1e3, .high = 1e9}),
                 setting(&Evaluation::arc_length, "arc_length", "Method that measures the displayed length.")};
};

}  // namespace coaster::world
