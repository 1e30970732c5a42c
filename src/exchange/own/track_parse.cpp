// Builds a document from a track file's tree. Checks everything that docs/track-format.md promises.
#include <algorithm>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "base/text.h"
#include "base/utf8.h"
#include "exchange/own/force_text.h"
#include "exchange/own/json_fields.h"
#include "exchange/own/section_text.h"
#include "exchange/own/track_file.h"
#include "exchange/own/track_values.h"
#include "sim/shape/roll.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

using world::Document;
using world::Entity;
using world::Kind;

constexpr double kParallel = 1e-6;  // sine of the angle between tangent and up

// Creates the entity of an "id" member, with its name.
bool create(TrackParse& parse, Fields& fields, Kind kind, Entity& e) {
  std::uint32_t number = 0;
  if (!read_id(fields, "id", kind, number)) return false;
  auto& taken = parse.by_number[static_cast<std::size_t>(kind)];
  if (taken.contains(number)) return fields.fail("id", quoted_id(kind, number) + " is already used");
  e = parse.document.entities.create();
  parse.document.entities.put(e, world::Name{kind, number});
  taken.emplace(number, e);
  std::uint32_t& last = parse.document.last_number[static_cast<std::size_t>(kind)];
  last = std::max(last, number);
  return true;
}

void keep_unknown(TrackParse& parse, const Fields& fields, Entity e) {
  std::string extra = fields.unknown(parse.warnings);
  if (!extra.empty()) parse.document.entities.put(e, world::Extra{std::move(extra)});
}

bool read_knot(TrackParse& parse, const Json& value, std::size_t index) {
  Fields fields(value, {"knots", index}, parse.error);
  Entity e;
  world::Knot knot;
  if (!create(parse, fields, Kind::knot, e) || !read_component(parse, fields, knot)) return false;
  if (glm::length(glm::cross(glm::dvec3(knot.tangent), glm::dvec3(knot.up))) < kParallel)
    return fields.fail("up", "expected a vector that is not parallel to the tangent");
  world::orthonormalise(knot);
  if (knot.joint == world::JointKind::smooth && knot.in_length != knot.out_length)
    return fields.fail("joint", fmt::format("a smooth joint has equal handle lengths, found in {} and out {}",
                                            base::to_text(knot.in_length), base::to_text(knot.out_length)));
  parse.document.entities.put(e, knot);
  parse.document.track.knots.push_back(e);
  keep_unknown(parse, fields, e);
  return true;
}

// A segment has a fitting if its first member is present.
template <class T>
bool read_fitting(TrackParse& parse, Fields& fields, Entity segment) {
  std::string_view first;
  T::fields([&](const world::Field& field, auto) {
    if (first.empty()) first = field.name;
  });
  if (!fields.has(first)) return true;
  T fitting;
  if (!read_component(parse, fields, fitting)) return false;
  parse.document.entities.put(segment, fitting);
  return true;
}

bool read_segment(TrackParse& parse, const Json& value, std::size_t index) {
  Fields fields(value, {"segments", index}, parse.error);
  const auto& knots = parse.document.track.knots;
  world::Segment segment{knots[index], knots[(index + 1) % knots.size()], 0, {}};
  Entity e;
  if (!create(parse, fields, Kind::segment, e)) return false;
  for (const auto& [member, knot] : {std::pair{"from", segment.from}, std::pair{"to", segment.to}}) {
    std::uint32_t number = 0;
    const std::uint32_t expected = world::name_of(parse.document, knot).number;
    if (!read_id(fields, member, Kind::knot, number)) return false;
    if (number != expected)
      return fields.reject(member, quoted_id(Kind::knot, expected) + " (segments follow the order of the knots)");
  }
  if (!read_component(parse, fields, segment)) return false;
  bool good = true;
  world::Fittings::for_each([&]<class T>() { good = good && read_fitting<T>(parse, fields, e); });
  if (!good) return false;
  parse.document.entities.put(e, segment);
  parse.document.track.segments.push_back(e);
  keep_unknown(parse, fields, e);
  return true;
}

// Reads the section of the segments from index `first` on, and moves `first` beyond them.
bool read_section(TrackParse& parse, const Json& value, std::size_t index, std::size_t& first) {
  Fields fields(value, {"sections", index}, parse.error);
  const std::vector<Entity>& segments = parse.document.track.segments;
  Entity e;
  world::Section section;
  std::size_t count = 0;
  if (!create(parse, fields, Kind::section, e)) return false;
  if (!read_section_members(fields, segments.size() - first, section, count)) return false;
  if (section.kind == world::SectionKind::complete && !read_component(parse, fields, section.way)) return false;
  if (section.kind == world::SectionKind::force &&
      !(read_component(parse, fields, section.force) && read_force_keys(fields, section.force)))
    return false;
  for (; count > 0; --count) parse.document.entities.get<world::Segment>(segments[first++]).section = e;
  parse.document.entities.put(e, std::move(section));
  keep_unknown(parse, fields, e);
  return true;
}

// Files before version 3 have no sections: the whole track is one free section.
bool read_sections(TrackParse& parse, Fields& fields) {
  const std::size_t count = parse.document.track.segments.size();
  if (parse.version < 3 && !fields.has("sections"))
    return count == 0 || world::make_section(parse.document, 0, count, {}).valid();
  const Json* const sections = fields.list("sections");
  std::size_t first = 0;
  for (std::size_t i = 0; sections && i < sections->size(); ++i)
    if (!read_section(parse, (*sections)[i], i, first)) return false;
  return sections && (first == count ||
                      fields.fail("sections", fmt::format("expected {} segments in all, found {}", count, first)));
}

