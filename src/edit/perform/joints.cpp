// Commands that repair joints.
#include <algorithm>
#include <cmath>

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
  std::string text = "made " + std::to_string(report.changed) + (report.changed == 1 ? " joint" : " joints") +
                     " G2 by moving " + as_movement(report.movement) + "; " + std::to_string(report.already) +
                     " were already";
  if (report.refused.empty()) return text;
  text += "; " + std::to_string(report.refused.size()) + " refused: ";
  for (std::size_t i = 0; i < std::min(kMostNamed, report.refused.size()); ++i)
    text += (i ? ", " : "") + std::string("@") + world::label_of(document, report.refused[i].knot) + " (" +
            report.refused[i].reason + ")";
  return text + (report.refused.size() > kMostNamed ? ", ..." : "");
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
  change.note =
      before == session.document ? "the joint is G2 already" : "made the joint G2 by moving " + as_movement(movement);
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
