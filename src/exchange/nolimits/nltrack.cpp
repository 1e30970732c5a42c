// Reads the chunks and numbers of a NoLimits 1 track file, and makes a document of them.
#include "exchange/nolimits/nltrack.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/glm.hpp>

#include "base/portable_math.h"
#include "base/status.h"
#include "base/text.h"
#include "curve/frames.h"
#include "sim/fit/fit_track.h"
#include "sim/shape/roll.h"
#include "world/components.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

struct NltrackKnot {
  glm::vec3 point, in, out;  // m: the knot, the ends of its handles
  float roll = 0;            // radians, within 10,000 turns; positive to the left in the file
  std::size_t number = 0;    // in the file, from 1
  std::size_t offset = 0;    // byte of the record in the file
};

struct NltrackRecords {
  std::vector<NltrackKnot> knots;
  bool closed = false;
};

constexpr std::size_t kTagBytes = 4, kHeadBytes = 8;  // a chunk's tag and size
constexpr std::size_t kVerticesHead = 20;             // 16 bytes and the count
constexpr std::size_t kRecordBytes = 60;
constexpr std::size_t kSegmentsHead = 5;  // the count and the closed byte

struct ChunkReader {
  std::string_view bytes;
  std::string name;

  base::Status fail(std::size_t offset, const std::string& message) const {
    return {base::Code::bad_file, fmt::format("{}: error: at byte {}: {}", name, offset, message)};
  }
  std::uint32_t whole(std::size_t at) const {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value = value << 8 | static_cast<unsigned char>(bytes[at + i]);
    return value;
  }
  float number(std::size_t at) const { return std::bit_cast<float>(whole(at)); }
};

struct Chunk {
  std::size_t start = 0, payload = 0, size = 0;
  std::size_t end() const { return payload + size; }
};

// Returns the first chunk with that tag at or after `from` that lies within the file and has at least `least` bytes.
// Earlier bytes may contain the tag as text: then the next one counts, and the first one's error is reported if there
// is none.
base::Result<Chunk> find_chunk(const ChunkReader& reader, std::string_view tag, std::size_t from, std::size_t least) {
  base::Status fault =
      reader.fail(from, fmt::format("expected a chunk \"{}\", found none to the end of the file", tag));
  bool found = false;
  for (std::size_t at = reader.bytes.find(tag, from); at != std::string_view::npos;
       at = reader.bytes.find(tag, at + 1)) {
    const std::size_t left = reader.bytes.size() - at;
    base::Status wrong;
    if (left < kHeadBytes) {
      wrong = reader.fail(at, fmt::format("the file ends within the head of chunk \"{}\"", tag));
    } else {
      const Chunk chunk{at, at + kHeadBytes, reader.whole(at + kTagBytes)};
      if (chunk.size > left - kHeadBytes)
        wrong = reader.fail(at + kTagBytes, fmt::format("chunk \"{}\" has {} bytes, but the file {} more", tag,
                                                        chunk.size, left - kHeadBytes));
      else if (chunk.size < least)
        wrong = reader.fail(at + kTagBytes, fmt::format("expected a chunk \"{}\" of at least {} bytes, found {}", tag,
                                                        least, chunk.size));
      else return chunk;
    }
    if (!found) fault = std::move(wrong);
    found = true;
  }
  return fault;
}

// Returns the position of the closed byte. Chunk SEGM has a size before its count of segments, which some writers omit:
// the count, which is that of `knots` or one less, shows which it is. If it is neither, the chunk is read by its size.
base::Result<std::size_t> closed_byte(const ChunkReader& reader, std::size_t from, std::size_t knots) {
  const auto counts = [&](std::size_t at) { return reader.whole(at) == knots || reader.whole(at) + 1 == knots; };
  for (std::size_t at = reader.bytes.find("SEGM", from); at != std::string_view::npos;
       at = reader.bytes.find("SEGM", at + 1)) {
    const std::size_t left = reader.bytes.size() - at;
    if (left >= kHeadBytes + kSegmentsHead && counts(at + kHeadBytes)) break;
    if (left >= kTagBytes + kSegmentsHead && counts(at + kTagBytes)) return at + kHeadBytes;
  }
  const auto chunk = find_chunk(reader, "SEGM", from, kSegmentsHead);
  if (!chunk) return chunk.status();
  return chunk->payload + 4;
}

