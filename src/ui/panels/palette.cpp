// The buttons of the elements: one for each row of the table, the selected one highlighted and ticked. The panel
// Elements: the parameters of the selected element, its preview at the track's open end, and placing it.
#include "ui/panels/palette.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include <fmt/format.h>

#include "base/text.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/set_setting.h"
#include "sim/ground/ground.h"
#include "sim/plan/element_plan.h"
#include "sim/study/complete_circuit.h"
#include "sim/study/jolt.h"
#include "ui/context/query_widgets.h"
#include "ui/panels/element_equipment_fields.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/icons.h"
#include "ui/widgets/theme.h"
#include "world/aid_settings.h"
#include "world/element_rows.h"
#include "world/panel_settings.h"

namespace coaster::ui {
namespace {

using world::EditingAids;
using world::ElementKind;

// Shows the element's preview; hides it if it shows already (`chosen`).
void choose(Ui& ui, ElementKind kind, bool chosen) {
  const world::Settings& settings = ui.session().settings;
  if (settings.aids->circuit > 0) ui.emit(edit::Set<&EditingAids::circuit>{0});
  if (chosen) ui.emit(edit::Set<&EditingAids::show_element>{false});
  else choose_element(ui, kind);
}

struct ButtonFace {
  const VectorIcon& icon;
  std::string label, help;
  bool on, enabled = true;
};

// A button of the grid. The one that is on also has a frame, so that colour is not the only difference.
bool face_button(Ui& ui, const ButtonFace& face, const PaletteGrid& grid) {
  if (face.on) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
  const IconPlace place = grid.labels ? IconPlace::above : IconPlace::alone;
  // A button that is on hides what it showed: not by the second press of a double click.
  const bool pressed = icon_button(ui, face.icon, face.label, face.help, face.enabled, grid.cell_width, place) &&
                       !(face.on && ImGui::GetIO().MouseClickedLastCount[0] == 2);
  if (!face.on) return pressed;
  ImGui::PopStyleColor();
  ImGui::GetWindowDrawList()->AddRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(), packed(palette().text),
                                      ImGui::GetStyle().FrameRounding, 0, std::max(1.0f, std::floor(1.5f * ui.scale)));
  return pressed;
}

void next_cell(int& cell, const PaletteGrid& grid) {
  if (cell++ % grid.columns != 0) ImGui::SameLine();
}

// Returns the label of a button: the row's, or a shorter one. Scripts may use either.
std::string label_of(ElementKind kind) {
  const world::ElementRow& row = base::row_of(kind);
  return row.button.empty() ? std::string(row.label) : fmt::format("{}###{}", row.button, row.label);
}

// Returns the number of cells used.
int element_buttons(Ui& ui, const PaletteGrid& grid) {
  const world::Settings& settings = ui.session().settings;
  if (settings.aids->show_element)
    ui.inputs.elements[static_cast<std::size_t>(settings.element.kind)] = settings.element;
  const std::span<const world::ElementRow> rows = world::elements();
  int cell = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    next_cell(cell, grid);
    const auto kind = static_cast<ElementKind>(i);
    const bool chosen = settings.aids->show_element && settings.element.kind == kind;
    const std::string help =
        grid.labels ? std::string(rows[i].help) : fmt::format("{}. {}", rows[i].label, rows[i].help);
    if (face_button(ui, {icon_of(kind), label_of(kind), help, chosen}, grid)) choose(ui, kind, chosen);
  }
  return cell;
}

constexpr std::string_view kForces = "Forces";

void forces_button(Ui& ui, const PaletteGrid& grid, int cell) {
  next_cell(cell, grid);
  const world::Settings& settings = ui.session().settings;
  const bool of_forces = world::is_of_forces(settings.element.kind), on = settings.aids->show_element && of_forces;
  if (of_forces) ui.inputs.of_forces = settings.element.kind;
  constexpr std::string_view kHelp =
      "Forces. Track from what riders feel: hills, valleys, turns, rolls and loops at constant g, whose keys you edit "
      "in the force graph.";
  if (face_button(ui, {icon_of(world::first_of_forces()), std::string(kForces), std::string(kHelp), on}, grid))
    choose(ui, ui.inputs.of_forces, on);
}

constexpr std::string_view kByHand = "Draw knots";

void by_hand_button(Ui& ui, const PaletteGrid& grid, int cell) {
  next_cell(cell, grid);
  const bool on = ui.session().settings.aids->append_mode, usable = append_mode_switches(ui.session());
  const std::string help = fmt::format(
      "Draw track by hand: click on the ground to append knots to an open track. {} "
      "ends it.",
      ui.keys.shown("Cancel"));
  if (face_button(ui, {kPencilIcon, std::string(kByHand), with_keys(ui.keys, help, "Append points"), on, usable}, grid))
    ui.emit(edit::Set<&EditingAids::append_mode>{!on});
}

constexpr std::string_view kCompleteCircuit = "Complete circuit", kCircuitLabel = "Circuit###Complete circuit";

void circuit_cell(Ui& ui, const PaletteGrid& grid, int cell) {
  next_cell(cell, grid);
  const bool open = completable(ui.session().document), on = open && ui.session().settings.aids->circuit > 0;
  const std::string help = with_keys(ui.keys, fmt::format("{}. {}", kCompleteCircuit, kCircuitHelp), kCompleteCircuit);
  if (face_button(ui, {kCircuitIcon, std::string(kCircuitLabel), help, on, open}, grid)) toggle_proposals(ui);
}

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
  const sim::Land& land = ui.find.ground().land();
  if (const double depth = sim::depth_of(plan, land); depth > 0)
    read_out(ui, land.plain() ? "Below ground###In the ground" : "Under water###In the ground", depth, 1, "m",
             land.plain() ? "Depth below the ground. That part is red." : "Depth of the water. That part is red.",
             true);
  if (const double missing = sim::worst(ui.find.room()); missing > 0)
    read_out(ui, "Missing clearance###Lacks room", missing, 1, "m",
             "Missing clearance to other track. That part is yellow.", true);
  for (const std::string& line : plan.lines) tinted(in_units(ui, line), palette().warning);
}

