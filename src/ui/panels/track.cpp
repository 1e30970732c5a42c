// Track: name, size, adding and deleting parts, start of the ride, file. History: undo and redo steps. Coaster: its
// kind, and the paint of the track or of the selected sections.
#include <imgui.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "edit/commands/commands_document.h"
#include "edit/commands/commands_session.h"
#include "edit/commands/commands_shape.h"
#include "sim/plan/force_plan.h"
#include "sim/ride/equipment.h"
#include "sim/shape/folds.h"
#include "sim/solids/materials.h"
#include "ui/context/query_widgets.h"
#include "ui/context/setting_widgets.h"
#include "ui/context/ui.h"
#include "ui/panels/selected_sections.h"
#include "ui/tools/show_places.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/widgets.h"

namespace coaster::ui {
namespace {

using world::EntityKind;
using world::PaintPart;

// Returns a position where a new cart touches no other at the start of the ride: the start or middle of a segment,
// searched from `first` on. The start of `first` if there is none.
edit::AddTrain free_place(const edit::Session& session, world::Entity first) {
  const sim::DerivedTrack& derived = session.derived;
  const sim::TrackExtent rails{derived.length, derived.closed};
  constexpr double kRoom = 6;  // m
  const auto is_free = [&](double distance) {
    for (const world::Train& other : session.document.entities.pool<world::Train>().items()) {
      const sim::TrainStart start = sim::start_of(session.document, derived, other);
      if (sim::collide(rails, {distance, 1, kRoom, kRoom}, {start.front, start.cars, start.spacing, start.length}))
        return false;
    }
    return true;
  };
  const std::size_t count = derived.order.size();
  const auto found = std::find(derived.order.begin(), derived.order.end(), first);
  const auto begin = static_cast<std::size_t>(found - derived.order.begin());
  for (std::size_t i = 0; i < 2 * count; ++i) {
    const std::size_t index = (begin + i / 2) % count;
    const double fraction = i % 2 == 0 ? 0.0 : 0.5;
    if (is_free(derived.starts[index] + fraction * (derived.starts[index + 1] - derived.starts[index])))
      return {{world::name_of(session.document, derived.order[index])}, fraction};
  }
  return {{world::name_of(session.document, first)}, 0};
}

void size(Ui& ui) {
  read_query(ui, "Length", "length", "Length of the track, by the method selected in Evaluation.", {.decimals = 3});
  read_query(ui, "Segments", "segments", "Cubic Bézier segments.", {.decimals = 0});
  read_query(ui, "Knots", "knots", "Points that the track passes through.", {.decimals = 0});
  colouring_box(ui);
}

// Shows how far the fitted track is from the rows of the imported file.
void deviation(Ui& ui) {
  if (!ui.session().file.import) return;
  const auto row = [&](std::string_view label, std::string_view distance, std::string_view angle,
                       std::string_view tooltip) {
    const double m = number_of(ui, distance).value_or(0), degrees = number_of(ui, angle).value_or(0);
    read_out(ui, label, fmt::format("{}, {}\u00B0", measured(ui, 1e3 * m, 2, "mm"), fixed(degrees, 3)), "", tooltip);
  };
  row("Largest deviation", "import.max_error", "import.frame_error",
      "Largest distance of the imported file's positions from the track, and largest angle between the frames there, "
      "as the file was opened.");
  row("RMS deviation", "import.rms_error", "import.rms_frame_error", "Root mean square of the distances and angles.");
  if (ui.session().file.import->jump_error > 0)
    read_query(ui, "Angle at jumps", "import.jump_error",
               "Largest angle between the frames within 0.5 m of where those of the file jump. The others are above.",
               {.decimals = 3, .unit = "\u00B0"});
}

void conflicts(Ui& ui) {
  constexpr std::string_view kTooltip = "Places where the track lacks clearance from itself.";
  const std::size_t found = ui.find.conflicts_so_far().size();
  if (found == 0) return;
  if (ui.find.all_conflicts()) read_query(ui, "Conflicts", "conflicts", kTooltip, {.decimals = 0, .warns = true});
  else read_out(ui, "Conflicts", fmt::format("{} so far", found), "", kTooltip);
  if (wide_button(ui, "Next conflict", "Go to the next place where the track lacks clearance from itself."))
    show_next_conflict(ui);
}

// Shows the number of folds or tight bends, if there are any, and a button that goes from one to the next.
void bad_places(Ui& ui, std::span<const sim::Fold> found, std::string_view label, std::string_view query,
                std::string_view help, std::string_view next, std::string_view next_help) {
  if (found.empty()) return;
  read_query(ui, label, query, help, {.decimals = 0, .warns = true});
  if (wide_button(ui, next, next_help)) show_next(ui, found);
}

// Returns the command that closes the track: ends that coincide, or nearly do, become one knot.
edit::Command closing(const edit::Session& session) {
  const auto& knots = session.document.track.knots;
  const edit::CloseExactly exactly;
  const auto place = [&](world::Entity knot) { return glm::dvec3(world::knot(session.document, knot).position); };
  if (knots.size() >= 3 && glm::distance(place(knots.front()), place(knots.back())) <= exactly.within) return exactly;
  return edit::SetClosed{true};
}

void building(Ui& ui) {
  const edit::Session& session = ui.session();
  const world::EntityName* selected = session.document.entities.find<world::EntityName>(session.settings.selected);
  const bool on_segment = selected != nullptr && selected->kind == EntityKind::segment;
  const bool removable =
      selected != nullptr && (selected->kind == EntityKind::knot || selected->kind == EntityKind::cart);
  const std::size_t knots = session.document.track.knots.size();
  const bool closed = session.document.track.closed;

  if (const auto to =
          checkbox(ui, "Closed", closed,
                   "Join the last knot to the first, or open the circuit there. Ends that meet become one knot.",
                   closed || knots >= 2))
    ui.emit(*to ? closing(session) : edit::SetClosed{false});
  const std::string help =
      fmt::format("Click on the ground to append a knot to an open track. {} ends it.", ui.keys.shown("Cancel"));
  ui.emit_if<edit::Set<&world::EditingAids::append_mode>>(
      checkbox(ui, "Append points", session.settings.aids->append_mode, with_keys(ui.keys, help, "Append points"),
               append_mode_switches(session)));

  ButtonRows pressed{ui, 2, "Insert point"};
  if (pressed("Add curve",
              with_keys(ui.keys, "Split the longest segment at half its length. The shape is unchanged.", "Add curve")))
    ui.emit(edit::SplitLongestSegment{});
  if (pressed("Insert point",
              with_keys(ui.keys,
                        "Insert a knot at the selected position without changing the shape (de Casteljau). Or "
                        "double-click the curve.",
                        "Insert point"),
              on_segment))
    ui.emit(edit::SplitSegment{{*selected}, session.settings.selected_t});
  if (pressed("Delete", with_keys(ui.keys, "Delete the selected knot or train.", "Delete"), removable))
    ui.emit(edit::RemoveKnotOrTrain{{*selected}});
  const auto& segments = session.document.track.segments;
  if (pressed("Add train###Add cart",
              "Add a train at the first free place from the start of the selected segment, or of the track.",
              !segments.empty()))
    ui.emit(free_place(session, on_segment ? session.settings.selected : segments.front()));
}

void start(Ui& ui) {
  const world::Document& document = ui.session().document;
  const Number speed{.value = document.start_speed,
                     .unit = "m/s",
                     .low = -world::kMaxSpeed,
                     .high = world::kMaxSpeed,
                     .largest = 1e300};
  ui.emit_if<edit::SetStartSpeed>(number(ui, "Start speed", speed, "Start speed of the trains. Negative: backwards."));
  const Number datum{.value = document.datum,
                     .unit = "m",
                     .low = -world::kMaxCoordinate,
                     .high = world::kMaxCoordinate,
                     .largest = 1e300};
  ui.emit_if<edit::SetDatum>(number(ui, "Datum", datum, "Height of zero potential energy."));
}

void file(Ui& ui) {
  if (auto path =
          text(ui, "File", ui.inputs.file, "The track's file. Type another path to open it.", ShownTextEnd::end))
    ui.replace(edit::LoadTrack{std::move(*path)});
  const float width = (ImGui::GetContentRegionAvail().x - 2 * ImGui::GetStyle().ItemSpacing.x) / 3;
  const auto pressed = [&](std::string_view label, std::string_view help) {
    return button(ui, label, with_keys(ui.keys, help, label), true, width);
  };
  if (pressed("New", "Start an empty track.")) ui.replace(ui.new_track());
  ImGui::SameLine();
  if (pressed("Open", "Choose a track file to open.")) ui.want = {ScreenRequest::Kind::browse};
  ImGui::SameLine();
  if (pressed("Save", "Save the track to its file.")) ui.want = {ScreenRequest::Kind::save};
}

constexpr std::size_t kMostShown = 200;  // rows on either side of the present state

template <class Command>
void repeat(Ui& ui, std::size_t steps) {
  for (std::size_t i = 0; i < steps; ++i) ui.emit(Command{});
}

// Returns "Undo to this step." and the command, which may name thousands of knots.
std::string tooltip_of(std::string_view does, const edit::HistoryStep& step) {
  constexpr std::size_t kMost = 120;  // bytes
  const std::string_view command = step.text.command;
  return fmt::format("{} Command: {}{}", does, command.substr(0, kMost), command.size() > kMost ? " ..." : "");
}

// Shows a step as a line to click; `name` is its path for scripts.
bool step_row(Ui& ui, const std::string& text, const std::string& name, std::uint32_t tint, std::string_view tooltip) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour(tint));
  const bool pressed = ImGui::Selectable(fmt::format("{}##{}", text, name).c_str());
  ImGui::PopStyleColor();
  note_item(ui, name, "item", tooltip, true, text);
  return pressed;
}

