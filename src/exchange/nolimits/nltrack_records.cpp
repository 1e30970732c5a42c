// Chunks and numbers of a NoLimits 1 track file.
#include "exchange/nolimits/nltrack_records.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "base/portable_math.h"
#include "base/text.h"
#include "world/components.h"

namespace coaster::exchange {
namespace {

constexpr std::size_t kTagBytes = 4, kHeadBytes = 8;  // a chunk's tag and size
constexpr std::size_t kVerticesHead = 20;             // 16 bytes and the count
constexpr std::size_t kRecordBytes = 60;
constexpr std::size_t kSegmentsHead = 5;  // the count and the closed byte

struct ChunkReader {
  std::string_view bytes;
  std::string name;

  base::Status fail(std::size_t offset, const std::string& message) const { return bad_nltrack(name, offset, message); }
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

}  // namespace

base::Status bad_nltrack(std::string_view name, std::size_t offset, const std::string& message) {
  return {base::Code::bad_file, fmt::format("{}: error: at byte {}: {}", name, offset, message)};
}

base::Result<NltrackRecords> read_nltrack_records(std::string_view bytes, std::string_view name) {
  const ChunkReader reader{bytes, std::string(name)};
  const auto vertices = find_chunk(reader, "BEZR", 0, kVerticesHead);
  if (!vertices) return vertices.status();
  auto knots = read_records(reader, *vertices);
  if (!knots) return knots.status();
  const auto place = closed_byte(reader, vertices->end(), knots->size());
  if (!place) return place.status();
  const auto mark = static_cast<unsigned char>(bytes[*place]);
  if (mark != 0 && mark != 0xff)
    return reader.fail(*place, fmt::format("expected the closed byte 0 or 255, found {}", mark));
  return NltrackRecords{std::move(*knots), mark == 0xff};
}

}  // namespace coaster::exchange
