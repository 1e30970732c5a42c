// Reads and writes force limits as JSON.
#include "exchange/own/force_limits_file.h"

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/own/json.h"
#include "world/components.h"

namespace coaster::exchange {
namespace {

bool read_head(JsonFieldReader& fields, LoadedForceLimits& to) {
  std::string note;
  if (!fields.head(kEnvelopeFormat, kEnvelopeVersion) || (fields.has("note") && !fields.text("note", note)) ||
      !fields.text("name", to.name))
    return false;
  if (to.name.size() > world::kMaxNameBytes)
    return fields.fail("name", fmt::format("longer than the limit of {} bytes", world::kMaxNameBytes));
  return fields.number("shortest", to.envelope.shortest, 0, kMaxShortest) &&
         fields.number("cutoff", to.envelope.cutoff, kMinCutoff, kMaxCutoff);
}

bool read_point(JsonFieldReader& fields, sim::EnvelopeCurve& curve, std::vector<std::string>& warnings) {
  sim::ForceLimitPoint point{0, 0};
  if (!fields.number("seconds", point.seconds, 0, kMaxEnvelopeSeconds) ||
      !fields.number("g", point.g, 0, kMaxEnvelopeG))
    return false;
  if (!curve.empty() && !(point.seconds > curve.back().seconds))
    return fields.reject("seconds",
                         fmt::format("more than {} (durations ascend)", base::to_text(curve.back().seconds)));
  fields.unknown(warnings);
  curve.push_back(point);
  return true;
}

bool read_envelope(JsonFieldReader& fields, LoadedForceLimits& to) {
  if (!read_head(fields, to)) return false;
  for (std::size_t axis = 0; axis < sim::kForceAxes; ++axis)
    if (!fields.each(
            base::name_of(static_cast<sim::ForceAxis>(axis)), kMaxEnvelopePoints,
            [&](JsonFieldReader& point, auto) { return read_point(point, to.envelope.curves[axis], to.warnings); }))
      return false;
  fields.unknown(to.warnings);
  return true;
}

}  // namespace

base::Result<LoadedForceLimits> parse_envelope(std::string_view text, std::string_view name) {
  base::Result<LoadedForceLimits> loaded = read_object<LoadedForceLimits>(text, name, read_envelope);
  if (loaded) name_ignored(loaded->warnings, name);
  return loaded;
}

std::string print_envelope(const sim::ForceLimitCurves& envelope, std::string_view name) {
  std::string out = fmt::format(
      "{{\n  \"format\": {},\n  \"version\": {},\n  \"name\": {},\n  \"note\": {},\n  \"shortest\": {},\n  \"cutoff\": "
      "{}",
      json_string(kEnvelopeFormat), kEnvelopeVersion, json_string(name), json_string(kEnvelopeNote),
      base::to_text(envelope.shortest), base::to_text(envelope.cutoff));
  for (std::size_t axis = 0; axis < sim::kForceAxes; ++axis) {
    out += fmt::format(",\n  {}: [", json_string(base::name_of(static_cast<sim::ForceAxis>(axis))));
    const char* before = "\n";
    for (const sim::ForceLimitPoint& point : envelope.curves[axis]) {
      out += fmt::format("{}    {{\"seconds\": {}, \"g\": {}}}", before, base::to_text(point.seconds),
                         base::to_text(point.g));
      before = ",\n";
    }
    out += envelope.curves[axis].empty() ? "]" : "\n  ]";
  }
  return out + "\n}\n";
}

base::Result<LoadedForceLimits> load_envelope(base::Files& files, const std::filesystem::path& path) {
  const base::Result<std::string> text = read_json_file(files, path);
  if (!text) return text.status();
  return parse_envelope(*text, path.string());
}

}  // namespace coaster::exchange
