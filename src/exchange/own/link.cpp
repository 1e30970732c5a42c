// A link packs a line of JSON, the view, and the text of a track file.
#include "exchange/own/link.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "base/hash.h"
#include "base/text.h"
#include "exchange/own/json_fields.h"
#include "exchange/own/packed_text.h"

namespace coaster::exchange {
namespace {

constexpr std::string_view kMark = "#coaster=", kName = "link";

// The version and the packed text of a fragment.
struct Parts {
  std::string_view version, packed;
};

std::optional<Parts> parts_of(std::string_view text) {
  constexpr std::string_view kBlanks = " \t\r\n";
  while (!text.empty() && kBlanks.find(text.back()) != std::string_view::npos) text.remove_suffix(1);
  const std::size_t mark = text.find(kMark);
  if (mark == std::string_view::npos) return std::nullopt;
  const std::string_view rest = text.substr(mark + kMark.size());
  const std::size_t dot = rest.find_first_not_of("0123456789");
  if (dot == 0 || dot == std::string_view::npos || rest[dot] != '.') return std::nullopt;
  return Parts{rest.substr(0, dot), rest.substr(dot + 1)};
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

template <class T>
bool named(Fields& fields, std::string_view member, T& value) {
  std::string name;
  if (!fields.text(member, name)) return false;
  const auto found = base::value_named<T>(name);
  if (found) value = *found;
  return found.has_value() || fields.reject(member, base::alternatives_of<T>());
}
bool real(Fields& fields, std::string_view member, float& value, float low, float high) {
  double wide = 0;
  if (!fields.number(member, wide, low, high)) return false;
  value = static_cast<float>(wide);
  return true;
}
bool place(Fields& fields, std::string_view member, glm::vec3& value) {
  glm::dvec3 wide(0);
  if (!fields.vector(member, wide, world::kMaxCoordinate)) return false;
  value = glm::vec3(wide);
  return true;
}

// Fills view and hash, or sets `error`. The caller clamps the view to the cameras' limits.
bool read_view(const Json& tree, SharedView& view, std::string& hash, std::string& error) {
  constexpr float kTurn = 360, kFarthest = 1e6f;
  Fields fields(tree, {}, error);
  world::Camera& orbit = view.camera;
  std::int64_t steps = 0;
  const bool read =
      fields.text("hash", hash) && named(fields, "camera", view.mode) && place(fields, "target", orbit.target) &&
      real(fields, "yaw", orbit.yaw_deg, -kTurn, kTurn) &&
      real(fields, "pitch", orbit.pitch_deg, -world::kMaxPitch, world::kMaxPitch) &&
      real(fields, "distance", orbit.distance, 0, kFarthest) &&
      real(fields, "field_of_view", orbit.field_of_view_deg, world::kMinFieldOfView, world::kMaxFieldOfView) &&
      named(fields, "projection", orbit.projection) && place(fields, "eye", view.fly.eye) &&
      real(fields, "eye_yaw", view.fly.yaw_deg, -kTurn, kTurn) &&
      real(fields, "eye_pitch", view.fly.pitch_deg, -world::kMaxPitch, world::kMaxPitch) &&
      named(fields, "evaluator", view.evaluator) &&
      fields.whole("resolution", steps, curve::kMinSteps, curve::kMaxSteps);
  view.steps = static_cast<int>(steps);
  return read;
}

}  // namespace

std::string print_link(const world::Document& document, const SharedView& view) {
  return fmt::format("{}{}.{}", kMark, kLinkVersion, pack(print_view(document, view) + print_track(document)));
}

bool is_link(std::string_view text) { return parts_of(text).has_value(); }

base::Result<LoadedTrack> parse_link(std::string_view text) {
  const std::optional<Parts> parts = parts_of(text);
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
