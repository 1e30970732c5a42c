// The table of formats, and the files read and written by it.
#include "exchange/formats.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <fmt/format.h>

#include "base/hash.h"
#include "base/text.h"
#include "exchange/export/shape_export.h"
#include "exchange/fvd/fvd.h"
#include "exchange/nolimits/nl2_csv.h"
#include "exchange/nolimits/nl2elem.h"
#include "exchange/nolimits/nltrack.h"
#include "exchange/own/share_link.h"
#include "exchange/points/points.h"
#include "sim/fit/heartline_rails_conversion.h"
#include "sim/plan/banking.h"
#include "sim/ride/simulated_ride.h"
#include "sim/shape/folds.h"
#include "sim/shape/roll.h"
#include "world/topology.h"

namespace coaster::exchange {
namespace {

base::Status unfit_import(std::string_view name, std::string_view words) {
  return {base::Code::bad_file, fmt::format("{}: error: {} only for lists of points", name, words)};
}
base::Result<LoadedTrack> parse_csv(std::string_view bytes, std::string_view name, const ImportOptions& import) {
  if (is_points(bytes, false)) return parse_points(bytes, name, import);
  if (!(import == ImportOptions{.origin = import.origin})) return unfit_import(name, "up, scale, smooth and bank are");
  return parse_nl2_csv(bytes, name, import.origin);
}
template <auto parse>
base::Result<LoadedTrack> as_proposed(std::string_view bytes, std::string_view name) {
  return parse(bytes, name, {});
}
std::string print_rows(const world::Document& document) { return print_nl2_csv(document, kNl2Spacing); }
base::Status check_rows(const world::Document& document) { return check_nl2_csv(document, kNl2Spacing); }

// The file's bytes, or the pasted lines.
base::Result<std::string> bytes_of(base::Files& files, const std::filesystem::path& path, const TrackFormat& format) {
  return is_pasted(path.native()) ? path.string() : files.read(path, format.most_bytes);
}

constexpr TrackFormat points_format(std::string_view ending) {
  return {ending, "list of points", as_proposed<parse_points>, nullptr,     false,
          false,  nullptr,          base::kMaxFileBytes,       parse_points};
}

constexpr std::array kFormats{
    TrackFormat{".json", "coaster track", parse_track, print_track, false, true},
    TrackFormat{".nltrack", "NoLimits 1 track", parse_nltrack, nullptr, true, false},
    TrackFormat{".csv", "NoLimits 2 track spline", as_proposed<parse_csv>, print_rows, false, false, check_rows,
                base::kMaxFileBytes, parse_csv},
    TrackFormat{".nl2elem", "NoLimits 2 element", parse_nl2elem, print_nl2elem, false, false, check_nl2elem,
                kMaxNl2ElemBytes, nullptr, true},
    points_format(".xyz"),
    points_format(".txt"),
    points_format(".sp"),
    TrackFormat{".fvd", "openFVD project", parse_fvd, nullptr, true, false},
    TrackFormat{".gltf", "glTF 2.0", nullptr, print_gltf, false, false, check_solid, base::kMaxFileBytes, nullptr,
                false, print_gltf_park},
    TrackFormat{".obj", "Wavefront OBJ", nullptr, print_obj, false, false, check_solid, base::kMaxFileBytes, nullptr,
                false, print_obj_park, obj_materials},
    TrackFormat{".svg", "drawing", nullptr, print_svg, false, false, nullptr, base::kMaxFileBytes, nullptr, true},
};

// m: no coaster is half as long, or a third as high from its lowest to its highest point.
constexpr double kMostLength = 20'000, kMostHeight = 600;

// Returns "a.txt: error: expected a file ending in .json"; says if it is a folder, and names a format that works only
// in the other direction.
std::string unfit_ending(const std::filesystem::path& path, const TrackFormat* format, FormatUse direction) {
  const std::string_view other = direction == FormatUse::read ? "written" : "read";
  std::error_code ignored;
  return fmt::format("{}: error: {}{}expected a file ending in {}", path.string(),
                     std::filesystem::is_directory(path, ignored) ? "this is a folder; " : "",
                     format ? fmt::format("{} ({}) can only be {}; ", format->ending, format->label, other) : "",
                     known_endings(direction));
}

void add_note(LoadedTrack& loaded, std::string_view sentence) {
  if (!loaded.note.empty()) loaded.note += ' ';
  loaded.note += sentence;
}

// Prepares a track without trains and speeds for riding.
void equip(LoadedTrack& loaded) {
  world::Document& document = loaded.document;
  if (document.track.segments.empty()) return;
  if (!world::first_cart(document).valid()) world::add_cart(document, document.track.segments[0], 0);
  if (loaded.knows_speed) return;
  if (const auto speed = sim::completing_speed(document)) {
    document.start_speed = *speed;
    add_note(loaded, fmt::format("The train completes the ride with a start speed of {} m/s.", base::to_text(*speed)));
  } else {
    loaded.warnings.push_back(
        fmt::format("No start speed up to {} m/s completes the ride.", base::to_text(world::kMaxSpeed)));
  }
}

// Banks the knots for the speeds of the ride.
void bank(LoadedTrack& loaded) {
  const sim::DerivedTrack derived = sim::shapes_of(loaded.document);
  sim::RideCache cache;
  const sim::SimulatedRide* const simulated = cache.ride(loaded.document, derived, world::first_cart(loaded.document));
  if (!simulated) return;
  const int turned = sim::bank_knots(loaded.document, derived, *simulated);
  add_note(loaded, fmt::format("Banked {} {}.", turned, turned == 1 ? "knot" : "knots"));
  sim::set_automatic_spins(loaded.document);
}

// Warns of an import that is too large for a coaster: its positions may have another unit. Forces are no sign of that:
// without losses they are the same at every scale. Warns of rows that are far from the origin, too.
void warn_of_unit(LoadedTrack& loaded, const std::string& name, const TrackFormat& format, bool points) {
  const world::Document& document = loaded.document;
  if (document.track.knots.empty()) return;
  glm::vec3 low(std::numeric_limits<float>::max()), high = -low;
  for (const world::Entity e : document.track.knots)
    low = glm::min(low, world::knot(document, e).position), high = glm::max(high, world::knot(document, e).position);
  const double length = world::exact_length(document), rise = high.y - low.y;
  if (length > kMostLength || rise > kMostHeight)
    loaded.warnings.push_back(fmt::format(
        "{}: warning: the track is {:.1f} km long and {:.0f} m high. Positions are in metres: if the file "
        "has another unit, {}",
        name, length / 1000, rise, points ? "load it with the word scale" : "scale its positions and open it again"));
  const glm::vec3 far = glm::max(glm::abs(low), glm::abs(high));
  const float most = std::max({far.x, far.y, far.z});
  if (most > kFar && format.parse_watched)
    loaded.warnings.push_back(
        fmt::format("{}: warning: the track is {:.0f} km from the origin, where positions are rounded "
                    "to {:.0f} mm: load it with the word origin to move it there",
                    name, most / 1000, 1000 * (std::nextafter(most, 1e9f) - most)));
}

// Warns of a document that is valid but probably not intended.
void warn_of_odd(LoadedTrack& loaded, const std::string& name) {
  const world::Document& document = loaded.document;
  const std::vector<world::Entity>& knots = document.track.knots;
  const auto position = [&](world::Entity e) { return world::knot(document, e).position; };
  if (knots.size() > 1 &&
      std::all_of(knots.begin(), knots.end(), [&](world::Entity e) { return position(e) == position(knots.front()); }))
    loaded.warnings.push_back(fmt::format("{}: warning: all {} knots are at one point", name, knots.size()));
}

// Returns the track with the rails for a format that does not hold everything, or the reason why they cannot be
// printed.
base::Result<world::Document> rails_of(const world::Document& document, const TrackFormat& format) {
  const sim::DerivedTrack derived = sim::shapes_of(document);
  const double height = world::rails_height(document);
  if (const std::vector<sim::Fold> folds = sim::folds_of(derived, height); !folds.empty())
    return base::Status{base::Code::refused, "error: the rails fold " + sim::fold_text(folds.front(), height)};
  if (!format.cubics) return document;
  base::Result<sim::SwitchedCurve> switched = sim::switch_curve(document, derived, world::TrackCurve::rails);
  if (!switched) return base::Status{switched.status().code, "error: " + switched.status().message};
  return std::move(switched->document);
}

// Returns what a file is by its first bytes, and what to do, if it is no track but may hold one; "" for others.
std::string_view wrapping(std::string_view bytes) {
  if (bytes.starts_with("PK\x03\x04")) return "a zip archive: unpack it first";
  if (bytes.starts_with("\x1f\x8b")) return "a gzip archive: unpack it first";
  const auto zero = [&](std::size_t i) { return bytes[i] == 0; };
  const bool wide =
      bytes.size() > 3 && zero(0) != zero(1) && zero(0) == zero(2) && zero(1) == zero(3);  // without a BOM
  if (wide || bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff")) return "UTF-16 text: save it as UTF-8";
  return {};
}

base::Status print_to(base::Files& files, const std::filesystem::path& path, const TrackFormat& format,
                      const world::Document& document, std::uint64_t* content, base::ReplaceableFiles replaces,
                      bool with_park) {
  if (format.check)
    if (const base::Status fit = format.check(document); !fit)
      return {fit.code, fmt::format("{}: {}", path.string(), fit.message)};
  std::string bytes = (with_park ? format.print_park : format.print)(document);
  if (const std::filesystem::path beside = materials_of(path); !beside.empty()) {
    bytes = fmt::format("mtllib {}\n{}", beside.filename().string(), bytes);
    if (const base::Status written = files.write_atomic(beside, format.materials(document, with_park)); !written)
      return written;
  }
  bytes = base::visible_text(bytes);
  if (content) *content = base::content_hash(bytes);
  // Refuses to write a file that would be too large to read.
  if (format.parse && bytes.size() > format.most_bytes)
    return {base::Code::refused, fmt::format("{}: error: {} bytes are over the limit of {}", path.string(),
                                             bytes.size(), format.most_bytes)};
  return files.write_atomic(path, bytes, replaces);
}

bool is_list(const TrackFormat& format, std::string_view bytes) {
  return format.parse_watched == parse_points || (format.parse_watched && is_points(bytes, false));
}

}  // namespace

bool is_pasted(std::string_view path) { return path.find('\n') != std::string_view::npos && is_points(path); }

std::filesystem::path materials_of(const std::filesystem::path& path) {
  const TrackFormat* const format = format_of(path);
  return format && format->materials ? std::filesystem::path(path).replace_extension(".mtl") : std::filesystem::path();
}

std::span<const TrackFormat> formats() { return kFormats; }

const TrackFormat* format_of(const std::filesystem::path& path) {
  const std::string ending = is_pasted(path.native()) ? ".xyz" : base::lower(path.extension().string());
  const auto* const found = std::ranges::find(kFormats, ending, &TrackFormat::ending);
  return found == kFormats.end() ? nullptr : &*found;
}

std::string known_endings(FormatUse direction) {
  std::vector<std::string> endings;
  for (const TrackFormat& f : kFormats)
    if (direction == FormatUse::read ? f.parse != nullptr : f.print != nullptr) endings.emplace_back(f.ending);
  return base::alternatives(endings);
}

base::Result<LoadedTrack> load_track(base::Files& files, const std::filesystem::path& path,
                                     const ImportOptions& import) {
  const bool pasted = is_pasted(path.native());
  const std::string name = pasted ? "Pasted points" : path.string();
  const TrackFormat* const format = format_of(path);
  const bool link = !pasted && is_link(name);
  if (!(import == ImportOptions{}) && (link || (format && !format->parse_watched)))
    return unfit_import(name, "origin is only for rows and points, the other words are");
  if (link) return parse_link(name);
  if (!format || !format->parse) return base::Status{base::Code::bad_file, unfit_ending(path, format, FormatUse::read)};
  const base::Result<std::string> bytes = bytes_of(files, path, *format);
  if (!bytes) return bytes.status();
  base::Result<LoadedTrack> loaded =
      format->parse_watched ? format->parse_watched(*bytes, name, import) : format->parse(*bytes, name);
  if (const std::string_view found = wrapping(*bytes); !loaded && !found.empty())
    return base::Status{base::Code::bad_file,
                        fmt::format("{}: error: expected the format {}, found {}", name, format->label, found)};
  if (loaded) warn_of_odd(*loaded, name);
  if (loaded) loaded->content = base::content_hash(*bytes);
  if (loaded && !format->whole) warn_of_unit(*loaded, name, *format, is_list(*format, *bytes)), equip(*loaded);
  if (loaded && import.bank == ImportBank::automatic) bank(*loaded);
  if (loaded && loaded->reshaped)
    add_note(*loaded, "Earlier versions gave this file another curve. Tracks saved from it keep that curve.");
  return loaded;
}

std::optional<ImportQuestion> question_of(base::Files& files, const std::filesystem::path& path) {
  const TrackFormat* const format = format_of(path);
  if (!format || !format->parse_watched) return std::nullopt;
  const base::Result<std::string> bytes = bytes_of(files, path, *format);
  if (bytes && !is_list(*format, *bytes))
    return starts_far(*bytes) ? std::optional(ImportQuestion{{.origin = true}}) : std::nullopt;
  const base::Result<PointList> list = bytes ? read_points(*bytes, {}) : bytes.status();
  if (!list) return std::nullopt;
  ImportQuestion question{proposed(*list, {}), list->points.size(), list->length, list->high - list->low};
  const glm::dvec3 far = *question.proposed.scale * glm::max(glm::abs(list->low), glm::abs(list->high));
  question.proposed.origin = std::max({far.x, far.y, far.z}) > kFar;
  return question;
}

base::Status save_track(base::Files& files, const std::filesystem::path& path, const world::Document& document,
                        std::uint64_t* content, base::ReplaceableFiles replaces, bool with_park) {
  const TrackFormat* const format = format_of(path);
  if (!format || !format->print) return {base::Code::refused, unfit_ending(path, format, FormatUse::write)};
  if (with_park && (!format->print_park || document.park.plain()))
    return {base::Code::refused,
            fmt::format("{}: error: {}", path.string(),
                        format->print_park ? "the track has no park: choose a land, or save it without the word park"
                                           : "only .gltf and .obj can hold the park as triangles")};
  if (!format->whole && document.curve == world::TrackCurve::heartline) {
    const base::Result<world::Document> rails = rails_of(document, *format);
    if (!rails) return {rails.status().code, fmt::format("{}: {}", path.string(), rails.status().message)};
    return print_to(files, path, *format, *rails, content, replaces, with_park);
  }
  return print_to(files, path, *format, document, content, replaces, with_park);
}

}  // namespace coaster::exchange