bool read_cart(TrackParse& parse, const Json& value, std::size_t index) {
  Fields fields(value, {"carts", index}, parse.error);
  Entity e;
  world::Cart cart;
  if (!create(parse, fields, Kind::cart, e) || !read_component(parse, fields, cart)) return false;
  if (cart.fraction == 1.0) return fields.fail("fraction", "expected a number below 1 (1 is the next segment's 0)");
  parse.document.entities.put(e, cart);
  keep_unknown(parse, fields, e);
  return true;
}

bool read_track_head(TrackParse& parse, Fields& fields) {
  if (!fields.head(kTrackFormat, kTrackVersion, &parse.version)) return false;
  Document& document = parse.document;
  if (!fields.text("name", document.name)) return false;
  if (document.name.size() > world::kMaxNameBytes) {
    document.name = std::string(base::utf8_start(document.name, world::kMaxNameBytes));
    parse.warnings.push_back(fmt::format("name: cut to {} bytes", world::kMaxNameBytes));
  }
  return fields.flag("closed", document.track.closed) && read_component(parse, fields, document);
}

using ReadElement = bool (*)(TrackParse& parse, const Json& value, std::size_t index);

// Reads an element while the file is parsed. Its error is kept until everything before it is known.
bool take(TrackParse& parse, TrackParse::Taken& taken, ReadElement read, const Json& element, std::size_t index) {
  if (index != taken.count || !taken.error.empty()) return false;
  if (read(parse, element, index)) return ++taken.count, true;
  taken.error = std::exchange(parse.error, {});
  return false;
}

// Takes knots, and segments if they come after all knots.
bool take_element(TrackParse& parse, const Json& root, std::string_view list, std::size_t index, const Json& element) {
  if (list == "knots" && index < world::kMaxKnots) return take(parse, parse.knots, read_knot, element, index);
  if (list != "segments" || index >= parse.knots.count) return false;
  const auto knots = root.find("knots");
  return knots != root.end() && knots->is_array() && knots->size() == parse.knots.count &&
         take(parse, parse.segments, read_segment, element, index);
}

// Reads the elements that were not taken while the file was parsed.
bool read_rest(TrackParse& parse, const Json& list, const TrackParse::Taken& taken, ReadElement read) {
  if (parse.error = taken.error; !parse.error.empty()) return false;
  for (std::size_t i = taken.count; i < list.size(); ++i)
    if (!read(parse, list[i], i)) return false;
  return true;
}

bool read_lists(TrackParse& parse, Fields& fields) {
  const Json *const knots = fields.list("knots", world::kMaxKnots), *const segments = fields.list("segments"),
                    *const carts = fields.list("carts", world::kMaxCarts);
  if (!knots || !segments || !carts) return false;
  const bool closed = parse.document.track.closed;
  if (closed && knots->size() < 2) return fields.fail("closed", "a closed track has at least 2 knots");
  const std::size_t expected = closed ? knots->size() : knots->empty() ? 0 : knots->size() - 1;
  if (!read_rest(parse, *knots, parse.knots, read_knot)) return false;
  if (segments->size() != expected)
    return fields.reject("segments", fmt::format("{} for {}{}", expected, knots->size(),
                                                 closed ? " knots of a closed track" : " knots of an open track"));
  if (!read_rest(parse, *segments, parse.segments, read_segment)) return false;
  if (!read_sections(parse, fields)) return false;
  for (std::size_t i = 0; i < carts->size(); ++i)
    if (!read_cart(parse, (*carts)[i], i)) return false;
  parse.document.extra.json = fields.unknown(parse.warnings);
  return true;
}

// Shortens the warnings: a foreign file may have an unknown member on every knot.
void shorten(std::vector<std::string>& warnings) {
  constexpr std::size_t kMost = 20;
  if (warnings.size() <= kMost) return;
  const std::size_t left_out = warnings.size() - kMost;
  warnings.resize(kMost);
  warnings.push_back(fmt::format("and {} more unknown members are kept", left_out));
}

}  // namespace

base::Result<LoadedTrack> parse_track(std::string_view text, std::string_view name) {
  TrackParse parse;
  const base::Result<Json> tree = read_json(text, name, std::bind_front(take_element, std::ref(parse)));
  if (!tree) return tree.status();
  Fields fields(*tree, {}, parse.error);
  if (parse.error.empty() && read_track_head(parse, fields) && read_lists(parse, fields)) {
    world::settle_joints(parse.document);
    if (const auto broken = world::broken_invariant(parse.document)) parse.error = *broken;
  }
  if (!parse.error.empty()) return bad_file(name, parse.error);
  if (parse.version < 2) sim::set_automatic_spins(parse.document);
  shorten(parse.warnings);
  for (std::string& warning : parse.warnings) warning = fmt::format("{}: warning: {}", name, warning);
  LoadedTrack track{std::move(parse.document), std::move(parse.warnings), {}, {}};
  track.version = parse.version;
  return track;
}

std::string name_of_file(std::string_view path) {
  const std::string printable = base::printable_utf8(std::filesystem::path(path).stem().string());
  return std::string(base::utf8_start(printable, world::kMaxNameBytes));
}

}  // namespace coaster::exchange
