// Joins the parts of the table and looks up names.
#include "query/query.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "base/units.h"
#include "query/context.h"
#include "query/rows.h"

namespace coaster::query {
namespace {

// --- Arguments of queries

std::vector<std::string> words_of(const ArgumentPart& part) {
  return part.words ? part.words() : std::vector<std::string>();
}

// Returns what the part accepts: "a knot such as @k3", "document or motion", "1 to 3".
std::string expected(const ArgumentPart& part) {
  if (part.kind) return fmt::format("a {} such as @{}", base::name_of(*part.kind), world::to_text({*part.kind, 3}));
  if (part.number) return fmt::format("a number ({})", part.usage);
  if (!part.words && part.most == 0) return std::string(part.usage);
  const std::string range = fmt::format("1 to {}", part.most);
  if (!part.words) return range;
  std::vector<std::string> all = part.words();
  if (part.most > 0) all.push_back(range);
  return base::alternatives(all);
}

bool accepts(const ArgumentPart& part, std::string_view word) {
  if (part.kind) {
    const auto name = world::parse_name(word.starts_with('@') ? word.substr(1) : word);
    return name && name->kind == *part.kind;
  }
  if (part.number) return base::parse_double(word).has_value();
  if (!part.words && part.most == 0) return !word.empty();
  const auto whole = base::parse_int(word);
  if (whole && *whole >= 1 && *whole <= part.most) return true;
  const std::vector<std::string> words = words_of(part);
  return std::find(words.begin(), words.end(), word) != words.end();
}

// --- The values of all queries as JSON

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

std::string usage_of(Argument argument) {
  std::string text;
  for (const ArgumentPart& part : argument) {
    std::string own(part.usage);
    if (part.before != 0) own.insert(own.begin(), part.before);
    if (part.usage.empty())
      for (const std::string& word : words_of(part)) own += (own.empty() ? "" : "|") + word;
    text += part.optional ? fmt::format("[{}]", own) : own;
  }
  return text;
}

std::optional<base::TextError> wrong_argument(Argument argument, std::string_view word) {
  std::string_view rest = word;
  for (std::size_t i = 0; i < argument.size(); ++i) {
    const ArgumentPart& part = argument[i];
    if (i > 0) {
      if (rest.empty() && part.optional) return std::nullopt;
      if (rest.empty())
        return base::TextError{1, fmt::format("expected {}, found {}", usage_of(argument), base::quoted_start(word))};
      rest.remove_prefix(1);
    }
    const std::size_t end =
        i + 1 < argument.size() ? std::min(rest.find(argument[i + 1].before), rest.size()) : rest.size();
    const std::string_view own = rest.substr(0, end);
    if (!accepts(part, own)) {
      const std::string hint = base::suggestion(own, words_of(part));
      return base::TextError{1 + static_cast<int>(word.size() - rest.size()),
                             fmt::format("expected {}, found {}{}", expected(part), base::quoted_start(own), hint),
                             !part.kind && base::is_number(own), !hint.empty()};
    }
    rest.remove_prefix(end);
  }
  return std::nullopt;
}

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
    std::string operator()(const NoValue&) const { return "none"; }
  };
  return std::visit(Visitor{}, value);
}

std::string Query::words(const Value& value) const {
  const auto* const number = std::get_if<double>(&value);
  const bool over = number != nullptr && std::abs(*number) >= base::figure_limit(unit);
  return over ? base::figure_text(*number, 0, unit) : to_text(value);
}

base::Result<Value> Query::evaluate(const QueryContext& context, std::string_view word) const {
  if (const auto wrong = wrong_argument(argument, word)) return base::Status{base::Code::usage, wrong->message};
  base::Result<Value> value = row(context, word);
  auto* const number = value ? std::get_if<double>(&*value) : nullptr;
  constexpr double kMost = std::numeric_limits<double>::max();
  if (number != nullptr && std::isfinite(base::figure_limit(unit))) *number = std::clamp(*number, -kMost, kMost);
  const auto* const vector = value ? std::get_if<glm::dvec3>(&*value) : nullptr;
  const bool finite = number ? std::isfinite(*number) : !vector || std::isfinite(vector->x + vector->y + vector->z);
  return finite ? value : none("it is not finite");
}

