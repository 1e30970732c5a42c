// Commands that repair joints.
#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/units.h"
#include "edit/commands/commands_document.h"
#include "edit/perform/joint_repair.h"
#include "edit/perform/perform.h"
#include "sim/study/jolt.h"

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

// Returns the step of the force at a fastest passage of the ride, before and after the repair, as a sentence.
std::string told(std::string_view what, std::optional<double> before, std::optional<double> now) {
  if (!before || !now) return fmt::format(" {}: none.", what);
  return fmt::format(" {}: {} g, before {} g.", what, base::figure_text(*now, 3, "g"),
                     base::figure_text(*before, 3, "g"));
}

}  // namespace

Status perform(Session& session, Change& change, const MakeG2& command) {
  const auto e = require(session, command.knot, world::Kind::knot);
  if (!e) return e.status();
  const std::size_t index = *world::index_of(session.document.track.knots, *e);
  double movement = 0;
  const std::span<const sim::Jolt> jolts = Finder(session).jolts();  // of the ride before
  const world::Document before = session.document;
  const Status status = make_g2(session.document, index, &movement);
  if (!status) return status;
  change.note = before == session.document ? "The joint is G2 already."
                                           : fmt::format("Made the joint G2 by moving {}.", as_movement(movement));
  change.note += told("Step of the force at the fastest passage", sim::fastest_step(before, jolts, index),
                      sim::fastest_step(session.document, jolts, index));
  return {};
}

Status perform(Session& session, Change& change, const MakeAllG2&) {
  world::Document next = session.document;
  const RepairReport report = make_all_g2(next);
  const std::string text = told(session.document, report);
  if (report.changed == 0 && !report.refused.empty()) return refused(text);
  const std::span<const sim::Jolt> jolts = Finder(session).jolts();
  change.note = text + told("Largest step of the force at a fastest passage",
                            sim::largest_step(session.document, jolts), sim::largest_step(next, jolts));
  session.document = std::move(next);
  return {};
}

}  // namespace coaster::edit
