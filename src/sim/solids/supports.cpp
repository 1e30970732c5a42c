// The forms of supports, where they fit, and their solids.
#include "sim/solids/supports.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "base/cancellable_job.h"
#include "sim/shape/rails.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kHigh = 15;         // m: higher track gets two legs
constexpr double kStrutted = 9;      // m: longer legs have a strut between them
constexpr double kUpright = -0.1;    // vertical component of the frame's up: below it the track is inverted
constexpr double kLevelPart = 0.35;  // horizontal part of a direction that counts as sideways

// The ground that supports stand on; without one the plane y = 0.
struct Footing {
  const Ground* ground;
  double height(dvec3 p) const { return ground != nullptr ? ground->height(p.x, p.z) : 0; }
  dvec3 below(dvec3 p) const { return {p.x, height(p), p.z}; }
};

struct SupportSite {
  dvec3 top;              // on the spine's axis
  double height, radius;  // m: of the top over the ground, of a column
  dvec3 side;             // level, perpendicular to the track
  dvec3 back{0};          // level, away from the riders; zero on level track
  bool upright;
};

dvec3 level(dvec3 v) { return {v.x, 0, v.z}; }

SupportSite site_at(const Ring& at, const CoasterForm& form, const Footing& footing) {
  SupportSite site{};
  const dvec3 riders = form.side * at.frame.up;  // the side on which they are
  site.top = at.position + form.hold * at.frame.up;
  site.height = site.top.y - footing.height(site.top);
  site.radius = std::clamp(0.13 + 0.0055 * site.height, 0.13, 0.36);
  site.side = level_side(at.frame);
  const dvec3 back = level(-riders);
  if (glm::length(back) > kLevelPart) site.back = glm::normalize(back);
  site.upright = riders.y > kUpright;
  return site;
}

Bar bar(dvec3 from, dvec3 to, double from_radius, double to_radius, bool grounded) {
  return {glm::vec3(from), glm::vec3(to), static_cast<float>(from_radius), static_cast<float>(to_radius), grounded};
}

class FormTrial {
 public:
  FormTrial(const SupportSite& site, const Footing& footing, const std::function<bool(std::span<const Bar>)>& takes)
      : site_(site), footing_(footing), takes_(takes) {}

  bool leg(double aside) const {
    const dvec3 foot = footing_.below(site_.top + aside * site_.side);
    return stands(foot) && takes_(std::array{bar(site_.top, foot, 0.8 * site_.radius, site_.radius, true)});
  }
  bool two_legs(double spread) const {
    const dvec3 left = footing_.below(site_.top + spread * site_.side),
                right = footing_.below(site_.top - spread * site_.side);
    if (!stands(left) || !stands(right)) return false;
    const Bar a = bar(site_.top, left, 0.7 * site_.radius, 0.9 * site_.radius, true),
              b = bar(site_.top, right, 0.7 * site_.radius, 0.9 * site_.radius, true);
    if (site_.height < kStrutted) return takes_(std::array{a, b});
    constexpr float kDown = 0.55f;  // of the legs' height
    const double thin = 0.55 * site_.radius;
    return takes_(std::array{
        a, b, bar(dvec3(glm::mix(a.from, a.to, kDown)), dvec3(glm::mix(b.from, b.to, kDown)), thin, thin, false)});
  }
  // An arm that slopes down outwards on upright track and is level on inverted track.
  bool arm(dvec3 direction, double out) const {
    const dvec3 elbow = site_.top + out * direction - dvec3(0, site_.upright ? 0.25 * out : 0.0, 0);
    const dvec3 foot = footing_.below(elbow);
    if (direction == dvec3(0) || elbow.y - foot.y < kLowestSupport) return false;
    const double r = site_.radius;
    return takes_(std::array{bar(site_.top, elbow, 0.8 * r, r, false),
                             bar(elbow + dvec3(0, 0.5 * r, 0), foot, r, 1.1 * r, true)});
  }

 private:
  // Beside the track the ground may rise above it.
  bool stands(dvec3 foot) const { return site_.top.y - foot.y >= kLowestSupport; }

  const SupportSite& site_;
  const Footing& footing_;
  const std::function<bool(std::span<const Bar>)>& takes_;
};

constexpr int kSides = 10;

