#include "sim/solids/support_forms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sim/solids/supports.h"
#include "sim/solids/track_mesh.h"

namespace coaster::sim {
namespace {

using glm::dvec3;

constexpr double kHigh = 15;         // m: higher track gets two legs
constexpr double kStrutted = 9;      // m: longer legs have a strut between them
constexpr double kUpright = -0.1;    // vertical component of the frame's up: below it the track is inverted
constexpr double kLevelPart = 0.35;  // horizontal part of a direction that counts as sideways

struct Site {
  dvec3 top;  // on the spine's axis
  double height, radius;
  dvec3 side;     // level, perpendicular to the track
  dvec3 back{0};  // level, away from the riders; zero on level track
  bool upright;
};

dvec3 level(dvec3 v) { return {v.x, 0, v.z}; }

Site site_at(const Ring& at) {
  Site site{};
  site.top = at.position - kSpineDrop * at.frame.up;
  site.height = site.top.y;
  site.radius = std::clamp(0.13 + 0.0055 * site.height, 0.13, 0.36);
  const dvec3 across(at.frame.forward.z, 0, -at.frame.forward.x), left = level(at.frame.left());
  site.side = glm::length(across) > 0.2 ? glm::normalize(across)
              : glm::length(left) > 0.2 ? glm::normalize(left)
                                        : dvec3(1, 0, 0);
  const dvec3 back = level(-at.frame.up);
  if (glm::length(back) > kLevelPart) site.back = glm::normalize(back);
  site.upright = at.frame.up.y > kUpright;
  return site;
}

Bar bar(dvec3 from, dvec3 to, double from_radius, double to_radius, bool grounded) {
  return {glm::vec3(from), glm::vec3(to), static_cast<float>(from_radius), static_cast<float>(to_radius), grounded};
}

dvec3 on_ground(dvec3 p) { return {p.x, 0, p.z}; }

class FormTrial {
 public:
  FormTrial(const Site& site, const std::function<bool(std::span<const Bar>)>& takes) : site_(site), takes_(takes) {}

  bool leg(double aside) const {
    return takes_(
        std::array{bar(site_.top, on_ground(site_.top + aside * site_.side), 0.8 * site_.radius, site_.radius, true)});
  }
  bool two_legs(double spread) const {
    const auto one = [&](double way) {
      return bar(site_.top, on_ground(site_.top + way * spread * site_.side), 0.7 * site_.radius, 0.9 * site_.radius,
                 true);
    };
    const Bar a = one(1), b = one(-1);
    if (site_.height < kStrutted) return takes_(std::array{a, b});
    constexpr float kDown = 0.55f;  // of the legs' height
    const double thin = 0.55 * site_.radius;
    return takes_(std::array{
        a, b, bar(dvec3(glm::mix(a.from, a.to, kDown)), dvec3(glm::mix(b.from, b.to, kDown)), thin, thin, false)});
  }
  // An arm that slopes down outwards on upright track and is level on inverted track.
  bool arm(dvec3 direction, double out) const {
    const dvec3 elbow = site_.top + out * direction - dvec3(0, site_.upright ? 0.25 * out : 0.0, 0);
    if (direction == dvec3(0) || elbow.y < kLowestSupport) return false;
    const double r = site_.radius;
    return takes_(std::array{bar(site_.top, elbow, 0.8 * r, r, false),
                             bar(elbow + dvec3(0, 0.5 * r, 0), on_ground(elbow), r, 1.1 * r, true)});
  }

 private:
  const Site& site_;
  const std::function<bool(std::span<const Bar>)>& takes_;
};

}  // namespace

bool try_forms(const Ring& at, const std::function<bool(std::span<const Bar>)>& takes) {
  const Site site = site_at(at);
  if (site.height < kLowestSupport) return false;
  const FormTrial trial(site, takes);
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

}  // namespace coaster::sim
