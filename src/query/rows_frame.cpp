// Queries about the last frame and its picture: a row for each figure of the two tables, and derived figures.
#include <array>
#include <utility>

#include "query/rows.h"
#include "sim/shape/deviation.h"

namespace coaster::query {
namespace {

// Times and rates are 0 until they are measured.
template <const auto& table, std::size_t row>
Answer number_of_frame(const Context& c, View) {
  const auto& [query, unit, text, member] = table[row];
  const double value = std::visit([&](auto of) { return static_cast<double>(c.stats.*of); }, member);
  if (c.stats.frame == 0 && query != "frame") return none(kNoFrame);
  return value == 0 && (unit == "ms" || unit == "1/s") ? none("it was not measured") : number(value);
}

template <const auto& table, std::size_t... row>
constexpr auto rows_of(std::index_sequence<row...>) {
  return std::array{Query{table[row].query,
                          {},
                          table[row].unit,
                          table[row].text,
                          number_of_frame<table, row>,
                          table[row].query == "frame" ? Values{} : or_none()}...};
}

// The deviation of the processor, or the one captured from the GPU.
Answer deviation(const Context& c, View) {
  const sim::Derived& derived = c.session.derived;
  if (derived.order.empty()) return none(kNoSegment);
  if (derived.evaluated_by == curve::EvaluatedBy::processor) return number(derived.deviation);
  return c.stats.frame > 0 && c.stats.deviation_pending == 0 ? number(c.stats.deviation)
                                                             : none("it is not measured yet");
}
Answer chord_error(const Context& c, View) {
  return c.session.derived.order.empty() ? none(kNoSegment) : number(c.find.chord_error());
}
Answer ns_per_point(const Context& c, View) {
  if (c.stats.evaluated_vertices == 0) return none("nothing has been evaluated");
  return number(c.stats.evaluation_ms * 1e6 / static_cast<double>(c.stats.evaluated_vertices));
}

constexpr auto kDrawRows = rows_of<view::kDrawNumbers>(std::make_index_sequence<view::kDrawNumbers.size()>());
constexpr auto kFrameRows = rows_of<kFrameNumbers>(std::make_index_sequence<kFrameNumbers.size()>());
constexpr std::array kMoreRows{
    Query{"deviation", kNoArgument, "m", "Largest distance of a vertex from the exact point at the same parameter.",
          deviation, or_none()},
    Query{"chord_error", kNoArgument, "m", "Largest distance of a piece of the curve from its chord.", chord_error,
          or_none()},
    Query{"drawn_by", kNoArgument, "",
          "Where the polylines were evaluated: processor, vertex_shader, geometry_shader or tessellation_shader.",
          of_frame<&FrameStats::drawn_by>, or_none(kOneOf<curve::EvaluatedBy>)},
    Query{"ns_per_point", kNoArgument, "ns", "Time of evaluators per vertex in the last frame that evaluated anything.",
          ns_per_point, or_none()},
};

}  // namespace

std::span<const Query> draw_rows() { return kDrawRows; }
std::span<const Query> frame_rows() { return kFrameRows; }
std::span<const Query> evaluation_rows() { return kMoreRows; }

}  // namespace coaster::query
