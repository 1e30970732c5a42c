// Reads and writes force limits as JSON.
#include "exchange/own/envelope_file.h"

#include <array>

#include <fmt/format.h>

#include "base/text.h"
#include "exchange/own/json_fields.h"
#include "world/components.h"

namespace coaster::exchange {
namespace {

struct EnvelopeParse {
  LoadedEnvelope loaded;
  std::string error;  // the first error, without the file's name
};

bool read_envelope_head(EnvelopeParse& parse, Fields& fields) {
  std::string note;
  if (!fields.head(kEnvelopeFormat, kEnvelopeVersion)) return false;
  if (fields.has("note") && !fields.text("note", note)) return false;
  if (!fields.text("name", parse.loaded.name)) return false;
  if (parse.loaded.name.size() > world::kMaxNameBytes)
    return fields.fail("name", fmt::format("longer than the limit of {} bytes", world::kMaxNameBytes));
  return fields.number("shortest", parse.loaded.envelope.shortest, 0, kMaxShortest) &&
         fields.number("cutoff", parse.loaded.envelope.cutoff, kMinCutoff, kMaxCutoff);
}

bool read_point(EnvelopeParse& parse, const Json& value, std::string_view axis, std::size_t index,
                sim::EnvelopeCurve& curve) {
  Fields fields(value, {axis, index}, parse.error);
  sim::EnvelopePoint point{0, 0};
  if (!fields.number("seconds", point.seconds, 0, kMaxEnvelopeSeconds) ||
      !fields.number("g", point.g, 0, kMaxEnvelopeG))
    return false;
  if (!curve.empty() && !(point.seconds > curve.back().seconds))
    return fields.reject("seconds",
                         fmt::format("more than {} (durations ascend)", base::to_text(curve.back().seconds)));
  fields.unknown(parse.loaded.warnings);
  curve.push_back(point);
  return true;
}

bool read_curves(EnvelopeParse& parse, Fields& fields) {
  for (std::size_t axis = 0; axis < sim::kForceAxes; ++axis) {
    const std::string_view name = base::name_of(static_cast<sim::ForceAxis>(axis));
    const Json* const list = fields.list(name, kMaxEnvelopePoints);
    if (!list) return false;
    for (std::size_t i = 0; i < list->size(); ++i)
      if (!read_point(parse, (*list)[i], name, i, parse.loaded.envelope.curves[axis])) return false;
  }
  fields.unknown(parse.loaded.warnings);
  return true;
}

}  // namespace

base::Result<LoadedEnvelope> parse_envelope(std::string_view text, std::string_view name) {
  const base::Result<Json> tree = read_json(text, name);
  if (!tree) return tree.status();
  EnvelopeParse parse;
  Fields fields(*tree, {}, parse.error);
  if (parse.error.empty() && read_envelope_head(parse, fields)) read_curves(parse, fields);
  if (!parse.error.empty()) return bad_file(name, parse.error);
  name_ignored(parse.loaded.warnings, name);
  return std::move(parse.loaded);
}

std::string print_envelope(const sim::Envelope& envelope, std::string_view name) {
  std::string out = fmt::format(
      "{{\n  \"format\": {},\n  \"version\": {},\n  \"name\": {},\n  \"note\": {},\n  \"shortest\": {},\n  \"cutoff\": "
      "{}",
      json_string(kEnvelopeFormat), kEnvelopeVersion, json_string(name), json_string(kEnvelopeNote),
      base::to_text(envelope.shortest), base::to_text(envelope.cutoff));
  for (std::size_t axis = 0; axis < sim::kForceAxes; ++axis) {
    out += fmt::format(",\n  {}: [", json_string(base::name_of(static_cast<sim::ForceAxis>(axis))));
    const char* before = "\n";
    for (const sim::EnvelopePoint& point : envelope.curves[axis]) {
      out += fmt::format("{}    {{\"seconds\": {}, \"g\": {}}}", before, base::to_text(point.seconds),
                         base::to_text(point.g));
      before = ",\n";
    }
    out += envelope.curves[axis].empty() ? "]" : "\n  ]";
  }
  return out + "\n}\n";
}

base::Result<LoadedEnvelope> load_envelope(base::Files& files, const std::filesystem::path& path) {
  const base::Result<std::string> text = read_json_file(files, path);
  if (!text) return text.status();
  return parse_envelope(*text, path.string());
}

}  // namespace coaster::exchange