std::string number_or_none(float value) { return std::isfinite(value) ? base::to_text(value) : "no finite number"; }

base::Result<glm::vec3> read_point(const ChunkReader& reader, std::size_t at, const char* what) {
  glm::vec3 value(0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t place = at + 4u * static_cast<std::size_t>(axis);
    value[axis] = reader.number(place);
    if (!(std::abs(value[axis]) <= world::kMaxCoordinate))
      return reader.fail(place, fmt::format("expected a coordinate of the {} within {} m, found {}", what,
                                            base::to_text(world::kMaxCoordinate), number_or_none(value[axis])));
  }
  return value;
}

base::Result<std::vector<NltrackKnot>> read_records(const ChunkReader& reader, const Chunk& chunk) {
  const std::size_t count = reader.whole(chunk.payload + 16), room = (chunk.size - kVerticesHead) / kRecordBytes;
  if (count > room || count > world::kMaxKnots)
    return reader.fail(chunk.payload + 16,
                       fmt::format("expected at most {} knots, found {}", std::min(room, world::kMaxKnots), count));
  if (count < 2) return reader.fail(chunk.payload + 16, fmt::format("expected at least 2 knots, found {}", count));
  std::vector<NltrackKnot> records;
  records.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    NltrackKnot record;
    record.number = i + 1;
    record.offset = chunk.payload + kVerticesHead + i * kRecordBytes;
    const std::pair<glm::vec3*, const char*> points[]{
        {&record.point, "point"}, {&record.in, "in-handle"}, {&record.out, "out-handle"}};
    std::size_t at = record.offset;
    for (const auto& [point, what] : points) {
      const auto value = read_point(reader, at, what);
      if (!value) return value.status();
      *point = *value;
      at += 12;
    }
    record.roll = reader.number(at);
    constexpr double kMostRoll = 2.0 * base::kPi * 1e4;
    if (!(std::abs(record.roll) <= kMostRoll))
      return reader.fail(
          at, fmt::format("expected a roll in radians within 10000 turns, found {}", number_or_none(record.roll)));
    records.push_back(record);
  }
  return records;
}

// Returns the knots of chunk BEZR and the closed byte of chunk SEGM. Code::bad_file with the byte and the reason for
// chunks that are missing or cut off, coordinates beyond world::kMaxCoordinate, fewer than 2 knots, and more than
// world::kMaxKnots.
base::Result<NltrackRecords> read_nltrack(const ChunkReader& reader) {
  const auto vertices = find_chunk(reader, "BEZR", 0, kVerticesHead);
  if (!vertices) return vertices.status();
  auto knots = read_records(reader, *vertices);
  if (!knots) return knots.status();
  const auto place = closed_byte(reader, vertices->end(), knots->size());
  if (!place) return place.status();
  const auto mark = static_cast<unsigned char>(reader.bytes[*place]);
  if (mark != 0 && mark != 0xff)
    return reader.fail(*place, fmt::format("expected the closed byte 0 or 255, found {}", mark));
  return NltrackRecords{std::move(*knots), mark == 0xff};
}

using glm::dvec3;
constexpr double kWorthATell = base::radians(0.1);  // larger turns between handles are reported
constexpr double kCorner = base::radians(90.0);     // larger turns are rejected
constexpr double kRollSign = -1.0;   // roll is positive to the left in the file, to the right in the document
constexpr double kSteepSlope = 0.9;  // sine of the slope above which the horizon does not define roll well
constexpr float kOneKnot = 1e-3f;    // m: closer knots are one
constexpr int kHorizonSteps = 64;    // per segment, to follow the horizon's rotation relative to the frame

