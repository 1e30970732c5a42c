// Elements: the parameters of the selected element, its preview at the track's open end, and placing it.
#include <imgui.h>

#include <cmath>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_elements.h"
#include "sim/plan/elements.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/jolt.h"
#include "ui/context/rows.h"
#include "ui/context/ways_home.h"
#include "ui/panels/element_fields.h"
#include "ui/panels/palette.h"
#include "ui/tools/palette_element.h"
#include "ui/widgets/theme.h"
#include "world/aids.h"
#include "world/element_rows.h"
#include "world/panels.h"

namespace coaster::ui {
namespace {

using world::Element;

// Two buttons side by side, so that each needs one click.
void kinds_of_forces(Ui& ui) {
  const world::ElementKind now = ui.session().settings.element.kind;
  const std::span<const world::ElementRow> rows = world::force_elements();
  const float middle = ImGui::GetCursorPosX() + std::floor(ImGui::GetContentRegionAvail().x / 2);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto kind = static_cast<world::ElementKind>(world::elements().size() + i);
    if (i % 2 == 1) ImGui::SameLine(middle);
    if (radio(ui, rows[i].label, kind == now, rows[i].help) && kind != now)
      ui.emit(edit::ChooseElement{ui.inputs.elements[static_cast<std::size_t>(kind)]});
  }
}

void parameters(Ui& ui) {
  Element element = ui.session().settings.element;
  ui.inputs.elements[static_cast<std::size_t>(element.kind)] = element;
  if (world::is_of_forces(element.kind)) kinds_of_forces(ui);
  if (!element_fields(ui, element)) return;
  std::vector<std::string> lines;  // said at once: those of the preview may be out of sight
  sim::clamp_values(element, lines);
  for (const std::string& line : lines) ui.warn(in_units(ui, line));
  ui.emit(edit::ChooseElement{element});
}

void outcome(Ui& ui, const sim::ElementPlan& plan) {
  read_query(ui, "Spans", "element.spans", "Cubic Bézier spans, as few as stay within 1 cm of the ideal curve.",
             {.decimals = 0});
  read_query(ui, "Total length", "element.length", "Length including the lead-in from the open end.", {.decimals = 1});
  read_query(ui, "Fit error", "element.error", "Largest distance between the ideal curve and the spans.",
             {.decimals = 1, .unit = "mm", .factor = 1000});
  if (plan.lowest < 0)
    read_out(ui, "Below ground###In the ground", -plan.lowest, 1, "m", "Depth below the ground. That part is red.",
             true);
  if (const double missing = sim::worst(ui.find.room()); missing > 0)
    read_out(ui, "Missing clearance###Lacks room", missing, 1, "m",
             "Missing clearance to other track. That part is yellow.", true);
  for (const std::string& line : plan.lines) tinted(in_units(ui, line), palette().warning);
}

void circuit_button(Ui& ui) {
  if (button(ui, "Complete circuit", with_keys(ui.keys, kCircuitHelp, "Complete circuit"),
             completable(ui.session().document), ImGui::GetContentRegionAvail().x))
    toggle_ways_home(ui);
}

// Shows the ways home during their preview.
void ways_home(Ui& ui) {
  const world::Aids& aids = *ui.session().settings.aids;
  if (aids.circuit <= 0 || !completable(ui.session().document)) return;
  if (ui.session().history.in_gesture) return tinted("The proposals show again after the drag.", palette().dim);
  const float width = ImGui::GetContentRegionAvail().x;
  const sim::CircuitProposals& found = ui.find.circuit();
  if (!found.refusal.empty()) return tinted(in_units(ui, base::sentence(found.refusal)), palette().warning);
  const std::size_t at = shown_way_home(aids, found);
  const sim::CircuitProposal& way = found.list[at];
  read_out(ui, "Proposal###Way home", fmt::format("{} of {}", at + 1, found.list.size()), "",
           fmt::format("{} shows the next one.", ui.keys.shown("Panels")));
  read_out(ui, "Total length###Length home", way.plan.length, 1, "m", "Length of this closing section.");
  read_out(ui, "Worst g", way.felt.most, 1, "g", "Largest vertical felt g on this closing section, not low-passed.");
  const double jolt = ui.find.way_jolt(at);
  read_out(ui, "Worst jolt", jolt, 1, "g",
           "Largest sudden change of felt g at the joints of this closing section, low-passed.",
           jolt > sim::kJoltLimit);
  if (found.assumed)
    tinted(in_units(ui, fmt::format("No train reaches the open end. Planned for {} m/s.", base::to_text(found.speed))),
           palette().warning);
  const std::string help = fmt::format("Close the track by this section. {} hides it.", ui.keys.shown("Cancel"));
  if (found.list.size() > 1 &&
      button(ui, "Next proposal###Next way home", "Show the next closing section.", true, width))
    next_way_home(ui);
  if (button(ui, "Place proposal###Place way home", with_keys(ui.keys, help, "Place element"), true, width))
    place_way_home(ui);
}

}  // namespace

void elements_panel(Ui& ui) {
  const edit::Session& session = ui.session();
  if (session.settings.panels->workspace == world::Workspace::all) {  // else they are in the palette
    all_element_buttons(ui);
    circuit_button(ui);
  }
  ways_home(ui);
  if (!session.settings.aids->show_element) return;
  parameters(ui);
  const sim::ElementPlan& plan = ui.find.element();
  const bool possible = plan.refusal.empty();
  if (!possible) tinted(in_units(ui, base::sentence(plan.refusal)), palette().warning);
  const std::string help =
      fmt::format("Place the element at the open end of the track. {} hides the preview.", ui.keys.shown("Cancel"));
  if (button(ui, "Place", with_keys(ui.keys, help, "Place element"), possible, ImGui::GetContentRegionAvail().x))
    place_shown_element(ui);
  if (possible) outcome(ui, plan);
}

}  // namespace coaster::ui
