// Shared parts of the laboratory's pages: the probe, the layout, small widgets, and what outlives a frame: cached
// studies and the choices of each page.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <tuple>
#include <vector>

#include <glm/glm.hpp>

#include "base/cached_value.h"
#include "curve/arc_length_study.h"
#include "curve/continuity.h"
#include "sim/study/evaluator_benchmark.h"
#include "sim/study/force_limits.h"
#include "sim/study/track_errata.h"
#include "ui/context/ui.h"
#include "ui/lab/ride_plots.h"
#include "ui/plots/plot.h"
#include "world/force_program.h"

namespace coaster::ui {

// A plane to draw in: right and up are perpendicular unit vectors.
struct DrawingPlane {
  glm::dvec3 origin{0}, right{1, 0, 0}, up{0, 1, 0};
  glm::dvec2 at(glm::dvec3 p) const { return {glm::dot(p - origin, right), glm::dot(p - origin, up)}; }
};

// Returns the plane through `points` (at least one; the first is the origin) in which they spread most: `right` along
// the two farthest points, `up` towards the point farthest from that line. The last point is right of the first, and
// `up` does not point down in the world. Coplanar points keep their distances. Collinear or coincident points give any
// plane that contains them.
DrawingPlane sheet_of(std::span<const glm::dvec3> points);

// Points as coordinates of a plot's series.
struct PlotPoints {
  std::vector<double> x, y;
  void add(glm::dvec2 p) {
    x.push_back(p.x);
    y.push_back(p.y);
  }
};

// The segment and position that the pages show: the selected segment; else the segment that starts at the selected knot
// (at the last knot: ends there) or that the selected cart is on; else the first one. Nothing on a track without
// segments.
struct Probe {
  world::Entity segment;
  world::EntityName name;
  const sim::SegmentShape* shape = nullptr;
  double t = 0.5;
};
// Returns the probe. Without one, draws a line that says how to create a segment.
std::optional<Probe> need_probe(Ui& ui);
// Moves the probe to t, clamped to [0,1], by selecting the segment.
void move_probe(Ui& ui, const Probe& probe, double t);
// Draws a slider labelled "t", and a plot over t whose cursor is the probe.
void probe_slider(Ui& ui, const Probe& probe);
void plot_over_t(Ui& ui, const Probe& probe, std::string_view label, Plot picture, std::string_view tooltip);

// A page in two parts: controls and numbers on the left, `side` design px wide, and pictures on the right; in a narrow
// strip one below the other, in a low strip with small controls. Construct it before the first part and call pictures()
// before the second.
class PageLayout {
 public:
  PageLayout(const Ui& ui, float side);
  ~PageLayout();
  PageLayout(const PageLayout&) = delete;
  PageLayout& operator=(const PageLayout&) = delete;
  // Begins the second part, which scrolls, and returns the height of its pictures, px.
  float pictures();
  // True if the parts are one below the other.
  bool stacked() const { return stacked_; }
  // Returns the width of the second part, px.
  float pictures_width() const { return pictures_width_; }

 private:
  void end_side();