// Returns the usual colour of a part: that of the kind, or else of the material.
std::int32_t usual(const world::Paint& kind, PaintPart part) {
  if (kind.of(part).own()) return kind.of(part).rgb;
  const auto* const row = std::ranges::find(sim::kMaterials, std::optional(part), &sim::MaterialRow::painted);
  std::int32_t rgb = 0;
  for (int i = 0; i < 3; ++i) rgb = rgb << 8 | static_cast<std::int32_t>(row->colour[i] * 255 + 0.5f);
  return rgb;
}

// What a change of paint does.
struct Painting {
  const world::Paint& paint;  // what is changed; may lack colours
  world::Paint below;         // shows where colours are lacking
  std::string_view tooltip;
  std::function<edit::Command(world::Palette)> all;
  std::function<edit::Command(PaintPart, world::Colour)> part;
};

void palette_box(Ui& ui, const Painting& painting) {
  if (const auto to = combo_of(ui, "Palette", world::palette_of(painting.paint), {"Own mix", "The colours below."},
                               painting.tooltip))
    ui.emit(painting.all(*to));
}

void paint_fields(Ui& ui, const Painting& painting, bool trains) {
  const world::Paint usual_paint = base::row_of(ui.session().document.kind).paint;
  palette_box(ui, painting);
  const world::Paint shown = world::over(painting.paint, painting.below);
  for (std::size_t i = 0; i < world::kPaintPartCount; ++i) {
    const auto part = static_cast<PaintPart>(i);
    if (part == PaintPart::train && !trains) continue;
    const std::int32_t rgb = shown.of(part).own() ? shown.of(part).rgb : usual(usual_paint, part);
    const base::NameRow& row = base::row_of(part);
    if (const auto to = colour_field(ui, row.label, rgb, row.help)) ui.emit(painting.part(part, world::Colour{*to}));
  }
}

}  // namespace

