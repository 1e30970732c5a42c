// Prints a document as a track file. The same document always gives the same bytes.
#include <algorithm>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/own/json_reader.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {
namespace {

using world::Document;
using world::Entity;

// -0 is read back as the whole number 0, so it is written as 0; else printing twice would differ.
std::string number(double value) { return value == 0 ? "0" : base::to_text(value); }

// Readers parse to double. If rounding twice would miss the float, its exact value in double is written.
std::string number(float value) {
  if (value == 0) return "0";
  std::string text = base::to_text(value);
  const auto wide = base::parse_double(text);
  return wide && static_cast<float>(*wide) == value ? text : base::to_text(static_cast<double>(value));
}

std::string vector(glm::vec3 v) { return fmt::format("[{}, {}, {}]", number(v.x), number(v.y), number(v.z)); }

std::string id(const Document& document, Entity e) { return json_string(world::label_of(document, e)); }

// Calls write(key, value text) for each unknown member that was kept.
template <class Write>
void for_each_extra(const world::Extra& extra, Write write) {
  if (extra.json.empty()) return;
  const auto tree = read_json(extra.json, "extra");
  COASTER_CHECK(tree && tree->is_object(), "kept members are the text of a JSON object");
  for (const auto& [key, value] : tree->items()) write(json_string(key), json_line(value));
}

std::string extra_members(const Document& document, Entity e) {
  std::string text;
  if (const auto* const extra = document.entities.find<world::Extra>(e))
    for_each_extra(
        *extra, [&](const std::string& key, const std::string& value) { text += fmt::format(", {}: {}", key, value); });
  return text + "}";
}

std::string knot_line(const Document& document, Entity e) {
  const world::Knot& k = world::knot(document, e);
  return "{\"id\": " + id(document, e) + ", \"position\": " + vector(k.position) +
         ", \"tangent\": " + vector(k.tangent) + ", \"up\": " + vector(k.up) + ", \"in\": " + number(k.in_length) +
         ", \"out\": " + number(k.out_length) + ", \"joint\": \"" + std::string(base::name_of(k.joint)) + "\"" +
         extra_members(document, e);
}

// Leaves out members that have the defaults of a plain segment, cart or track.
std::string equipment_members(const Document& document, Entity e) {
  const auto* const found = document.entities.find<world::Equipment>(e);
  if (!found) return {};
  std::string text = fmt::format(", \"equipment\": \"{}\", \"speed\": {}, \"acceleration\": {}",
                                 base::name_of(found->kind), number(found->speed), number(found->acceleration));
  const world::Equipment plain;
  if (found->hysteresis != plain.hysteresis) text += ", \"hysteresis\": " + number(found->hysteresis);
  if (found->seconds != plain.seconds) text += ", \"seconds\": " + number(found->seconds);
  return text;
}

std::string train_members(const world::Cart& cart) {
  const world::Cart plain;
  std::string text;
  if (cart.cars != plain.cars) text += fmt::format(", \"cars\": {}", cart.cars);
  if (cart.spacing != plain.spacing) text += ", \"spacing\": " + number(cart.spacing);
  if (cart.length != plain.length) text += ", \"length\": " + number(cart.length);
  if (cart.mass != plain.mass) text += ", \"mass\": " + number(cart.mass);
  return text;
}

std::string operation_members(const Document& document) {
  const Document plain;
  std::string text;
  if (document.resistance.rolling != plain.resistance.rolling)
    text += ",\n  \"rolling\": " + number(document.resistance.rolling);
  if (document.resistance.drag != plain.resistance.drag) text += ",\n  \"drag\": " + number(document.resistance.drag);
  if (document.heartline != plain.heartline) text += ",\n  \"heartline\": " + number(document.heartline);
  if (document.rollback_fails != plain.rollback_fails) text += ",\n  \"rollback_fails\": false";
  return text;
}

std::string segment_line(const Document& document, Entity e) {
  const world::Segment& s = world::segment(document, e);
  return "{\"id\": " + id(document, e) + ", \"from\": " + id(document, s.from) + ", \"to\": " + id(document, s.to) +
         ", \"turns\": " + std::to_string(s.turns) + equipment_members(document, e) + extra_members(document, e);
}

std::string cart_line(const Document& document, Entity e) {
  const world::Cart& c = document.entities.get<world::Cart>(e);
  return "{\"id\": " + id(document, e) + ", \"segment\": " + id(document, c.segment) +
         ", \"fraction\": " + number(c.fraction) + train_members(c) + extra_members(document, e);
}

// ,\n  "key": [ one line each ]
template <class Line>
void print_list(std::string& out, std::string_view key, const Document& document, const std::vector<Entity>& entities,
                Line line) {
  out += fmt::format(",\n  \"{}\": [", key);
  for (std::size_t i = 0; i < entities.size(); ++i)
    out += (i == 0 ? "\n    " : ",\n    ") + line(document, entities[i]);
  out += entities.empty() ? "]" : "\n  ]";
}

}  // namespace

std::string print_track(const Document& document) {
  std::string out =
      "{\n  \"format\": \"" + std::string(kTrackFormat) + "\",\n  \"version\": " + std::to_string(kTrackVersion);
  out += ",\n  \"name\": " + json_string(document.name);
  out += std::string(",\n  \"closed\": ") + (document.track.closed ? "true" : "false");
  out += ",\n  \"start_speed\": " + number(document.start_speed);
  out += ",\n  \"datum\": " + number(document.datum);
  out += operation_members(document);
  print_list(out, "knots", document, document.track.knots, knot_line);
  print_list(out, "segments", document, document.track.segments, segment_line);
  std::vector<Entity> carts = document.entities.pool<world::Cart>().entities();
  std::sort(carts.begin(), carts.end(),
            [&](Entity a, Entity b) { return world::name_of(document, a) < world::name_of(document, b); });
  print_list(out, "carts", document, carts, cart_line);
  for_each_extra(document.extra, [&](const std::string& key, const std::string& value) {
    out += fmt::format(",\n  {}: {}", key, value);
  });
  return out + "\n}\n";
}

}  // namespace coaster::exchange