// Changes that were needed to fit a document.
struct KnotAdjustments {
  std::size_t lengthened = 0, straightened = 0, repeated = 0;
  double largest_turn = 0;                          // rad
  std::size_t turned_most = 0, repeated_first = 0;  // numbers of knots in the file, counted from 1
};

// Makes one of neighbouring knots at the same place, with the in-handle of the first and the out-handle of the last:
// between them the track would lead out and back. On a closed track the last knot may repeat the first.
std::vector<NltrackKnot> without_repeats(const std::vector<NltrackKnot>& all, bool closed, KnotAdjustments& changes) {
  const auto same = [](const NltrackKnot& a, const NltrackKnot& b) {
    return glm::distance(a.point, b.point) < kOneKnot;
  };
  const auto told = [&](std::size_t i) {
    if (changes.repeated++ == 0) changes.repeated_first = i + 1;
  };
  std::vector<NltrackKnot> kept;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (kept.empty() || !same(kept.back(), all[i])) kept.push_back(all[i]);
    else kept.back().out = all[i].out, told(i);
  if (closed && kept.size() > 2 && same(kept.back(), kept.front()))
    kept.front().in = kept.back().in, kept.pop_back(), told(all.size() - 1);
  return kept;
}

// Returns the direction of travel if both handles have zero length: towards the next control points.
dvec3 between_neighbours(const std::vector<NltrackKnot>& records, std::size_t i, bool closed) {
  const std::size_t count = records.size();
  const dvec3 here(records[i].point);
  const dvec3 before = i > 0 || closed ? dvec3(records[(i + count - 1) % count].out) : here;
  const dvec3 after = i + 1 < count || closed ? dvec3(records[(i + 1) % count].in) : here;
  return after - before;
}

base::Result<world::Knot> make_knot(const ChunkReader& reader, const std::vector<NltrackKnot>& records, std::size_t i,
                                    bool closed, KnotAdjustments& changes) {
  const NltrackKnot& r = records[i];
  const bool comes = i > 0 || closed, goes = i + 1 < records.size() || closed;  // whether a segment uses the handle
  dvec3 in = dvec3(r.point) - dvec3(r.in), out = dvec3(r.out) - dvec3(r.point);
  if (!comes && goes && glm::length(out) > 0) in = out * (glm::length(in) / glm::length(out));  // unused: ignore it
  if (comes && !goes && glm::length(in) > 0) out = in * (glm::length(out) / glm::length(in));
  const double a = glm::length(in), b = glm::length(out);
  dvec3 direction = a + b > 0 ? in + out : between_neighbours(records, i, closed);
  if (!(glm::length(direction) > 0))
    return reader.fail(r.offset,
                       fmt::format("knot {} has no direction: its handles cancel out or have no length", r.number));
  if (a > 0 && b > 0) {
    const double turn = base::arc_tangent(glm::length(glm::cross(in, out)), glm::dot(in, out));
    if (turn > kCorner)
      return reader.fail(r.offset, fmt::format("knot {} is a corner of {} degrees", r.number,
                                               base::to_text(static_cast<float>(base::degrees(turn)))));
    if (turn > kWorthATell) ++changes.straightened;
    if (turn > std::max(kWorthATell, changes.largest_turn)) changes.largest_turn = turn, changes.turned_most = r.number;
  }
  world::Knot knot;
  knot.joint = world::JointKind::aligned;
  knot.position = r.point;
  knot.tangent = glm::vec3(glm::normalize(direction));
  for (const auto& [length, stored, used] : {std::tuple{a, &knot.in_length, comes}, {b, &knot.out_length, goes}}) {
    if (length > world::kMaxHandle)
      return reader.fail(r.offset,
                         fmt::format("knot {} has a handle of {} m, over the limit of {}", r.number,
                                     base::to_text(static_cast<float>(length)), base::to_text(world::kMaxHandle)));
    *stored = std::max(static_cast<float>(length), world::kMinHandle);
    if (used && length < world::kMinHandle) ++changes.lengthened;
  }
  world::orthonormalise(knot);
  world::set_roll(knot, kRollSign * base::degrees(double{r.roll}));
  return knot;
}

