// What the track's curve is: the rails or the riders' heartline.
#include <utility>

#include <fmt/format.h>

#include "edit/commands/commands_operation.h"
#include "edit/perform/perform.h"
#include "sim/plan/switch_curve.h"

namespace coaster::edit {

using base::Status;

Status perform(Session& session, Change& change, const SetCurve& command) {
  if (session.document.curve == command.to) return {};
  if (command.keep == Keep::numbers) {
    session.document.curve = command.to;
    return {};
  }
  base::Result<sim::SwitchedCurve> switched = sim::switch_curve(session.document, session.derived, command.to);
  if (!switched) return switched.status();
  const world::Track& track = switched->document.track;
  if (const Status room = room_for(session, track.knots.size(), track.segments.size()); !room) return room;
  // Moving trains stay where they are on the rails.
  for (world::CartMotion& cart : session.motion.carts.items()) {
    const sim::SegmentShape* const former = session.derived.segments.find(cart.segment);
    if (!former) continue;
    const sim::CurvePlace now = switched->place(session.derived, {cart.segment, former->arc.parameter(cart.s)});
    const curve::ArcLengthMap& arc = switched->shapes.shape(now.segment).arc;
    cart.segment = now.segment, cart.s = arc.distance(now.t), cart.segment_length = arc.length();
  }
  session.document = std::move(switched->document);
  change.note = fmt::format("The rails moved by at most {:.1f} mm. Added {} {}.", 1000 * switched->max_error,
                            switched->added, switched->added == 1 ? "knot" : "knots");
  return {};
}

}  // namespace coaster::edit
