// A link packs a line of JSON, the view, and the text of a track file.
#include "exchange/own/share_link.h"

#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <optional>

#include <fmt/format.h>

#include "base/check.h"
#include "base/hash.h"
#include "base/text.h"
#include "exchange/own/json.h"

namespace coaster::exchange {
namespace {

constexpr std::string_view kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
constexpr int kRawDeflate = -15;  // zlib's windowBits: the largest window, without header and checksum
constexpr std::size_t kUnpackStep = std::size_t{64} << 10;  // bytes unpacked at once

base::Status damaged(std::string message) { return {base::Code::bad_file, std::move(message)}; }

// zlib reads through a pointer that is not const, but does not write.
Bytef* bytes_of(std::string_view text) { return reinterpret_cast<Bytef*>(const_cast<char*>(text.data())); }

std::string deflate_raw(std::string_view text) {
  constexpr int kMemory = 9;  // the maximum, for the best compression
  z_stream stream{};
  COASTER_CHECK(deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kRawDeflate, kMemory, Z_DEFAULT_STRATEGY) == Z_OK,
                "deflate starts if there is memory");
  std::string out(deflateBound(&stream, static_cast<uLong>(text.size())), '\0');
  stream.next_in = bytes_of(text), stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data()), stream.avail_out = static_cast<uInt>(out.size());
  const int ended = deflate(&stream, Z_FINISH);
  out.resize(stream.total_out);
  deflateEnd(&stream);
  COASTER_CHECK(ended == Z_STREAM_END, "the bound of deflate holds");
  return out;
}

base::Result<std::string> inflate_raw(std::string_view bytes, std::size_t most_bytes) {
  z_stream stream{};
  COASTER_CHECK(inflateInit2(&stream, kRawDeflate) == Z_OK, "inflate starts if there is memory");
  stream.next_in = bytes_of(bytes), stream.avail_in = static_cast<uInt>(bytes.size());
  std::string out;
  int state = Z_OK;
  while (state == Z_OK && out.size() <= most_bytes) {
    const std::size_t before = out.size();
    out.resize(before + std::min(kUnpackStep, most_bytes + 1 - before));
    stream.next_out = reinterpret_cast<Bytef*>(out.data()) + before;
    stream.avail_out = static_cast<uInt>(out.size() - before);
    state = inflate(&stream, Z_NO_FLUSH);
    out.resize(out.size() - stream.avail_out);
  }
  const bool all_read = stream.avail_in == 0;
  inflateEnd(&stream);
  if (out.size() > most_bytes) return damaged(fmt::format("it unpacks to more than {} bytes", most_bytes));
  if (state == Z_BUF_ERROR) return damaged("it is cut off");
  if (state != Z_STREAM_END || !all_read) return damaged("it is damaged");
  return out;
}

constexpr std::string_view kMark = "#coaster=", kName = "link";

// The version and the packed text of a fragment.
struct LinkParts {
  std::string_view version, packed;
};

std::optional<LinkParts> parts_of(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  while (!text.empty() && kBlanks.find(text.back()) != std::string_view::npos) text.remove_suffix(1);
  const std::size_t mark = text.find(kMark);
  if (mark == std::string_view::npos) return std::nullopt;
  const std::string_view rest = text.substr(mark + kMark.size());
  const std::size_t dot = rest.find_first_not_of("0123456789");
  if (dot == 0 || dot == std::string_view::npos || rest[dot] != '.') return std::nullopt;
  return LinkParts{rest.substr(0, dot), rest.substr(dot + 1)};
}

Json vector_of(glm::vec3 v) { return Json::array({double{v.x}, double{v.y}, double{v.z}}); }

std::string print_view(const world::Document& document, const SharedView& view) {
  const world::Camera& orbit = view.camera;
  return json_line({{"hash", base::hex16(world::hash(document))},
                    {"camera", base::name_of(view.mode)},
                    {"target", vector_of(orbit.target)},
                    {"yaw", double{orbit.yaw_deg}},
                    {"pitch", double{orbit.pitch_deg}},
                    {"distance", double{orbit.distance}},
                    {"field_of_view", double{orbit.field_of_view_deg}},
                    {"projection", base::name_of(orbit.projection)},
                    {"eye", vector_of(view.fly.eye)},
                    {"eye_yaw", double{view.fly.yaw_deg}},
                    {"eye_pitch", double{view.fly.pitch_deg}},
                    {"evaluator", base::name_of(view.evaluator)},
                    {"resolution", view.steps}}) +
         "\n";
}
bool real(JsonFieldReader& fields, std::string_view member, float& value, float low, float high) {
  double wide = 0;
  if (!fields.number(member, wide, low, high)) return false;
  value = static_cast<float>(wide);
  return true;
}
bool place(JsonFieldReader& fields, std::string_view member, glm::vec3& value) {
  glm::dvec3 wide(0);
  if (!fields.vector(member, wide, world::kMaxCoordinate)) return false;
  value = glm::vec3(wide);
  return true;
}

