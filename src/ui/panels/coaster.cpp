// Coaster: its kind, and the paint of the track or of the selected sections.
#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "edit/commands/commands_coaster.h"
#include "sim/solids/materials.h"
#include "ui/context/ui.h"
#include "ui/panels/selected_sections.h"
#include "ui/widgets/widgets.h"

namespace coaster::ui {
namespace {

using world::PaintPart;

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
  std::vector<Choice> choices = choices_of<world::Palette>();
  const auto now = world::palette_of(painting.paint);
  if (!now) choices.push_back({"Own mix", "The colours below."});
  const int shown = now ? static_cast<int>(*now) : static_cast<int>(choices.size()) - 1;
  if (const auto to = combo(ui, "Palette", choices, shown, painting.tooltip))
    if (*to < static_cast<int>(base::count_of<world::Palette>()))
      ui.emit(painting.all(static_cast<world::Palette>(*to)));
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
    if (const auto to =
            combo_of(ui, "Kind", document.kind, "What track, supports and trains look like, and the room they need."))
      ui.emit(edit::SetKind{*to});
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
