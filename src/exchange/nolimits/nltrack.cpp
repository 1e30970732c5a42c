// Chunks and records of a NoLimits 1 track, checked one by one, to a document.
#include "exchange/nolimits/nltrack.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "curve/frames.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

constexpr std::size_t kTagBytes = 4, kHeadBytes = 8;  // a chunk's tag and size
constexpr std::size_t kVerticesHead = 20;             // 16 bytes and the count
constexpr std::size_t kRecordBytes = 60;
constexpr std::size_t kSegmentsHead = 5;            // the count and the closed byte
constexpr double kWorthATell = base::radians(0.1);  // turn between handles that is told of
constexpr double kCorner = base::radians(90.0);     // more is no track
constexpr double kRollSign = -1.0;                  // the file counts to the left, the document to the right
constexpr double kSteep = 0.9;     // sine of the slope from which on the horizon says little about roll
constexpr int kHorizonSteps = 64;  // of a segment, to follow how the horizon turns against the frame

struct Record {
  glm::vec3 point, in, out;
  float roll = 0;
  std::size_t offset = 0;
};

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

// The first chunk of that tag at or behind `from` that lies within the file and has at least `least` bytes. What lies
// before it is of no interest, and may have the tag in a text: then the next one counts, and the first one's fault is
// told when there is none.
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

// Where the closed byte is. Chunk SEGM has a size before its count of segments, which files of some writers lack: the
// count, which is that of `knots` or one less, tells which it is. Where it is neither, the chunk is taken by its size.
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

base::Result<glm::vec3> read_point(const ChunkReader& reader, std::size_t at, const char* what) {
  glm::vec3 value(0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t place = at + 4u * static_cast<std::size_t>(axis);
    value[axis] = reader.number(place);
    if (!(std::abs(value[axis]) <= world::kMaxCoordinate))
      return reader.fail(place,
                         fmt::format("expected a coordinate of the {} within {} m, found {}", what,
                                     base::to_text(world::kMaxCoordinate),
                                     std::isfinite(value[axis]) ? base::to_text(value[axis]) : "no finite number"));
  }
  return value;
}

base::Result<std::vector<Record>> read_records(const ChunkReader& reader, const Chunk& chunk) {
  const std::size_t count = reader.whole(chunk.payload + 16), room = (chunk.size - kVerticesHead) / kRecordBytes;
  if (count > room || count > world::kMaxKnots)
    return reader.fail(chunk.payload + 16,
                       fmt::format("expected at most {} knots, found {}", std::min(room, world::kMaxKnots), count));
  std::vector<Record> records;
  records.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Record record;
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
          at, "expected a roll in radians within 10000 turns, found " +
                  (std::isfinite(record.roll) ? base::to_text(record.roll) : std::string("no finite number")));
    records.push_back(record);
  }
  return records;
}

// What was changed so that a document can hold it.
struct Changes {
  std::size_t lengthened = 0, straightened = 0;
  double largest_turn = 0;  // rad
};

// The direction of travel where both handles have no length: towards the next control points.
dvec3 between_neighbours(const std::vector<Record>& records, std::size_t i, bool closed) {
  const std::size_t count = records.size();
  const dvec3 here(records[i].point);
  const dvec3 before = i > 0 || closed ? dvec3(records[(i + count - 1) % count].out) : here;
  const dvec3 after = i + 1 < count || closed ? dvec3(records[(i + 1) % count].in) : here;
  return after - before;
}