// Fills view and hash, or sets `error`. The caller clamps the view to the cameras' limits.
bool read_view(const Json& tree, SharedView& view, std::string& hash, std::string& error) {
  constexpr float kTurn = 360, kFarthest = 1e6f;
  JsonFieldReader fields(tree, {}, error);
  world::Camera& orbit = view.camera;
  std::int64_t steps = 0;
  const bool read =
      fields.text("hash", hash) && fields.named("camera", view.mode, "") && place(fields, "target", orbit.target) &&
      real(fields, "yaw", orbit.yaw_deg, -kTurn, kTurn) &&
      real(fields, "pitch", orbit.pitch_deg, -world::kMaxPitch, world::kMaxPitch) &&
      real(fields, "distance", orbit.distance, 0, kFarthest) &&
      real(fields, "field_of_view", orbit.field_of_view_deg, world::kMinFieldOfView, world::kMaxFieldOfView) &&
      fields.named("projection", orbit.projection, "") && place(fields, "eye", view.fly.eye) &&
      real(fields, "eye_yaw", view.fly.yaw_deg, -kTurn, kTurn) &&
      real(fields, "eye_pitch", view.fly.pitch_deg, -world::kMaxPitch, world::kMaxPitch) &&
      fields.named("evaluator", view.evaluator, "") &&
      fields.whole("resolution", steps, curve::kMinSteps, curve::kMaxSteps);
  view.steps = static_cast<int>(steps);
  return read;
}

}  // namespace

std::string base64(std::string_view bytes, std::string_view last_two) {
  std::string text;
  text.reserve(bytes.size() * 4 / 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  const auto digit = [&](std::uint32_t value) { return value < 62 ? kAlphabet[value] : last_two[value - 62]; };
  for (const char c : bytes) {
    bits = bits << 8 | static_cast<unsigned char>(c);
    for (count += 8; count >= 6; count -= 6) text += digit(bits >> (count - 6) & 63);
  }
  if (count > 0) text += digit(bits << (6 - count) & 63);
  return text;
}

std::string pack(std::string_view text) { return base64(deflate_raw(text), kAlphabet.substr(62)); }

base::Result<std::string> unpack(std::string_view packed, std::size_t most_bytes) {
  std::string bytes;
  bytes.reserve(packed.size() * 3 / 4);
  std::uint32_t bits = 0;
  int count = 0;
  for (std::size_t i = 0; i < packed.size(); ++i) {
    const std::size_t value = kAlphabet.find(packed[i]);
    if (value == std::string_view::npos)
      return damaged(fmt::format("character {} is none of A-Z, a-z, 0-9, - and _", i + 1));
    bits = bits << 6 | static_cast<std::uint32_t>(value);
    if ((count += 6) >= 8) bytes += static_cast<char>(bits >> (count -= 8) & 255);
  }
  return inflate_raw(bytes, most_bytes);
}

std::string print_link(const world::Document& document, const SharedView& view) {
  return fmt::format("{}{}.{}", kMark, kLinkVersion, pack(print_view(document, view) + print_track(document)));
}

bool is_link(std::string_view text) { return parts_of(text).has_value(); }

base::Result<LoadedTrack> parse_link(std::string_view text) {
  const std::optional<LinkParts> parts = parts_of(text);
  if (!parts) return bad_file(kName, "expected an address with #coaster=1. and a packed track");
  if (parts->version != std::to_string(kLinkVersion))
    return bad_file(
        kName, fmt::format("version {} is not known to this program ({})", parts->version.substr(0, 12), kLinkVersion));
  const base::Result<std::string> whole = unpack(parts->packed, base::kMaxFileBytes);
  if (!whole) return bad_file(kName, whole.status().message);
  const std::size_t line = whole->find('\n');
  if (line == std::string::npos) return bad_file(kName, "it holds no track");
  constexpr std::size_t kMostValues = 1000;  // of the view
  const base::Result<Json> tree = read_json(std::string_view(*whole).substr(0, line), kName, {}, kMostValues);
  if (!tree) return tree.status();
  SharedView view;
  std::string hash, error;
  if (!read_view(*tree, view, hash, error)) return bad_file(kName, error);
  base::Result<LoadedTrack> loaded = parse_track(std::string_view(*whole).substr(line + 1), kName);
  if (!loaded) return loaded;
  if (base::hex16(world::hash(loaded->document)) != hash)
    return bad_file(kName, "it is damaged: the track is not the one that was shared");
  loaded->view = view;
  return loaded;
}

}  // namespace coaster::exchange