// The ground hides half of the sky from the vertices from `first` on where they are near a foot.
void shade_foot(double foot, std::size_t first, Mesh& mesh) {
  constexpr float kReach = 1.6f;  // m
  for (std::size_t i = first; i < mesh.vertices.size(); ++i)
    mesh.vertices[i].along = 1 - (mesh.vertices[i].position.y - static_cast<float>(foot)) / kReach;
}

// Adds a concrete footing slightly above the ground, and the plate that the bar is bolted to.
void add_footing(dvec3 at, double radius, Mesh& mesh) {
  constexpr double kHeight = 0.22, kPlate = 0.05;
  const double wide = 1.7 * radius + 0.16, plate = 1.25 * radius + 0.06;
  const dvec3 top = at + dvec3(0, kHeight, 0);
  add_bar(at, top, 1.06 * wide, wide, kSides, Material::concrete, false, mesh);
  add_bar(top, top + dvec3(0, kPlate, 0), plate, plate, kSides, Material::support, false, mesh);
}

void add_collar(const Ring& hold, const CoasterForm& form, Mesh& mesh) {
  if (form.hold_radius == 0) return;
  constexpr double kHalf = 0.10, kThick = 0.05;
  Ring ends[2] = {hold, hold};
  ends[0].position -= kHalf * hold.frame.forward, ends[1].position += kHalf * hold.frame.forward;
  add_tube(ends, {{0, form.hold}, form.hold_radius + kThick, 12, 4, Material::tie}, mesh);
}

// A frame of timber across the track: two legs that spread downwards, with a ledger at every multiple of kStorey m
// above the feet, so that those of neighbours are level on any ground.
struct Bent {
  static constexpr double kStorey = 3.2, kSpread = 0.10, kHalfLeg = 0.11, kBetween = 1.15;  // m
  static constexpr double kLeast = 0.8;                                                     // m of the topmost storey
  Ring hold;
  std::array<dvec3, 2> tops, feet;

  double top() const { return std::min(tops[0].y, tops[1].y); }
  // Return the storey in which the feet are, and the topmost one that has a ledger.
  int base() const { return static_cast<int>(std::floor((std::max(feet[0].y, feet[1].y) + kLeast) / kStorey)); }
  int storeys() const { return std::max(base(), static_cast<int>(std::floor((top() - kLeast) / kStorey))); }
  std::array<Bar, 2> legs() const {
    return {bar(tops[0], feet[0], kHalfLeg, kHalfLeg, true), bar(tops[1], feet[1], kHalfLeg, kHalfLeg, true)};
  }
  // Returns the point of a leg at ledger `storey`; its foot at the base or below, its top above the last one.
  dvec3 on_leg(std::size_t leg, int storey) const {
    if (storey > storeys()) return tops[leg];
    const double over = storey > base() ? storey * kStorey - feet[leg].y : 0;
    return glm::mix(feet[leg], tops[leg], over / (tops[leg].y - feet[leg].y));
  }
};

// Returns nothing where the track is steep, banked too far, or on the ground.
std::optional<Bent> bent_at(const Ring& at, const CoasterForm& form, const Footing& footing) {
  constexpr double kLeastLevel = 0.1, kLeastUp = 0.3;
  const dvec3 left = at.frame.left(), flat = level(left);
  if (glm::length(level(at.frame.forward)) < kLeastLevel || at.frame.up.y < kLeastUp || glm::length(flat) < kLeastLevel)
    return std::nullopt;
  Bent bent{at, {}, {}};
  for (const std::size_t leg : {std::size_t{0}, std::size_t{1}}) {
    const double side = leg == 0 ? 1 : -1;
    bent.tops[leg] = at.place(side * Bent::kBetween, form.hold);
    const double height = bent.tops[leg].y - footing.height(bent.tops[leg]);
    if (height < kLowestSupport) return std::nullopt;
    bent.feet[leg] = footing.below(bent.tops[leg] + side * Bent::kSpread * height * glm::normalize(flat));
    if (bent.tops[leg].y - bent.feet[leg].y < kLowestSupport) return std::nullopt;
  }
  return bent;
}

Brace brace(dvec3 from, dvec3 to, double half, bool from_afar) {
  return {glm::vec3(from), glm::vec3(to), static_cast<float>(half), from_afar};
}