base::Result<world::Knot> make_knot(const ChunkReader& reader, const std::vector<Record>& records, std::size_t i,
                                    bool closed, Changes& changes) {
  const Record& r = records[i];
  const bool comes = i > 0 || closed, goes = i + 1 < records.size() || closed;  // whether a segment uses the handle
  dvec3 in = dvec3(r.point) - dvec3(r.in), out = dvec3(r.out) - dvec3(r.point);
  if (!comes && goes && glm::length(out) > 0) in = out * (glm::length(in) / glm::length(out));  // unused: it has no say
  if (comes && !goes && glm::length(in) > 0) out = in * (glm::length(out) / glm::length(in));
  const double a = glm::length(in), b = glm::length(out);
  dvec3 direction = a + b > 0 ? in + out : between_neighbours(records, i, closed);
  if (!(glm::length(direction) > 0)) {
    if (records.size() > 1)
      return reader.fail(r.offset,
                         fmt::format("knot {} has no direction: its handles cancel out or have no length", i + 1));
    direction = {1, 0, 0};
  }
  if (a > 0 && b > 0) {
    const double turn = base::arc_tangent(glm::length(glm::cross(in, out)), glm::dot(in, out));
    if (turn > kCorner)
      return reader.fail(r.offset, fmt::format("knot {} is a corner of {} degrees", i + 1,
                                               base::to_text(static_cast<float>(base::degrees(turn)))));
    if (turn > kWorthATell) ++changes.straightened, changes.largest_turn = std::max(changes.largest_turn, turn);
  }
  world::Knot knot;
  knot.joint = world::JointKind::aligned;
  knot.position = r.point;
  knot.tangent = glm::vec3(glm::normalize(direction));
  for (const auto& [length, stored, used] : {std::tuple{a, &knot.in_length, comes}, {b, &knot.out_length, goes}}) {
    if (length > world::kMaxHandle)
      return reader.fail(r.offset,
                         fmt::format("knot {} has a handle of {} m, over the limit of {}", i + 1,
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
  double whole = 0;  // the same but for whole turns, as the file means it
};

// How the horizon turns against the rotation-minimising frame, plus what the track rolled against the horizon. Where
// the track is steep the horizon turns over, one way or the other by what little the track leans, and no file tells
// which was meant: each steep stretch counts as the way that brings the sum nearer to 0.
Twist twist_of(const curve::Cubic& cubic, glm::vec3 up_from, glm::vec3 up_to, double rolled) {
  const dvec3 up(0, 1, 0), start = curve::unit_tangent(cubic, 0);
  curve::Frame carried{start, curve::perpendicular(start, dvec3(up_from))},
      horizon{start, curve::perpendicular(start, up)};
  Twist twist{0, rolled};
  std::vector<double> stretches;  // by how much the horizon turned over each
  bool was_steep = false;
  dvec3 at = curve::point(cubic, 0);
  for (int i = 1; i <= kHorizonSteps; ++i) {
    const double t = static_cast<double>(i) / kHorizonSteps;
    const dvec3 next = curve::point(cubic, t), forward = curve::unit_tangent(cubic, t);
    const bool steep = std::abs(forward.y) > kSteep || std::abs(carried.forward.y) > kSteep;
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

// Whole turns that the least twist between the knots' `up` lacks.
base::Status set_turns(const ChunkReader& reader, world::Document& document, std::size_t i,
                       const std::vector<Record>& records) {
  const Record &from = records[i], &to = records[(i + 1) % records.size()];
  const world::Entity e = document.track.segments[i];
  world::Segment& segment = document.entities.get<world::Segment>(e);
  const curve::Cubic cubic = world::cubic_of(document, e);
  // Back at the first knot the roll may be whole turns away from where it started: that joint gets the least turn.
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

std::vector<std::string> warnings_of(const Changes& changes) {
  std::vector<std::string> warnings;
  if (changes.lengthened > 0)
    warnings.push_back(fmt::format("{} handles shorter than {} m were made that long", changes.lengthened,
                                   base::to_text(world::kMinHandle)));
  if (changes.straightened > 0)
    warnings.push_back(
        fmt::format("{} knots had handles that are not on one line, by up to {} degrees; they were turned onto one",
                    changes.straightened, base::to_text(static_cast<float>(base::degrees(changes.largest_turn)))));
  return warnings;
}

}  // namespace

base::Result<LoadedTrack> parse_nltrack(std::string_view bytes, std::string_view name) {
  const ChunkReader reader{bytes, std::string(name)};
  const auto vertices = find_chunk(reader, "BEZR", 0, kVerticesHead);
  if (!vertices) return vertices.status();
  const auto records = read_records(reader, *vertices);
  if (!records) return records.status();
  const auto place = closed_byte(reader, vertices->end(), records->size());
  if (!place) return place.status();
  const std::size_t at = *place;
  const auto mark = static_cast<unsigned char>(bytes[at]);
  if (mark != 0 && mark != 0xff)
    return reader.fail(at, fmt::format("expected the closed byte 0 or 255, found {}", mark));
  const bool closed = mark == 0xff;
  if (closed && records->size() < 2)
    return reader.fail(at, fmt::format("a closed track has at least 2 knots, found {}", records->size()));

  LoadedTrack track;
  world::Document& document = track.document;
  document.name = name_of_file(name);
  Changes changes;
  for (std::size_t i = 0; i < records->size(); ++i) {
    const auto knot = make_knot(reader, *records, i, closed, changes);
    if (!knot) return knot.status();
    world::append_knot(document, *knot);
  }
  if (closed) world::set_closed(document, true);
  for (std::size_t i = 0; i < document.track.segments.size(); ++i)
    if (const base::Status status = set_turns(reader, document, i, *records); !status) return status;
  if (const auto broken = world::broken_invariant(document))
    return base::Status{base::Code::bad_file, fmt::format("{}: error: {}", reader.name, *broken)};
  track.warnings = warnings_of(changes);
  return track;
}

}  // namespace coaster::exchange