struct Twist {
  double least = 0;  // rad in (-pi, pi], from the carried frame to the second knot's up
  double whole = 0;  // the same plus whole turns, as in the file
};

// Returns the rotation of the horizon relative to the rotation-minimising frame, plus the track's roll relative to the
// horizon. On steep track the horizon turns over in a direction that depends on small inclinations and that no file
// states: for each steep part the direction that brings the sum closer to 0 is used.
Twist twist_of(const curve::Cubic& cubic, glm::vec3 up_from, glm::vec3 up_to, double rolled) {
  const dvec3 up(0, 1, 0), start = curve::unit_tangent(cubic, 0);
  curve::Frame carried{start, curve::perpendicular(start, dvec3(up_from))},
      horizon{start, curve::perpendicular(start, up)};
  Twist twist{0, rolled};
  std::vector<double> stretches;  // rotation of the horizon over each
  bool was_steep = false;
  dvec3 at = curve::point(cubic, 0);
  for (int i = 1; i <= kHorizonSteps; ++i) {
    const double t = static_cast<double>(i) / kHorizonSteps;
    const dvec3 next = curve::point(cubic, t), forward = curve::unit_tangent(cubic, t);
    const bool steep = std::abs(forward.y) > kSteepSlope || std::abs(carried.forward.y) > kSteepSlope;
    carried = curve::transport(carried, at, next, forward);
    const dvec3 before = curve::transport(horizon, at, next, forward).up;
    horizon = {forward, curve::perpendicular(forward, up)};
    const double step = curve::signed_angle(before, horizon.up, forward);
    if (steep && !was_steep) stretches.push_back(0);
    (steep ? stretches.back() : twist.whole) += step;
    was_steep = steep;
    at = next;
  }
  for (const double turned : stretches) {
    const double least = std::remainder(turned, 2 * base::kPi), other = least - std::copysign(2 * base::kPi, least);
    twist.whole += std::abs(twist.whole + least) <= std::abs(twist.whole + other) ? least : other;
  }
  twist.least = curve::signed_angle(carried.up, curve::perpendicular(carried.forward, dvec3(up_to)), carried.forward);
  return twist;
}

// Sets the whole turns that the smallest twist between the knots' `up` omits.
base::Status set_turns(const ChunkReader& reader, world::Document& document, std::size_t i,
                       const std::vector<NltrackKnot>& records) {
  const NltrackKnot &from = records[i], &to = records[(i + 1) % records.size()];
  const world::Entity e = document.track.segments[i];
  world::Segment& segment = document.entities.get<world::Segment>(e);
  const curve::Cubic cubic = world::cubic_of(document, e);
  // Back at the first knot the roll may differ by whole turns: that joint gets the smallest turn.
  double rolled = kRollSign * (double{to.roll} - double{from.roll});
  if (i + 1 == records.size()) rolled = std::remainder(rolled, 2 * base::kPi);
  const Twist twist =
      twist_of(cubic, world::knot(document, segment.from).up, world::knot(document, segment.to).up, rolled);
  const double turns = std::round((twist.whole - twist.least) / (2 * base::kPi));
  if (std::abs(turns) > world::kMaxTurns)
    return reader.fail(to.offset + 36, fmt::format("the roll goes over {} turns from the knot before, the limit is {}",
                                                   base::to_text(turns), world::kMaxTurns));
  segment.turns = static_cast<std::int32_t>(turns);
  return {};
}

