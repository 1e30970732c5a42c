#include "ui/context/ways_home.h"

#include <algorithm>

#include "edit/commands/commands_elements.h"
#include "edit/commands/set_setting.h"
#include "sim/study/complete_circuit.h"
#include "world/aids.h"

namespace coaster::ui {

bool completable(const world::Document& document) { return !document.track.closed && !document.track.segments.empty(); }

std::size_t shown_way_home(const world::Aids& aids, const sim::CircuitProposals& found) {
  const auto wanted = static_cast<std::size_t>(std::max(aids.circuit, 1));
  return std::min(wanted, std::max<std::size_t>(found.list.size(), 1)) - 1;
}

void show_ways_home(Ui& ui) {
  if (ui.session().settings.aids->show_element) ui.emit(edit::Set<&world::Aids::show_element>{false});
  ui.emit(edit::Set<&world::Aids::circuit>{1});
}

void toggle_ways_home(Ui& ui) {
  if (ui.session().settings.aids->circuit > 0) ui.emit(edit::Set<&world::Aids::circuit>{0});
  else show_ways_home(ui);
}

void next_way_home(Ui& ui) {
  const sim::CircuitProposals& found = ui.find.circuit();
  if (found.list.empty()) return;
  const std::size_t next = (shown_way_home(*ui.session().settings.aids, found) + 1) % found.list.size();
  ui.emit(edit::Set<&world::Aids::circuit>{static_cast<int>(next) + 1});
}

void place_way_home(Ui& ui) {
  const sim::CircuitProposals& found = ui.find.circuit();
  ui.emit(edit::CompleteCircuit{static_cast<int>(shown_way_home(*ui.session().settings.aids, found)) + 1});
  if (!found.list.empty()) ui.emit(edit::Set<&world::Aids::circuit>{0});
}

}  // namespace coaster::ui