void track_panel(Ui& ui) {
  if (auto name = text(ui, "Name", ui.session().document.name, "The track's name."))
    ui.emit(edit::SetTrackName{std::move(*name)});
  size(ui);
  deviation(ui);
  conflicts(ui);
  if (!ui.find.flooded().empty())
    read_query(ui, "Under water", "flooded", "Stretches of track under water. Tunnels are dry.",
               {.decimals = 0, .warns = true});
  bad_places(ui, ui.find.folds(), "Folds", "folds", "Places where the rails fold. Such a track cannot be exported.",
             "Next fold", "Go to the next place where the rails fold.");
  bad_places(ui, ui.find.tight_bends(), "Tight bends", "tight_bends",
             "Places where the curve bends with a radius below 0.5 m or reverses its direction.", "Next tight bend",
             "Go to the next bend that is too tight for a train.");
  building(ui);
  start(ui);
  file(ui);
}

void history_panel(Ui& ui) {
  const edit::History& history = ui.session().history;
  const std::size_t undo = history.undo.size(), redo = history.redo.size();
  const double megabytes = static_cast<double>(history.bytes) / (1 << 20);
  read_out(ui, "Steps", fmt::format("{} undo, {} redo", undo, redo), "",
           "Steps that can be undone and redone. Camera, panels and selection are not included.");
  read_out(ui, "Memory", fixed(megabytes, 2), "MiB", "Memory of the steps. Beyond 256 MiB the oldest are dropped.");
  const std::size_t first = undo > kMostShown ? undo - kMostShown : 0;
  if (first == 0 && undo > 0 && step_row(ui, "Start", "Start", palette().dim, "Undo everything."))
    repeat<edit::Undo>(ui, undo);
  for (std::size_t i = first; i < undo; ++i) {
    const bool now = i + 1 == undo;
    if (step_row(ui, fmt::format("{}  {}", i + 1, in_units(ui, history.undo[i].text.sentence)), std::to_string(i + 1),
                 now ? palette().accent : palette().text,
                 tooltip_of(now ? "The current step." : "Undo to this step.", history.undo[i])))
      repeat<edit::Undo>(ui, undo - 1 - i);
  }
  // The redo stack has the next step last.
  for (std::size_t k = 0; k < std::min(redo, kMostShown); ++k) {
    const std::size_t number = undo + k + 1;
    if (step_row(ui, fmt::format("{}  {}", number, in_units(ui, history.redo[redo - 1 - k].text.sentence)),
                 std::to_string(number), palette().dim, tooltip_of("Redo to this step.", history.redo[redo - 1 - k])))
      repeat<edit::Redo>(ui, k + 1);
  }
}