// A cap under the ties, the ledgers, and crossed braces between them.
void add_braces(const Bent& bent, std::vector<Brace>& braces) {
  constexpr double kCap = 0.10, kLedger = 0.07, kCross = 0.055;  // m
  braces.push_back(brace(bent.tops[0], bent.tops[1], kCap, true));
  for (int storey = bent.base(); storey <= bent.storeys(); ++storey) {
    if (storey > bent.base())
      braces.push_back(brace(bent.on_leg(0, storey), bent.on_leg(1, storey), kLedger, storey % 2 == 0));
    for (const std::size_t leg : {std::size_t{0}, std::size_t{1}})
      braces.push_back(brace(bent.on_leg(leg, storey), bent.on_leg(1 - leg, storey + 1), kCross, false));
  }
}

// Ribbons from a bent to the next one along the ledgers of both, and a diagonal in every third field.
void add_ribbons(const Bent& from, const Bent& to, int number, std::vector<Brace>& braces) {
  constexpr double kRibbon = 0.06, kDiagonal = 0.05, kFarthest = 5;  // m
  if (glm::distance(from.tops[0], to.tops[0]) > kFarthest || glm::distance(from.tops[1], to.tops[1]) > kFarthest)
    return;
  const int lowest = std::max(from.base(), to.base()), storeys = std::min(from.storeys(), to.storeys());
  for (const std::size_t leg : {std::size_t{0}, std::size_t{1}})
    for (int storey = lowest + 1; storey <= storeys; ++storey) {
      braces.push_back(brace(from.on_leg(leg, storey), to.on_leg(leg, storey), kRibbon, storey % 2 == 0));
      if ((number + storey) % 3 == 0)
        braces.push_back(brace(from.on_leg(leg, storey), to.on_leg(leg, storey - 1), kDiagonal, false));
    }
}

// Adds the four sides of a square beam.
void add_timber(dvec3 from, dvec3 to, double half, bool from_afar, Mesh& mesh) {
  const double length = glm::length(to - from);
  if (!(length > 1e-6)) return;
  const dvec3 forward = (to - from) / length, up = curve::perpendicular(forward, {0, 1, 0}),
              left = glm::cross(up, forward);
  const auto corner = [&](dvec3 end, double aside, double high) { return end + half * (aside * left + high * up); };
  constexpr double kRound[][2] = {{1, -1}, {1, 1}, {-1, 1}, {-1, -1}};  // counter-clockwise against the way
  for (std::size_t k = 0; k < 4; ++k) {
    const auto &a = kRound[k], &b = kRound[(k + 1) % 4];
    add_face(
        std::array{corner(from, a[0], a[1]), corner(from, b[0], b[1]), corner(to, b[0], b[1]), corner(to, a[0], a[1])},
        Material::support, from_afar, mesh);
  }
}

void add_bents(const SegmentSupports& supports, Mesh& mesh) {
  constexpr double kFooting = 0.28, kPad = 0.14;  // m
  for (const Bar& leg : supports.bars) {
    const std::size_t first = mesh.vertices.size();
    add_timber(dvec3(leg.from), dvec3(leg.to), double{leg.to_radius}, true, mesh);
    const dvec3 foot(leg.to);
    add_box(foot + dvec3(0, 0.5 * kPad, 0), {{1, 0, 0}, {0, 1, 0}}, {kFooting, 0.5 * kPad, kFooting},
            Material::concrete, false, mesh);
    shade_foot(foot.y, first, mesh);
  }
  for (const Brace& each : supports.braces)
    add_timber(dvec3(each.from), dvec3(each.to), double{each.half}, each.from_afar, mesh);
}

// Returns the desired spacing of supports on a segment.
double wanted_spacing(const SegmentShape& shape) {
  if (form_of(shape).supports == SupportForm::bent) return kBentSpacing;
  constexpr double kTight = 14;      // m of radius: at and below it spacing is smallest
  constexpr double kHighTrack = 25;  // m
  const double length = shape.arc.length();
  double turned = 0;
  glm::dvec3 last = shape.frame(0).forward;
  for (int i = 1; i <= kFrameIntervals; ++i) {
    const glm::dvec3 next = shape.frame(i).forward;
    turned += glm::length(next - last);
    last = next;
  }
  const double bent = std::min(1.0, kTight * turned / length);
  const double high = std::clamp(curve::point(shape.key.cubic, 0.5).y / kHighTrack - 0.5, 0.0, 0.5);
  return std::max(kMinSupportSpacing,
                  kMaxSupportSpacing - (kMaxSupportSpacing - kMinSupportSpacing) * std::max(bent, high));
}

