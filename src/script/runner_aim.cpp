// aim.*: moves the cursor to an entity's position on the screen, and presses only if the program finds that entity
// under it.
#include <algorithm>

#include <fmt/format.h>

#include "platform/drag_threshold.h"
#include "query/context.h"
#include "script/runner.h"
#include "view/gizmo.h"

namespace coaster::script {
namespace {

using platform::Button;
using platform::MouseButton;
using platform::MouseMove;

constexpr int kDragSteps = 6;

std::string name_of(const world::Document& document, const view::Pick& pick) {
  const std::string label = "@" + world::label_of(document, pick.entity);
  switch (pick.kind) {
    case view::PickKind::none: return "nothing";
    case view::PickKind::handle_in: return label + ".in";
    case view::PickKind::handle_out: return label + ".out";
    case view::PickKind::spin: return label + ".spin";
    case view::PickKind::turn: return label + ".turn";
    case view::PickKind::bank: return label + ".bank";
    case view::PickKind::curve: return fmt::format("{}:{}", label, base::to_text(static_cast<float>(pick.t)));
    default: return view::is_gizmo(pick.kind) ? "the gizmo" : label;
  }
}

// The hovered entity must be the target. Ground and world points may be covered by anything except panels.
Failure check_hover(FrameDriver& frames, const AimAction& aim) {
  const view::PickKind wanted = aim.target.kind;
  if (wanted == view::PickKind::none || !frames.host().hovered) return {};
  const view::Pick found = frames.host().hovered();
  const query::Context context = frames.host().context();
  const world::Document& document = context.session.document;
  if (found.kind == wanted && (view::is_gizmo(wanted) || found.entity == world::find(document, aim.target.name)))
    return {};
  if (found.kind == view::PickKind::none)
    return failed(fmt::format("nothing can be picked at {}: something covers it", aim.target_text), aim.target_column);
  return failed(fmt::format("{} is covered by {}", aim.target_text, name_of(document, found)), aim.target_column);
}

}  // namespace

Failure Runner::perform(const AimAction& aim) {
  const auto at_target = [&](const base::Status& status) { return failure(status, aim.target_column); };
  if (const base::Status status = frames_.settle_panels(); !status) return failure(status);
  const base::Result<glm::vec2> pixel = frames_.host().pixel_of(aim.target);
  if (!pixel) return at_target(pixel.status());
  glm::vec2 end = *pixel;
  if (aim.verb == AimAction::Verb::drag) {
    AimPoint destination;
    if (aim.to) {
      destination = *aim.to;
    } else {
      const base::Result<glm::vec3> from = frames_.host().position_of(aim.target);
      if (!from) return at_target(from.status());
      destination.position = *from + aim.by.value_or(glm::vec3(0));
    }
    const base::Result<glm::vec2> to = frames_.host().pixel_of(destination);
    if (!to) return at_target(to.status());
    end = *to;
    const float length = glm::distance(glm::floor(end), glm::floor(*pixel)) / environment_.density;
    if (length < platform::kDragThreshold)
      return failed(
          fmt::format("the drag is {:.1f} pixels long, and shorter than {} is a click: move the camera nearer", length,
                      platform::kDragThreshold),
          aim.target_column);
  }
  if (const base::Status status = frames_.frame({MouseMove{pixel->x, pixel->y}}); !status) return failure(status);
  if (Failure covered = check_hover(frames_, aim); !covered) return covered;
  if (aim.verb == AimAction::Verb::hover) return {};

  const int clicks = aim.verb == AimAction::Verb::doubleclick ? 2 : 1;
  for (int i = 0; i < clicks; ++i) {
    const std::uint64_t before = frames_.commands();
    if (const base::Status status = frames_.frame({MouseButton{Button::left, true, aim.modifiers}}); !status)
      return failure(status);
    const int steps = aim.verb == AimAction::Verb::drag ? kDragSteps : 0;
    for (int step = 1; step <= steps; ++step) {
      const glm::vec2 at = *pixel + (end - *pixel) * (static_cast<float>(step) / static_cast<float>(steps));
      if (const base::Status status = frames_.frame({MouseMove{at.x, at.y}}); !status) return failure(status);
    }
    const platform::Event up = MouseButton{Button::left, false, aim.modifiers};
    // A click that takes effect at the press leaves the release to the next frame, so that the last frame's numbers
    // show the effect.
    const bool done = frames_.commands() != before && steps == 0 && i + 1 == clicks;
    if (done) frames_.put_off({up});
    else if (const base::Status status = frames_.frame({up}); !status) return failure(status);
  }
  return {};
}

}  // namespace coaster::script