void section_paint(Ui& ui, const SelectedSections& chosen) {
  const world::Document& document = ui.session().document;
  const edit::Sections names(chosen.names());
  const Painting painting{chosen.section().paint, world::over(document.paint, base::row_of(document.kind).paint),
                          "Colours of the selected sections. Usual: those of the whole track.",
                          [&](world::Palette to) {
                            return edit::PaintSections{names, to};
                          },
                          [&](PaintPart part, world::Colour to) {
                            return edit::PaintSectionsPart{names, part, to};
                          }};
  paint_fields(ui, painting, false);
}

void coaster_panel(Ui& ui) {
  const world::Document& document = ui.session().document;
  {
    const LockedWidgets locked(ui, edit::SetKind::kInfo.name);
    ui.emit_if<edit::SetKind>(
        combo_of(ui, "Kind", document.kind, "What track, supports and trains look like, and the room they need."));
  }
  const Painting painting{document.paint, base::row_of(document.kind).paint,
                          "Colours of track, supports and trains. Usual: those of the kind.",
                          [](world::Palette to) { return edit::PaintTrack{to}; },
                          [](PaintPart part, world::Colour to) {
                            return edit::PaintTrackPart{part, to};
                          }};
  paint_fields(ui, painting, true);
}

}  // namespace coaster::ui
