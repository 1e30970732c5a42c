// Picking the curve: the positions of segments near the line of sight, and the choice between them.
#include <algorithm>
#include <vector>

#include "sim/shape/derived.h"
#include "view/beam.h"
#include "view/pick.h"
#include "view/sighted_curve.h"

namespace coaster::view {
namespace {

constexpr double kSameDepth = 1e-3;  // of the depth: closer positions do not hide each other
constexpr double kSamePlace = 1e-4;  // px: accuracy of pixel coordinates in float

struct Candidate {
  std::size_t index = 0;  // index of the segment in the track
  double t = 0;
  double distance = 0;  // px
  double depth = 0;     // m
};

bool is_earlier(const Candidate& a, const Candidate& b) { return a.index != b.index ? a.index < b.index : a.t < b.t; }

// The end of a segment counts only if the neighbour does not come nearer beyond it.
bool is_nearest_at_joint(const sim::Derived& derived, const Beam& beam, const Candidate& at) {
  const std::size_t count = derived.order.size();
  if (at.t == 0) {
    if (at.index == 0 && !derived.closed) return true;
    const std::size_t before = at.index == 0 ? count - 1 : at.index - 1;
    return slope_at_end(sighted(derived.tree.cubics[before], beam), 1) <= 0;
  }
  if (at.t == 1) {
    if (at.index + 1 == count && !derived.closed) return true;
    const std::size_t after = at.index + 1 == count ? 0 : at.index + 1;
    return slope_at_end(sighted(derived.tree.cubics[after], beam), 0) >= 0;
  }
  return true;
}

// Collects the candidates while segments are visited in any order.
class Search {
 public:
  Search(const sim::Derived& derived, const Beam& beam, const View& view, double reach)
      : derived_(derived),
        beam_(beam),
        least_(kNowhere),
        reach_(reach),
        one_behind_another_(kOneBehindAnother * static_cast<double>(view.density)) {}

  // Positions farther away than this cannot win, px.
  double limit() const { return std::min(reach_, least_ + one_behind_another_); }

  void look_at(std::size_t index) {
    const SightedControls controls = sighted(derived_.tree.cubics[index], beam_);
    if (!may_come_near(controls, limit())) return;
    for (const SightedPlace& place : nearest_places(controls)) {
      const double distance = std::sqrt(place.square);
      if (!(distance <= limit())) continue;
      least_ = std::min(least_, distance);
      candidates_.push_back(
          {index, place.t, distance, beam_.depth(place.depth, curve::point(derived_.tree.cubics[index], place.t))});
    }
  }

  // Returns the winner by the rule in pick.h, independent of the order of the visits.
  const Candidate* meant() {
    std::erase_if(candidates_,
                  [&](const Candidate& c) { return c.distance > limit() || !is_nearest_at_joint(derived_, beam_, c); });
    double front = kNowhere, nearest = kNowhere;
    for (const Candidate& c : candidates_) front = std::min(front, c.depth);
    const double farthest = beam_.same_depth() > 0 ? front + beam_.same_depth() : front * (1 + kSameDepth);
    const auto in_front = [&](const Candidate& c) { return c.depth <= farthest; };
    for (const Candidate& c : candidates_)
      if (in_front(c)) nearest = std::min(nearest, c.distance);
    const Candidate* best = nullptr;
    for (const Candidate& c : candidates_)
      if (in_front(c) && c.distance <= nearest + kSamePlace && (!best || is_earlier(c, *best))) best = &c;
    return best;
  }

 private:
  const sim::Derived& derived_;
  const Beam& beam_;
  double least_, reach_, one_behind_another_;  // px
  std::vector<Candidate> candidates_;
};

std::optional<Pick> picked(const sim::Derived& derived, const Candidate* place) {
  if (!place) return std::nullopt;
  return Pick{PickKind::curve, derived.order[place->index], place->t,
              glm::vec3(curve::point(derived.tree.cubics[place->index], place->t))};
}

}  // namespace

std::optional<Pick> pick_curve(const sim::Derived& derived, const View& view, glm::vec2 pixel, float reach) {
  const Beam beam(view, pixel);
  Search search(derived, beam, view, reach);
  (void)visit_near(
      derived.tree, beam, [&] { return search.limit(); }, [&](std::size_t index) { search.look_at(index); });
  return picked(derived, search.meant());
}

std::optional<Pick> pick_curve_of_all(const sim::Derived& derived, const View& view, glm::vec2 pixel, float reach) {
  const Beam beam(view, pixel);
  if (!beam.has_eye()) return std::nullopt;
  Search search(derived, beam, view, reach);
  for (std::size_t i = 0; i < derived.order.size(); ++i) search.look_at(i);
  return picked(derived, search.meant());
}

std::optional<Pick> pick_segment(const sim::Derived& derived, const View& view, glm::vec2 pixel,
                                 world::Entity segment) {
  const sim::SegmentShape* const shape = derived.segments.find(segment);
  const Beam beam(view, pixel);
  if (shape == nullptr || !beam.has_eye()) return std::nullopt;
  const SightedPlaces places = nearest_places(sighted(shape->key.cubic, beam));
  const SightedPlace* const best =
      std::min_element(places.begin(), places.end(), [](const auto& a, const auto& b) { return a.square < b.square; });
  if (best == places.end()) return std::nullopt;
  return Pick{PickKind::curve, segment, best->t, glm::vec3(curve::point(shape->key.cubic, best->t))};
}

}  // namespace coaster::view