  float scale_, pictures_width_;
  bool stacked_, compact_, in_side_ = true;
};

// Draws the upper edge of an area at the foot of the window, "Panel/Edge", over the area's first pixels; call it before
// the content. During a drag returns the area's new share of the height between menu and status bar, at most `tallest`;
// 0 on a double click. `bar` is the height of each of the two, px.
std::optional<float> height_edge(Ui& ui, const view::Viewport& area, float bar, float tallest,
                                 std::string_view tooltip);

// Shows a value in the colour of its curve, in the small font.
void colour_value(Ui& ui, std::uint32_t colour, std::string_view path, std::string_view shown, std::string_view value,
                  std::string_view tooltip);
// Shows a checkbox for one of the layers over the scene, "Laboratory/View/label".
void layer_box(Ui& ui, world::Layer layer);

// Shows three components in the small font under a common heading, registered as "Laboratory/path" with the value
// "x y z unit".
void triple_heading(Ui& ui, std::string_view unit);
void triple(Ui& ui, std::string_view path, std::string_view shown, std::uint32_t colour, glm::dvec3 value, int decimals,
            std::string_view unit, std::string_view tooltip);

// Shows a line of small, dimmed text, wrapped.
void small_note(std::string_view words);

struct RadioLabel {
  std::string_view label, tooltip;
};
// Shows two radio buttons side by side. `second`: the second one is on.
void choose_side(Ui& ui, bool& second, const RadioLabel& off, const RadioLabel& on);

// Draws two pictures side by side, or one below the other in a narrow area. Each function gets width and height, px.
using Picture = std::function<void(float width, float height)>;
void two_pictures(Ui& ui, PageLayout& page, const Picture& first, const Picture& second);

// Colours of the laboratory, the same in the view and in the plots.
inline constexpr std::uint32_t kCurveColour = 0xFFFFFF, kPolygonColour = 0xF2B84B, kConstructionColour = 0x7FD1B9,
                               kTangentColour = 0xE5534B;
inline constexpr std::uint32_t kPointColour = 0xFF8A1F;
// Returns a colour for a row of a table; colours of different rows are easy to distinguish on the plots' background.
std::uint32_t row_colour(std::size_t row);

struct JointRow {
  world::Entity knot;
  world::EntityName name;
  curve::JointContinuity joint;
  std::optional<double> step;  // g, at the fastest passage of the whole ride; nothing without one
  double jolt = 0;             // g, in the whole ride
};
struct JointList {
  std::vector<JointRow> rows;        // in track order
  std::vector<std::size_t> by_jolt;  // indices of rows, largest jolt first
};

// Curvature and torsion of one segment by arc length.
struct CurvatureStudy {
  std::vector<double> s, curvature, torsion;  // m, 1/m, 1/m (NaN at a cusp, or without a Frenet frame)
  std::vector<double> flips;                  // m, where the normal flips
};

struct BasisStudy {
  std::vector<double> t;
  std::vector<std::vector<double>> y;  // values of B_0 .. B_n
};
struct ErrorStudy {
  std::vector<double> t, mm;
  double bound = 0, largest = 0, seam = 0;  // mm
};

// Results of one arc-length method for the segment and the track.
struct LengthRow {
  double length = 0, error = 0;  // m, for the segment
  std::int64_t evaluations = 0;
  double microseconds = 0;  // 0: not measured
  std::vector<double> work = {}, relative_error = {};
  bool track_known = false;
  double track_length = 0, track_error = 0;  // m
};
using LengthStudy = std::vector<LengthRow>;
// Sums over the first `next` segments, by method.
struct TrackLengths {
  std::vector<double> lengths, errors;  // m
  std::size_t next = 0;
};

// The ends of the axes of a force section's plot.
struct ForcePlotRanges {
  double from = 0, to = 1;             // m
  double low = 0, high = 1;            // of the channel
  double felt_low = 0, felt_high = 1;  // g at the right edge
};

// The edited key of a force section in the force graph, and its state during a drag.
struct ForceKeyEditing {
  world::EntityName section;  // the section that these choices belong to
  world::ForceChannel channel = world::ForceChannel::vertical;
  std::optional<std::size_t> key;  // selected
  std::optional<double> inserted;  // position of a new key, selected once it exists
  int side = 0;                    // held part: 0 the key, below 0 its handle before it, above 0 its handle after it
  bool gesture = false;
  bool undone = false;                       // the drag was undone, and the mouse button is still down
  world::ForceKey from;                      // the key at the start of the drag
  ForcePlotRanges axes;                      // during a drag
  std::vector<double> place, asked, actual;  // data of the plot
};

struct LabCache {
  int degree = 3;  // degree of the basis functions shown
  base::CachedValue<int, BasisStudy> basis;
  int compared = -1;  // row of the second evaluator; -1: none
  // Keyed by the segment's build, evaluator and steps.
  base::CachedValue<std::tuple<std::uint64_t, int, int>, ErrorStudy> error, other_error;
  base::CachedValue<std::tuple<std::uint64_t, int>, LengthStudy> lengths;  // by the segment's build and steps
  // By the last build, order and steps.
  base::CachedValue<std::tuple<std::uint64_t, std::vector<world::Entity>, int>, TrackLengths> track_lengths;
  bool lengths_of_track = false;
  bool show_errors = false;  // where there is no space for both: errors instead of times
  std::string csv = "measurements.csv";

  // Keyed by the last build, the order of the segments, whether the track is closed, the ride's serial (0 without one)
  // and the cutoff.
  base::CachedValue<std::tuple<std::uint64_t, std::vector<world::Entity>, bool, std::uint64_t, double>, JointList>
      joints;
  bool joints_by_jolt = true;
  // Keyed by the segment's build, the last build of all, steps and speed (m/s).
  base::CachedValue<std::tuple<std::uint64_t, std::uint64_t, int, double>,
                    std::array<sim::Erratum, sim::kErrata.size()>>
      errata;
  base::CachedValue<std::uint64_t, CurvatureStudy> bend;  // by the segment's build

  // Keyed by the serials of ride and envelope, the first and the last car, and whether it is over time.
  base::CachedValue<std::tuple<std::uint64_t, std::uint64_t, int, int, bool>, SeatStudy> seat;
  std::array<sim::RideValue, 2> force_plots{sim::RideValue::vertical, sim::RideValue::speed};
  bool forces_over_time = false;
  std::array<bool, 4> graph_hidden{};  // hidden curves of the force graph
  ForceKeyEditing keys;
  int red_chosen = -1;
  std::optional<sim::KnotMoveAdvice> advice;  // for the selected overload
  bool advised = false;                       // true once it was requested
};

}  // namespace coaster::ui
