// Commands of the coaster's kind and paint.
#include <algorithm>

#include <fmt/format.h>

#include "edit/commands/commands_coaster.h"
#include "edit/perform/knot_runs.h"
#include "edit/perform/perform_context.h"

namespace coaster::edit {

using base::Status;

namespace {

// Trains have one paint for the whole track.
Status paint_sections(Session& session, const Sections& named, const auto& change) {
  const auto sections = chosen_sections(session, named);
  if (!sections) return sections.status();
  for (const world::Entity e : *sections) {
    world::Paint& paint = session.document.entities.get<world::Section>(e).paint;
    change(paint);
    paint.train = {};
  }
  return {};
}

}  // namespace

Status perform(Session& session, Change& change, const SetKind& command) {
  world::Document& document = session.document;
  const world::CoasterKindRow &was = base::row_of(document.kind), &is = base::row_of(command.to);
  document.kind = command.to;
  if (document.heartline == was.heartline && is.heartline != was.heartline) {
    document.heartline = is.heartline;
    change.note = fmt::format("The heartline is now {:.1f} m above the rails.", is.heartline);
    if (is.heartline < 0) change.note = fmt::format("Riders hang {:.1f} m below the rails.", -is.heartline);
  }
  if (document.resistance == was.losses) document.resistance = is.losses;
  constexpr float kFeet = 2.6f;  // m below the rails
  const auto& knots = document.entities.pool<world::Knot>().items();
  const auto low = std::ranges::count_if(knots, [](const world::Knot& knot) { return knot.position.y < kFeet; });
  if (is.heartline < 0 && low > 0)
    change.clamped.push_back(fmt::format("Riders' feet hang {} m below the rails: {} {} lower than that.", kFeet, low,
                                         low == 1 ? "knot is" : "knots are"));
  return {};
}

Status perform(Session& session, Change&, const PaintTrack& command) {
  session.document.paint = base::row_of(command.to).paint;
  return {};
}

Status perform(Session& session, Change&, const PaintTrackPart& command) {
  session.document.paint.of(command.part) = command.to;
  return {};
}

Status perform(Session& session, Change&, const PaintSections& command) {
  return paint_sections(session, command.sections,
                        [&](world::Paint& paint) { paint = base::row_of(command.to).paint; });
}

Status perform(Session& session, Change&, const PaintSectionsPart& command) {
  if (command.part == world::PaintPart::train)
    return refused("trains have one paint for the whole track: use paint.colour");
  return paint_sections(session, command.sections, [&](world::Paint& paint) { paint.of(command.part) = command.to; });
}

}  // namespace coaster::edit
