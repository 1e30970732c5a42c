// The values of all queries as JSON.
#include "query/all_values.h"

#include <array>

#include <fmt/format.h>

#include "query/context.h"

namespace coaster::query {
namespace {

exchange::JsonValue to_json(const Value& value) {
  struct Visitor {
    exchange::JsonValue operator()(double v) const { return v; }
    exchange::JsonValue operator()(const std::string& v) const { return v; }
    exchange::JsonValue operator()(const Ranked& v) const { return v.text; }
    exchange::JsonValue operator()(glm::dvec3 v) const { return std::array{v.x, v.y, v.z}; }
    exchange::JsonValue operator()(const NoValue&) const { return nullptr; }
  };
  return std::visit(Visitor{}, value);
}

// Returns the arguments of one part: words, knots, segments and trains.
std::vector<std::string> arguments_of(Argument argument, const world::Document& document) {
  if (argument.size() > 1) return {};
  const ArgumentPart& part = argument.front();
  std::vector<std::string> names;
  if (part.words) names = part.words();
  for (int i = 1; i <= part.most; ++i) names.push_back(std::to_string(i));
  const auto add = [&](world::EntityKind kind, const std::vector<world::Entity>& entities) {
    if (part.kind != kind) return;
    for (const world::Entity e : entities) names.push_back("@" + world::label_of(document, e));
  };
  add(world::EntityKind::knot, document.track.knots);
  add(world::EntityKind::segment, document.track.segments);
  add(world::EntityKind::cart, document.entities.pool<world::Train>().entities());
  return names;
}

}  // namespace

exchange::JsonMembers all_values(const QueryContext& context) {
  constexpr std::size_t kMostKnots = 1000;
  exchange::JsonMembers all;
  for (const Query& query : queries()) {
    const std::string name(query.name);
    if (query.argument.empty()) {
      const auto value = query.evaluate(context, "");
      all.emplace_back(name, value ? to_json(*value) : nullptr);
      continue;
    }
    if (context.session.document.track.knots.size() > kMostKnots) continue;
    for (const std::string& argument : arguments_of(query.argument, context.session.document))
      if (const auto value = query.evaluate(context, argument))
        all.emplace_back(fmt::format("{} {}", name, argument), to_json(*value));
  }
  return all;
}

}  // namespace coaster::query
