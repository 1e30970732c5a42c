// Prints a document as the rows of a NoLimits 2 CSV.
#include <array>

#include <fmt/format.h>

#include "base/check.h"
#include "base/text.h"
#include "exchange/nolimits/nl2_csv.h"
#include "exchange/nolimits/nl2_spline.h"

namespace coaster::exchange {
namespace {

using glm::dvec3;

void print_number(std::string& out, double value) { fmt::format_to(std::back_inserter(out), "\t{:.6f}", value); }

void print_row(std::string& out, std::size_t number, dvec3 position, const curve::Frame& frame) {
  out += std::to_string(number);
  for (const dvec3& v : {position, frame.forward, frame.left(), frame.up})
    for (int axis = 0; axis < 3; ++axis) print_number(out, v[axis]);
  out += '\n';
}

}  // namespace

base::Status check_nl2_csv(const world::Document& document, double spacing) {
  if (document.track.segments.empty())
    return {base::Code::refused, "error: expected a track with segments, found none"};
  const double length = world::exact_length(document);
  if (!(length / spacing < static_cast<double>(kMaxNl2Rows - 1)))
    return {base::Code::refused,
            fmt::format("error: expected at most {} rows, found {} m of track", kMaxNl2Rows, base::to_text(length))};
  return {};
}

std::string print_nl2_csv(const world::Document& document, double spacing) {
  COASTER_CHECK(spacing > 0 && check_nl2_csv(document, spacing).ok(), "callers check the track first");
  const sim::Derived derived = sim::shapes_of(document);
  std::string out;
  for (const std::string_view column : kNl2Columns) out += fmt::format("{}{}\"", out.empty() ? "\"" : "\t\"", column);
  out += '\n';
  std::size_t number = 0;
  const auto row_at = [&](double s) {
    const PlaceOnTrack at = place_on(derived, s);
    print_row(out, ++number, at.position, at.frame);
  };
  // A remainder that would print as the same position gets no row.
  constexpr double kShortest = 1e-5;  // m
  for (double s = 0; s < derived.length - kShortest; s = static_cast<double>(number) * spacing) row_at(s);
  if (!derived.closed) row_at(derived.length);
  return out;
}

}  // namespace coaster::exchange
