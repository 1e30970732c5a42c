// Queries about the last frame and its picture: a row for each figure of the two tables, and derived figures.
#include <array>
#include <utility>

#include "query/rows.h"
#include "sim/shape/deviation.h"

namespace coaster::query {
namespace {

template <const auto& table, std::size_t row>
Answer number_of_frame(const Context& c, View) {
  return std::visit([&](auto member) { return number(c.stats.*member); }, table[row].member);
}

template <const auto& table, std::size_t... row>
constexpr auto rows_of(std::index_sequence<row...>) {
  return std::array{Query{table[row].query, {}, table[row].unit, table[row].text, number_of_frame<table, row>}...};
}

// The deviation of the processor, or the one captured from the GPU.
Answer deviation(const Context& c, View) {
  const sim::Derived& derived = c.session.derived;
  return number(derived.evaluated_by == curve::EvaluatedBy::processor ? derived.deviation : c.stats.deviation);
}
Answer chord_error(const Context& c, View) { return number(c.find(edit::Want::chord_error).chord_error); }
Answer drawn_by(const Context& c, View) { return text(base::name_of(c.stats.drawn_by)); }
Answer ns_per_point(const Context& c, View) {
  return number(c.stats.evaluated_vertices > 0
                    ? c.stats.evaluation_ms * 1e6 / static_cast<double>(c.stats.evaluated_vertices)
                    : 0.0);
}

constexpr auto kDrawRows = rows_of<view::kDrawNumbers>(std::make_index_sequence<view::kDrawNumbers.size()>());
constexpr auto kFrameRows = rows_of<kFrameNumbers>(std::make_index_sequence<kFrameNumbers.size()>());
constexpr std::array kMoreRows{
    Query{"deviation", kNoArgument, "m", "Largest distance of a vertex from the exact point at the same parameter.",
          deviation},
    Query{"chord_error", kNoArgument, "m", "Largest distance of a piece of the curve from its chord.", chord_error},
    Query{"drawn_by", kNoArgument, "",
          "Where the polylines were evaluated: processor, vertex_shader, geometry_shader or tessellation_shader.",
          drawn_by, kOneOf<curve::EvaluatedBy>},
    Query{"ns_per_point", kNoArgument, "ns", "Time of evaluators per vertex in the last frame that evaluated anything.",
          ns_per_point},
};

}  // namespace

std::span<const Query> draw_rows() { return kDrawRows; }
std::span<const Query> frame_rows() { return kFrameRows; }
std::span<const Query> evaluation_rows() { return kMoreRows; }

}  // namespace coaster::query
