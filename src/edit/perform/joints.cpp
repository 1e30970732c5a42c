// Commands that repair joints.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "edit/commands/commands_document.h"
#include "edit/perform/joint_repair.h"
#include "edit/perform/perform.h"

namespace coaster::edit {
namespace {

using base::Status;

constexpr std::size_t kMostNamed = 4;  // refused joints named in a notice

std::string as_movement(double value) {
  return value >= 1.0 ? base::to_text(std::round(value * 1e3) / 1e3) + " m"
                      : base::to_text(std::round(value * 1e6) / 1e3) + " mm";
}

std::string told(const world::Document& document, const RepairReport& report) {
  std::string text =
      fmt::format("Made {} {} G2 by moving {}. {} were G2 already.", report.changed,
                  report.changed == 1 ? "joint" : "joints", as_movement(report.movement), report.already);
  if (report.refused.empty()) return text;
  text += fmt::format(" {} cannot be made G2: ", report.refused.size());
  for (std::size_t i = 0; i < std::min(kMostNamed, report.refused.size()); ++i)
    text += fmt::format("{}@{} ({})", i ? ", " : "", world::label_of(document, report.refused[i].knot),
                        report.refused[i].reason);
  return text + (report.refused.size() > kMostNamed ? ", ..." : ".");
}

}  // namespace

Status perform(Session& session, Change& change, const MakeG2& command) {
  const auto e = require(session, command.knot, world::Kind::knot);
  if (!e) return e.status();
  const std::size_t index = *world::index_of(session.document.track.knots, *e);
  double movement = 0;
  const world::Document before = session.document;
  const Status status = make_g2(session.document, index, &movement);
  if (!status) return status;
  change.note = before == session.document ? "The joint is G2 already."
                                           : fmt::format("Made the joint G2 by moving {}.", as_movement(movement));
  return {};
}

Status perform(Session& session, Change& change, const MakeAllG2&) {
  world::Document next = session.document;
  const RepairReport report = make_all_g2(next);
  const std::string text = told(session.document, report);
  if (report.changed == 0 && !report.refused.empty()) return refused(text);
  session.document = std::move(next);
  change.note = text;
  return {};
}

}  // namespace coaster::edit