// True if the feet of `bars` are at least kApart from those of the segment's other supports.
bool apart(std::span<const Bar> bars, std::span<const Bar> others) {
  constexpr float kApart = 1;  // m
  return std::ranges::none_of(bars, [&](const Bar& bar) {
    const auto beside = [&](const Bar& other) { return other.grounded && glm::distance(bar.to, other.to) < kApart; };
    return bar.grounded && std::ranges::any_of(others, beside);
  });
}

// Returns the box of all possible bars of the segment's supports with their clearance.
curve::Box bars_box(const curve::Box& box, const CoasterForm& form) {
  const float aside = kSupportReach + static_cast<float>(reach_of(form.envelope) + std::abs(form.hold)) + 1;
  curve::Box reach = widened(box, aside);
  reach.low.y = -std::numeric_limits<float>::infinity();
  return reach;
}

}  // namespace

bool try_forms(const Ring& at, const CoasterForm& form, const Footing& footing,
               const std::function<bool(std::span<const Bar>)>& takes) {
  const SupportSite site = site_at(at, form, footing);
  if (site.height < kLowestSupport) return false;
  const FormTrial trial(site, footing, takes);
  if (site.upright) {
    if (site.height > kHigh && trial.two_legs(std::min(0.15 * site.height, 7.0))) return true;
    if (trial.leg(0)) return true;
    if (site.height > 3 && trial.two_legs(std::clamp(0.28 * site.height, 1.6, 6.0))) return true;
    for (const double aside : {1.6, -1.6, 2.8, -2.8, 4.2, -4.2})
      if (std::abs(aside) < 0.6 * site.height && trial.leg(aside)) return true;
  }
  const std::array<dvec3, 3> ways =
      site.upright ? std::array{site.side, -site.side, site.back} : std::array{site.back, site.side, -site.side};
  // Longer for higher track, so that the columns of stacked track do not intersect.
  const double longer = 0.08 * std::min(site.height, 30.0);
  for (const double out : {2.2, 3.1, 4.2, 5.5, 7.0})
    for (const dvec3& way : ways)
      if (trial.arm(way, std::min(out + longer, 7.5))) return true;
  return false;
}

void build_support_mesh(const SegmentSupports& supports, const CoasterForm& form, Mesh& mesh) {
  mesh.clear();
  if (supports.form == SupportForm::bent) return add_bents(supports, mesh);
  for (const Bar& bar : supports.bars) {
    const std::size_t first = mesh.vertices.size();
    const dvec3 from(bar.from), to(bar.to);
    const auto from_radius = static_cast<double>(bar.from_radius), to_radius = static_cast<double>(bar.to_radius);
    // At another bar it ends slightly farther on, so that there is no notch. A leaning leg ends inside its footing.
    const double length = glm::length(to - from), over = bar.grounded ? -0.15 : 0.5 * to_radius;
    add_bar(from, length > 0.2 ? to + over / length * (to - from) : to, from_radius, to_radius, kSides,
            Material::support, true, mesh);
    if (bar.grounded) add_footing(to, to_radius, mesh), shade_foot(to.y, first, mesh);
  }
  for (const Ring& hold : supports.holds) add_collar(hold, form, mesh);
}

SupportSpacing spacing_of(const SegmentShape& shape) {
  constexpr double kShortest = 0.05,
                   kMost = 1.7;  // m; largest spacing relative to the segment's length, for a support on each
  const double length = shape.arc.length();
  if (!(length > kShortest)) return {};
  double wanted = wanted_spacing(shape) / length;
  if (wanted <= kMost) return {static_cast<int>(std::clamp(1 / wanted + 0.62, 1.0, double{kMostSupports})), 1};
  int every = 1;
  for (; wanted > kMost; wanted /= 2) every *= 2;
  return {1, every};
}

