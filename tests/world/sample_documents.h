// Documents for tests: skew, off-origin, non-dyadic; one built by hand and a family of random ones.
#pragma once

#include <random>

#include "world/topology.h"

namespace coaster::test {

inline world::Knot skew_knot(glm::vec3 position, glm::vec3 tangent, float in, float out,
                             world::JointKind joint = world::JointKind::aligned) {
  world::Knot knot;
  knot.position = position;
  knot.joint = joint;
  knot.in_length = in, knot.out_length = out;
  world::set_tangent(knot, tangent);
  return knot;
}

// Five knots k1..k5 (k1 and k5 smooth, k4 automatic), segments s1..s4, carts c1 on s2 and c2 on s4.
inline world::Document sample_document() {
  world::Document d;
  d.name = "Skew \"sample\"";
  d.start_speed = 3.3, d.datum = -1.7;
  const auto smooth = world::JointKind::smooth;
  world::append_knot(d, skew_knot({103.7f, 12.3f, -41.9f}, {0.9f, 0.21f, 0.31f}, 7.1f, 7.1f, smooth));
  world::append_knot(d, skew_knot({131.3f, 19.7f, -37.1f}, {0.7f, -0.3f, 0.6f}, 6.3f, 9.7f));
  world::append_knot(d, skew_knot({149.9f, 7.7f, -11.3f}, {0.1f, 0.45f, 0.9f}, 11.9f, 5.3f));
  world::append_knot(d, skew_knot({143.1f, 17.9f, 13.7f}, {-1, 0, 0}, 5, 5, world::JointKind::automatic));
  world::append_knot(d, skew_knot({117.3f, 5.9f, 29.3f}, {-0.8f, -0.1f, 0.3f}, 8.7f, 8.7f, smooth));
  world::set_roll(d.entities.get<world::Knot>(d.track.knots[1]), 23.7);
  d.entities.get<world::Segment>(d.track.segments[2]).turns = -1;
  world::add_cart(d, d.track.segments[1], 0.37);
  world::add_cart(d, d.track.segments[3], 0.91);
  world::settle_joints(d);
  return d;
}

// Returns a document of 0..12 knots with everything that a document can have; the same for the same seed.
inline world::Document random_document(std::uint32_t seed) {
  std::mt19937 bits(seed);  // its sequence is fixed by the standard
  const auto uniform = [&](double low, double high) { return low + (high - low) * (bits() / 4294967296.0); };
  const auto whole = [&](int below) { return static_cast<int>(bits() % static_cast<unsigned>(below)); };
  world::Document d;
  const int knots = whole(13);
  for (int i = 0; i < knots; ++i) {
    const auto joint = static_cast<world::JointKind>(whole(3));
    const auto length = static_cast<float>(uniform(0.5, 30));
    const auto other = static_cast<float>(uniform(0.5, 30));
    const glm::vec3 tangent(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1.1));
    world::append_knot(d, skew_knot({uniform(-900, 900), uniform(-20, 90), uniform(-900, 900)}, tangent, length,
                                    joint == world::JointKind::smooth ? length : other, joint));
    world::set_roll(d.entities.get<world::Knot>(d.track.knots.back()), uniform(-180, 180));
  }
  if (knots > 2 && whole(2)) world::set_closed(d, true);
  if (knots > 5) world::remove_knot(d, d.track.knots[3]);  // so that numbers have gaps and slots are reused
  if (knots > 7)
    world::append_knot(d.track.closed ? (world::set_closed(d, false), d) : d,
                       skew_knot({7.7f, 3.1f, -9.3f}, {0.3f, 0.1f, -1}, 3.3f, 4.1f));
  for (const world::Entity s : d.track.segments) {
    d.entities.get<world::Segment>(s).turns = whole(5) - 2;
    if (whole(3) == 0) world::add_cart(d, s, uniform(0, 1));
    if (whole(4) == 0) d.entities.put(s, world::UnknownMembers{R"({"wear":0.25,"by":["a",null]})"});
  }
  if (whole(2)) d.extra.json = R"({"author":"Zoë","tags":{"b":1,"a":[2.5,-3]}})";
  d.name = whole(2) ? "Ünï \\ \"q\"" : "plain";
  d.start_speed = uniform(-150, 150), d.datum = uniform(-50, 50);
  world::settle_joints(d);
  for (const world::Entity e : d.track.knots) {
    world::Knot& knot = d.entities.get<world::Knot>(e);
    if (whole(2)) knot.spin = static_cast<float>(uniform(-0.4, 0.4));
    if (whole(2)) knot.spin_kind = world::SpinKind::set;
  }
  for (int i = whole(4); i > 0 && !d.track.segments.empty(); --i) {
    const int count = static_cast<int>(d.track.segments.size()), first = whole(count);
    world::Section section{whole(2) ? "Première" : "", static_cast<world::SectionKind>(whole(2)), {}};
    if (section.kind == world::SectionKind::element)
      section.element = world::usual_element(static_cast<world::ElementKind>(whole(8)));
    const world::Entity made = world::make_section(d, static_cast<std::size_t>(first),
                                                   static_cast<std::size_t>(1 + whole(count - first)), section);
    if (whole(4) == 0) d.entities.put(made, world::UnknownMembers{R"({"theme":"night"})"});
  }
  return d;
}

}  // namespace coaster::test
