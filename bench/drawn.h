// Programs that draw off screen, and the ring that they ride on.
#pragma once

#include <cmath>
#include <memory>
#include <utility>

#include "app/frame.h"
#include "app/program.h"
#include "sim/ride/ride.h"
#include "world/topology.h"

namespace coaster::bench {

// Returns a closed ring with hills, ten metres per segment.
inline world::Document ring(int segments) {
  world::Document document;
  const double radius = segments * 10 / 6.283185307179586;
  for (int i = 0; i < segments; ++i) {
    const double a = 6.283185307179586 * i / segments;
    world::Knot knot;
    knot.position = glm::vec3(radius * std::cos(a), 20 + 8 * std::sin(40 * a), radius * std::sin(a));
    knot.in_length = knot.out_length = 3.33f;
    world::set_tangent(knot, glm::vec3(-std::sin(a), 320 / radius * std::cos(40 * a), std::cos(a)));
    world::append_knot(document, knot);
  }
  world::set_closed(document, true);
  world::add_cart(document, document.track.segments.front(), 0);
  return document;
}

// Returns a program that has drawn the document, off screen; null without off-screen OpenGL.
inline std::unique_ptr<app::Program> open_track(world::Document document, platform::Size size) {
  app::Options options;
  options.headless = true;
  auto program = app::make_program(options, size, 0);
  if (!program.ok()) return nullptr;
  edit::Session& session = (*program)->session;
  session.document = std::move(document);
  sim::derive(session.document, session.settings, session.measuring.clock, session.derived);
  sim::reset(session.document, session.derived, session.motion);
  session.settings.camera.target = session.document.entities.get<world::Knot>(session.document.track.knots[0]).position;
  for (int i = 0; i < 3; ++i) app::run_frame(**program, {platform::Tick{0}}, 0);
  return std::move(*program);
}

}  // namespace coaster::bench
