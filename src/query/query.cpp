// Joins the parts of the table and looks names up.
#include "query/query.h"

#include <algorithm>

#include "query/rows.h"

namespace coaster::query {

std::string to_text(const Value& value) {
  struct Visitor {
    std::string operator()(double v) const { return base::to_text(v); }
    std::string operator()(const std::string& v) const { return v; }
    std::string operator()(const Ranked& v) const { return v.text; }
    std::string operator()(glm::dvec3 v) const { return base::to_text(v.x) + " " + base::to_text(v.y) + " " + base::to_text(v.z); }
  };
  return std::visit(Visitor{}, value);
}

std::span<const Query> queries() {
  static const std::vector<Query> table = [] {
    std::vector<Query> rows;
    for (const std::span<const Query> part : {document_rows(), ride_rows(), session_rows()}) rows.insert(rows.end(), part.begin(), part.end());
    return rows;
  }();
  return table;
}

const Query* find_query(std::string_view name) {
  const std::span<const Query> all = queries();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Query& query) { return query.name == name; });
  return found == all.end() ? nullptr : &*found;
}

base::Result<world::Entity> entity_of(const Context& context, std::string_view argument, world::Kind kind) {
  const world::Document& document = context.session.document;
  const std::string_view word = argument.starts_with('@') ? argument.substr(1) : argument;
  const auto name = world::parse_name(word);
  if (name && name->kind == kind)
    if (const world::Entity found = world::find(document, *name); found.valid()) return found;
  constexpr std::string_view kKinds[] = {"knot", "segment", "cart"};
  std::vector<std::string> names;
  for (const world::Name& other : document.entities.pool<world::Name>().items())
    if (other.kind == kind) names.push_back("@" + world::to_text(other));
  const std::string wanted = "@" + std::string(word);
  return base::Status{base::Code::usage, "no " + std::string(kKinds[static_cast<std::size_t>(kind)]) + " " + wanted + base::suggestion(wanted, names)};
}

}  // namespace coaster::query