// Finds the segments near enough to be met by supports of near ones: all, if everything is near. Returns whether they
// are others than before, or have other indices.
bool Supports::gather(const DerivedTrack& derived, const NearSegments& near) {
  if (near.everywhere()) {
    if (near_.empty() && order_ == derived.order) return false;
    near_.clear(), order_ = derived.order;
    places_.resize(order_.size());
    std::iota(places_.begin(), places_.end(), std::size_t{0});
    return true;
  }
  if (near_ == near.indices() && build_ == derived.last_build) return false;
  near_ = near.indices();
  places_.clear(), order_.clear();
  if (near_.empty()) return true;
  constexpr float kMargin = 1;  // m
  curve::Box room = rails_box(derived.shape_at(near_.front()));
  for (const std::size_t i : near_) {
    const curve::Box box = rails_box(derived.shape_at(i));
    room = {glm::min(room.low, box.low), glm::max(room.high, box.high)};
  }
  room = widened(bars_box(room, form_of(derived.made.kind)),
                 kMargin + static_cast<float>(std::abs(derived.shape_at(near_.front()).key.rails)));
  (void)all_near(derived.tree, room, [&](std::size_t i) {
    places_.push_back(i);
    return true;
  });
  std::sort(places_.begin(), places_.end());
  for (const std::size_t i : places_) order_.push_back(derived.order[i]);
  return true;
}

// Notes the track that moved; track that only came near or went away has not.
void Supports::take_shapes(const DerivedTrack& derived) {
  ++stamp_;
  const bool still = std::exchange(build_, derived.last_build) == derived.last_build;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    const SegmentShape& shape = derived.shape_at(places_[k]);
    Entry* entry = entries_.find(order_[k]);
    const bool known = entry != nullptr && entry->shape_build == shape.shape_build;
    if (entry == nullptr) entry = &entries_.put(order_[k], Entry{});
    else if (!known) moved_.push_back(entry->lane.box);
    entry->stamp = stamp_;
    if (known) continue;
    entry->shape_build = shape.shape_build;
    entry->stale = true;
    entry->lane = {rings_of(shape, detail_.most_rings), rails_box(shape)};
    entry->reach = bars_box(entry->lane.box, form_of(shape));
    entry->ground = 0, ground_build_ = kUnknown;
    entry->spacing = spacing_of(shape);
    if (!still) moved_.push_back(entry->lane.box);
  }
}

void Supports::drop_others(const DerivedTrack& derived) {
  std::vector<world::Entity> others;
  for (std::size_t i = 0; i < entries_.size(); ++i) {
    if (entries_.items()[i].stamp == stamp_) continue;
    others.push_back(entries_.entities()[i]);
    const Entry& entry = entries_.items()[i];
    const SegmentShape* const shape = derived.segments.find(others.back());
    if (shape == nullptr || shape->shape_build != entry.shape_build) moved_.push_back(entry.lane.box);
  }
  for (const world::Entity segment : others) entries_.erase(segment);
}

// The supports of a segment that is not near are found again when it is: what moves near them may be unknown.
void Supports::forget_far() {
  std::size_t n = 0;
  for (std::size_t k = 0; k < order_.size(); ++k) {
    while (n < near_.size() && near_[n] < places_[k]) ++n;
    if (n == near_.size() || near_[n] != places_[k]) entries_.get(order_[k]).stale = true;
  }
}

// Short segments have supports by their index in the track: if the index changed, other segments have one.
void Supports::take_turns() {
  for (std::size_t k = 0; k < order_.size(); ++k) {
    Entry& entry = entries_.get(order_[k]);
    const int count = entry.spacing.on(places_[k]);
    if (count != entry.count) entry.stale = true;
    entry.count = count;
  }
}

void Supports::mark_disturbed() {
  for (Entry& entry : entries_.items())
    entry.stale |= std::ranges::any_of(moved_, [&](const curve::Box& box) { return meet(entry.reach, box); });
}

SegmentSupports Supports::find_columns(const DerivedTrack& derived, std::size_t index, int count) const {
  const SegmentShape& shape = derived.shape_at(index);
  SegmentSupports found{.form = SupportForm::column, .places = count};
  for (int k = 0; k < count; ++k) {
    const double s = shape.arc.length() * (k + 0.5) / count;
    if (in_tunnel(derived.starts[index] + s)) continue;
    const Ring at = ring_at(shape, s);
    const bool held = try_forms(at, form_of(shape), {ground_}, [&](std::span<const Bar> bars) {
      const auto is_free = [&](const Bar& bar) { return is_clear(derived, lanes_, bar, {index, s}); };
      const bool clear = apart(bars, found.bars) && std::ranges::all_of(bars, is_free);
      if (clear) found.bars.insert(found.bars.end(), bars.begin(), bars.end());
      return clear;
    });
    if (held) found.holds.push_back(at);
  }
  return found;
}