// Returns how far the document's curve is from the file's, at 17 places of each segment, and its directions at knots
// from the file's handles.
ImportReport report_of(const world::Document& document, const std::vector<NltrackKnot>& records) {
  constexpr int kSteps = 16;
  ImportReport report;
  report.knots = static_cast<int>(records.size());
  sim::MeanSquare distances, angles;
  const auto turned = [&](glm::vec3 from, glm::vec3 to, glm::vec3 tangent) {
    const dvec3 handle = dvec3(to) - dvec3(from), direction(tangent);
    if (!(glm::length(handle) > 0)) return;
    const double angle =
        base::degrees(base::arc_tangent(glm::length(glm::cross(handle, direction)), glm::dot(handle, direction)));
    report.frame_error = std::max(report.frame_error, angle);
    angles.add(angle);
  };
  for (std::size_t i = 0; i < document.track.segments.size(); ++i) {
    const NltrackKnot &from = records[i], &to = records[(i + 1) % records.size()];
    const world::Entity e = document.track.segments[i];
    const auto& segment = document.entities.get<world::Segment>(e);
    const curve::Cubic ours = world::cubic_of(document, e), theirs{from.point, from.out, to.in, to.point};
    for (int k = 0; k <= kSteps; ++k) {
      const double t = static_cast<double>(k) / kSteps,
                   distance = glm::distance(curve::point(ours, t), curve::point(theirs, t));
      report.max_error = std::max(report.max_error, distance);
      distances.add(distance);
    }
    turned(from.point, from.out, world::knot(document, segment.from).tangent);
    turned(to.in, to.point, world::knot(document, segment.to).tangent);
  }
  report.rms_error = distances.root(), report.rms_frame_error = angles.root();
  return report;
}

std::vector<std::string> warnings_of(const KnotAdjustments& changes) {
  std::vector<std::string> warnings;
  if (changes.lengthened > 0)
    warnings.push_back(fmt::format("{} handles shorter than {} m were lengthened to it", changes.lengthened,
                                   base::to_text(world::kMinHandle)));
  if (changes.straightened > 0)
    warnings.push_back(fmt::format(
        "{} knots had handles that were not collinear, by up to {} degrees at knot {}; they were straightened",
        changes.straightened, base::to_text(static_cast<float>(base::degrees(changes.largest_turn))),
        changes.turned_most));
  if (changes.repeated > 0)
    warnings.push_back(fmt::format("{} knots repeat the place of the one before, the first is knot {}; left out",
                                   changes.repeated, changes.repeated_first));
  return warnings;
}

}  // namespace

base::Result<LoadedTrack> parse_nltrack(std::string_view bytes, std::string_view name) {
  const ChunkReader reader{bytes, std::string(name)};
  const auto file = read_nltrack(reader);
  if (!file) return file.status();
  const bool closed = file->closed;
  KnotAdjustments changes;
  const std::vector<NltrackKnot> records = without_repeats(file->knots, closed, changes);
  if (records.size() < 2) return reader.fail(records[0].offset, "expected knots at different places, found one");

  LoadedTrack track;
  world::Document& document = track.document;
  document.name = name_of_file(name);
  for (std::size_t i = 0; i < records.size(); ++i) {
    const auto knot = make_knot(reader, records, i, closed, changes);
    if (!knot) return knot.status();
    world::append_knot(document, *knot);
  }
  if (closed) world::set_closed(document, true);
  for (std::size_t i = 0; i < document.track.segments.size(); ++i)
    if (const base::Status status = set_turns(reader, document, i, records); !status) return status;
  sim::set_automatic_spins(document);
  if (const auto broken = world::broken_invariant(document))
    return base::Status{base::Code::bad_file, fmt::format("{}: error: {}", name, *broken)};
  track.warnings = warnings_of(changes);
  track.import = report_of(document, records);
  return track;
}

}  // namespace coaster::exchange
