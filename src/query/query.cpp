// Joins the parts of the table and looks up names.
#include "query/query.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "base/words.h"
#include "query/rows.h"

namespace coaster::query {

std::string to_text(const Value& value) {
  struct Visitor {
    // A count of 100000 is not "1e+05".
    std::string operator()(double v) const {
      return v == std::trunc(v) && std::abs(v) < 1e15 ? fmt::format("{:.0f}", v + 0.0) : base::to_text(v);
    }
    std::string operator()(const std::string& v) const { return v; }
    std::string operator()(const Ranked& v) const { return v.text; }
    std::string operator()(glm::dvec3 v) const {
      return fmt::format("{} {} {}", base::to_text(v.x), base::to_text(v.y), base::to_text(v.z));
    }
  };
  return std::visit(Visitor{}, value);
}

std::span<const Query> queries() {
  static const std::vector<Query> table = [] {
    std::vector<Query> rows;
    for (const std::span<const Query> part : {document_rows(), section_rows(), ride_rows(), ghost_rows(), rider_rows(),
                                              session_rows(), setting_rows(), joint_rows(), lab_rows(), element_rows(),
                                              force_rows(), game_rows(), draw_rows(), frame_rows(), evaluation_rows()})
      rows.insert(rows.end(), part.begin(), part.end());
    return rows;
  }();
  return table;
}

const Query* find_query(std::string_view name) {
  const std::span<const Query> all = queries();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Query& query) { return query.name == name; });
  return found == all.end() ? nullptr : &*found;
}

std::optional<int> rank_of(std::string_view query_name, std::string_view word) {
  const std::string lower = base::lower(word);
  const auto place = [&](std::span<const std::string_view> words) -> std::optional<int> {
    const auto found = std::find(words.begin(), words.end(), lower);
    if (found == words.end()) return std::nullopt;
    return static_cast<int>(found - words.begin());
  };
  const auto continuity = [&](const std::array<std::string_view, 4>& words) {
    auto rank = place(words);
    if (rank) --*rank;
    return rank;
  };
  if (query_name == "geometric" || query_name == "geometric_min") return continuity({"none", "g0", "g1", "g2"});
  if (query_name == "parametric" || query_name == "parametric_min") return continuity({"none", "c0", "c1", "c2"});
  if (place(std::array<std::string_view, 4>{"on", "true", "yes", "1"})) return 1;
  if (place(std::array<std::string_view, 4>{"off", "false", "no", "0"})) return 0;
  return std::nullopt;
}

base::Result<world::Entity> entity_of(const Context& context, std::string_view argument, world::Kind kind) {
  const world::Document& document = context.session.document;
  const std::string_view word = argument.starts_with('@') ? argument.substr(1) : argument;
  const auto name = world::parse_name(word);
  if (name && name->kind == kind)
    if (const world::Entity found = world::find(document, *name); found.valid()) return found;
  std::vector<std::string> names;
  for (const world::Name& other : document.entities.pool<world::Name>().items())
    if (other.kind == kind) names.push_back("@" + world::to_text(other));
  const std::string wanted = fmt::format("@{}", word);
  return base::Status{base::Code::usage,
                      fmt::format("no {} {}{}", base::name_of(kind), wanted, base::suggestion(wanted, names))};
}

curve::Joint joint_at(const world::Document& document, world::Entity knot) {
  const world::Neighbours at = world::neighbours(document, knot);
  if (!at.before.valid() || !at.after.valid()) return {.speed_ratio = 1};
  return curve::joint(world::cubic_of(document, at.before), world::cubic_of(document, at.after));
}

}  // namespace coaster::query