// One bent stands at the segment's start and the others in equal steps. The ribbons of the last one lead to where the
// next segment begins.
SegmentSupports Supports::find_bents(const DerivedTrack& derived, std::size_t index, SupportSpacing spacing,
                                     int count) const {
  const SegmentShape& shape = derived.shape_at(index);
  SegmentSupports found{.form = SupportForm::bent, .places = count};
  std::optional<Bent> before;
  const bool linked = spacing.every == 1;
  for (int k = 0; k < count + (linked ? 1 : 0); ++k) {
    const double s = shape.arc.length() * k / std::max(count, 1);
    std::optional<Bent> bent = bent_at(ring_at(shape, s), form_of(shape), {ground_});
    if (bent && in_tunnel(derived.starts[index] + s)) bent.reset();
    if (bent && !std::ranges::all_of(bent->legs(), [&](const Bar& leg) {
          return is_clear(derived, lanes_, leg, {index, s});
        }))
      bent.reset();
    if (bent && before) add_ribbons(*before, *bent, k, found.braces);
    if (bent && k < count) {
      const std::array<Bar, 2> legs = bent->legs();
      found.bars.insert(found.bars.end(), legs.begin(), legs.end());
      add_braces(*bent, found.braces);
      found.holds.push_back(bent->hold);
    }
    before = bent;
  }
  return found;
}

void Supports::find_if_stale(const DerivedTrack& derived, std::size_t index) {
  Entry& entry = entries_.get(derived.order[index]);
  if (!std::exchange(entry.stale, false)) return;
  ++rebuilds_;
  if (lanes_.empty()) {
    lanes_.resize(derived.order.size());
    for (std::size_t k = 0; k < order_.size(); ++k) lanes_[places_[k]] = &entries_.get(order_[k]).lane;
  }
  const bool bents = form_of(derived.made.kind).supports == SupportForm::bent;
  SegmentSupports found =
      bents ? find_bents(derived, index, entry.spacing, entry.count) : find_columns(derived, index, entry.count);
  const bool same =
      found.form == entry.found.form && found.bars == entry.found.bars && found.braces == entry.found.braces;
  found.build = same && entry.found.build != 0 ? entry.found.build : ++last_build_;
  entry.found = std::move(found);
}

bool Supports::in_tunnel(double distance) const {
  return ground_ != nullptr && ground_->tunnel_at(distance) != nullptr;
}

// The supports of a segment are found again where the ground under their reach changed.
bool Supports::take_ground(const Ground* ground) {
  ground_ = ground != nullptr && !ground->plain() ? ground : nullptr;
  const std::uint64_t build = ground_ != nullptr ? ground_->build() : 0;
  if (std::exchange(ground_build_, build) == build) return false;
  bool moved = false;
  for (Entry& entry : entries_.items()) {
    const std::uint64_t under = ground_ != nullptr ? ground_->build_under(entry.reach) : 0;
    if (std::exchange(entry.ground, under) != under) entry.stale = moved = true;
  }
  return moved;
}

void Supports::update(const DerivedTrack& derived, const NearSegments& near, const Ground* ground) {
  rebuilds_ = 0;
  moved_.clear(), lanes_.clear();
  if (const SolidsDetail detail = near.detail(detail_of(derived)); !(detail == detail_)) {
    const std::uint64_t last_build = last_build_;
    *this = {};  // recomputes everything
    detail_ = detail, last_build_ = last_build;
  }
  if (!detail_.parts) return;  // count_ is 0
  const bool closes = std::exchange(closed_, derived.closed) != derived.closed;
  const bool others = gather(derived, near) || closes;
  take_shapes(derived);
  if (others) drop_others(derived);
  if (others && !near.everywhere()) forget_far();
  const bool raised = take_ground(ground);
  if (!moved_.empty() || others) {
    take_turns();
    mark_disturbed();
  } else if (near.everywhere() && !raised) {
    return;
  }
  count_ = 0;
  const auto find = [&](std::size_t index) {
    find_if_stale(derived, index);
    count_ += static_cast<int>(entries_.get(derived.order[index]).found.holds.size());
  };
  for (const std::size_t index : near.everywhere() ? places_ : near_)
    if (!base::interrupted()) find(index);
  ground_ = nullptr;
}

const SegmentSupports* Supports::of(world::Entity segment) const {
  const Entry* const entry = entries_.find(segment);
  return entry ? &entry->found : nullptr;
}

}  // namespace coaster::sim