void circuit_button(Ui& ui) {
  if (wide_button(ui, "Complete circuit", with_keys(ui.keys, kCircuitHelp, "Complete circuit"),
                  completable(ui.session().document)))
    toggle_proposals(ui);
}

// Shows the closing sections during their preview.
void closing_sections(Ui& ui) {
  const world::EditingAids& aids = *ui.session().settings.aids;
  if (aids.circuit <= 0 || !completable(ui.session().document)) return;
  if (ui.session().history.in_gesture) return tinted("The proposals show again after the drag.", palette().dim);
  const sim::CircuitProposals& found = ui.find.circuit();
  if (!found.refusal.empty()) return tinted(in_units(ui, base::sentence(found.refusal)), palette().warning);
  const std::size_t at = shown_proposal(aids, found);
  const sim::CircuitProposal& way = found.list[at];
  read_out(ui, "Proposal###Way home", fmt::format("{} of {}", at + 1, found.list.size()), "",
           fmt::format("{} shows the next one.", ui.keys.shown("Panels")));
  read_out(ui, "Total length###Length home", way.plan.length, 1, "m", "Length of this closing section.");
  read_out(ui, "Worst g", way.felt.most, 1, "g", "Largest vertical felt g on this closing section, not low-passed.");
  const double jolt = ui.find.closing_jolt(at);
  read_out(ui, "Worst jolt", jolt, 1, "g",
           "Largest sudden change of felt g at the joints of this closing section, low-passed.",
           jolt > sim::kJoltLimit);
  if (found.assumed)
    tinted(in_units(ui, fmt::format("No train reaches the open end. Planned for {} m/s.", base::to_text(found.speed))),
           palette().warning);
  const std::string help = fmt::format("Close the track by this section. {} hides it.", ui.keys.shown("Cancel"));
  if (found.list.size() > 1 && wide_button(ui, "Next proposal###Next way home", "Show the next closing section."))
    next_proposal(ui);
  if (wide_button(ui, "Place proposal###Place way home", with_keys(ui.keys, help, "Place element"))) place_proposal(ui);
}

}  // namespace

int palette_size() { return static_cast<int>(world::elements().size()) + 3; }

float palette_label_width(float scale) {
  float widest = std::max(small_size(kByHand).x, small_size(shown(kCircuitLabel)).x);
  for (std::size_t i = 0; i < world::elements().size(); ++i)
    widest = std::max(widest, small_size(shown(label_of(static_cast<ElementKind>(i)))).x);
  return widest + std::floor(3 * scale);
}

void build_palette_of_elements(Ui& ui, const view::Viewport& area, const PaletteGrid& grid) {
  const float pad = std::floor(8 * ui.scale), gap = std::floor(4 * ui.scale);
  const WindowArea look{.id = "##palette",
                        .panel = "Elements",
                        .padding = ImVec2(pad, pad),
                        .more = ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse};
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(gap, gap));
  build_area(ui, area, look, [&] {
    const int used = element_buttons(ui, grid);
    forces_button(ui, grid, used);
    by_hand_button(ui, grid, used + 1);
    circuit_cell(ui, grid, used + 2);
  });
  ImGui::PopStyleVar();
}

void build_drawer(Ui& ui, const view::Viewport& area) {
  build_area(ui, area, {.id = "##drawer", .panel = "Parameters", .raised = true}, [&] {
    const bool open = ui.drawers.parameters.open;
    const bool fits = area.height + text_size("Parameters").x <= area.width;
    const std::string help =
        with_keys(ui.keys, "Parameters of the chosen element, of the selection, or of the track.", "Parameters");
    if (fold(ui, fits ? "Parameters" : "Values", open, help, {area.width, area.height})) ui.drawers.parameters.toggle();
  });
}

void all_element_buttons(Ui& ui) {
  const float room = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
  PaletteGrid grid{.labels = true};
  const float widest = palette_label_width(ui.scale);
  grid.columns = std::clamp(static_cast<int>((room + gap) / (widest + gap)), 1, 4);
  grid.cell_width = std::floor((room - gap * static_cast<float>(grid.columns - 1)) / static_cast<float>(grid.columns));
  forces_button(ui, grid, element_buttons(ui, grid));
}

void elements_panel(Ui& ui) {
  const edit::Session& session = ui.session();
  if (session.settings.panels->workspace == world::Workspace::all) {  // else they are in the palette
    all_element_buttons(ui);
    circuit_button(ui);
  }
  closing_sections(ui);
  if (!session.settings.aids->show_element) return;
  parameters(ui);
  const sim::ElementPlan& plan = ui.find.element();
  const bool possible = plan.refusal.empty();
  if (!possible) tinted(in_units(ui, base::sentence(plan.refusal)), palette().warning);
  const std::string help =
      fmt::format("Place the element at the open end of the track. {} hides the preview.", ui.keys.shown("Cancel"));
  if (wide_button(ui, "Place", with_keys(ui.keys, help, "Place element"), possible)) place_shown_element(ui);
  if (possible) outcome(ui, plan);
}

}  // namespace coaster::ui