std::span<const Query> queries() {
  static const std::vector<Query> table = [] {
    std::vector<Query> rows;
    for (const std::span<const Query> part :
         {document_rows(), section_rows(), park_rows(), ride_rows(), simulated_rows(), rider_rows(), session_rows(),
          setting_rows(), joint_rows(), lab_rows(), element_rows(), force_rows(), game_rows(), draw_rows(),
          frame_rows(), evaluation_rows()})
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

std::optional<int> rank_of(const Query& query, std::string_view word) {
  const std::optional<bool> on = word == "1" ? true : word == "0" ? std::optional(false) : base::parse_switch(word);
  const std::string wanted = base::lower(on ? (*on ? "on" : "off") : word);
  const std::vector<std::string> words = query.values.words();
  const auto found = std::find_if(words.begin(), words.end(), [&](const auto& w) { return base::lower(w) == wanted; });
  return found == words.end() ? std::nullopt : std::optional(static_cast<int>(found - words.begin()));
}

// A parameter has the same choices in each element that has it.
ArgumentValueDomain values_with(const Query& query, std::string_view argument) {
  const ValueDomain& all = query.values;
  if (all.type != ValueType::parameter) return {all.type, all.words ? all.words() : std::vector<std::string>()};
  const std::string_view name = argument.substr(argument.rfind('.') + 1);
  ArgumentValueDomain values;
  for (const world::ElementRow& row : world::rows_of(world::ElementKind{}))
    for (const world::ElementParameter& p : row.parameters)
      if (p.name == name && values.words.empty())
        for (const base::NameRow& choice : p.names) values.words.emplace_back(choice.name);
  if (!values.words.empty()) values.type = ValueType::text;
  return values;
}

std::vector<std::string> on_off() { return {"off", "on"}; }

std::vector<std::string> parameter_names() {
  std::vector<std::string> names;
  for (const world::ElementRow& row : world::rows_of(world::ElementKind{}))
    for (const world::ElementParameter& p : row.parameters)
      if (std::find(names.begin(), names.end(), p.name) == names.end()) names.emplace_back(p.name);
  return names;
}

Value parameter_of(const world::Element& element, std::string_view name) {
  const std::span<const world::ElementParameter> all = base::row_of(element.kind).parameters;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (all[i].name == name)
      return all[i].names.empty() ? number(element.values[i]) : word(world::choice_of(all[i], element.values[i]).name);
  return none("the element has no such parameter");
}

QueryContext context_of(const edit::SessionFindings& find) {
  static const FrameStats kNothingDrawn;
  return {find, kNothingDrawn, {}, {}};
}

base::Result<world::Entity> entity_of(const QueryContext& context, std::string_view argument, world::EntityKind kind) {
  const world::Document& document = context.session.document;
  const std::string_view word = argument.starts_with('@') ? argument.substr(1) : argument;
  const auto name = world::parse_name(word);
  if (name && name->kind == kind)
    if (const world::Entity found = world::find(document, *name); found.valid()) return found;
  std::vector<std::string> names;
  for (const world::EntityName& other : document.entities.pool<world::EntityName>().items())
    if (other.kind == kind) names.push_back("@" + world::to_text(other));
  const std::string wanted = fmt::format("@{}", word);
  return base::Status{base::Code::refused,
                      fmt::format("no {} {}{}", base::name_of(kind), wanted, base::suggestion(wanted, names))};
}

std::optional<curve::JointContinuity> joint_at(const world::Document& document, world::Entity knot) {
  const world::KnotSegments at = world::neighbours(document, knot);
  if (!at.before.valid() || !at.after.valid()) return std::nullopt;
  return curve::joint(world::cubic_of(document, at.before), world::cubic_of(document, at.after));
}

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
