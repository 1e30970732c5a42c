// Rows of the session, and the values they show.
#include "ui/context/rows.h"

#include <algorithm>
#include <string>
#include <vector>

#include "edit/commands/commands_settings.h"
#include "world/lab_view.h"

namespace coaster::ui {

std::optional<query::Value> value_of(const Ui& ui, std::string_view name, std::string_view argument) {
  const query::Query* row = query::find_query(name);
  if (row == nullptr) return std::nullopt;
  const query::Context context{ui.state.find, ui.state.stats, {}, ui.session().document.name};
  auto result = row->evaluate(context, argument);
  if (!result) return std::nullopt;
  return *result;
}

void read_query(Ui& ui, std::string_view label, std::string_view name, std::string_view argument,
                std::string_view tooltip, Shown shown) {
  const query::Query* row = query::find_query(name);
  const std::string unit = shown.unit != nullptr ? shown.unit : row != nullptr ? std::string(row->unit) : "";
  std::string words = "--";
  if (!(shown.is_time && ui.state.scripted)) {
    if (const auto value = value_of(ui, name, argument)) {
      const double* real = std::get_if<double>(&*value);
      words = real != nullptr ? fixed(*real * shown.factor, shown.decimals) : query::to_text(*value);
    }
  }
  read_out(ui, label, words, unit, tooltip, shown.warns);
}

void colouring_box(Ui& ui) {
  if (const auto to = combo_of(ui, "Colour by", ui.session().settings.lab->colouring,
                               with_keys(ui.keys, "What the colours of the track show. A legend appears in the view.",
                                         "Next track colours")))
    ui.emit(edit::Set<&world::LabView::colouring>{*to});
}

int known_medal(const Ui& ui, const std::filesystem::path& challenge) {
  const std::string key = challenge.stem().string();
  const exchange::ChallengeProgress* const now = exchange::find(ui.session().game.earned, key);
  const exchange::ChallengeProgress* const kept =
      ui.state.kept ? exchange::find(ui.state.kept->progress, key) : nullptr;
  return std::max(now ? now->medal : 0, kept ? kept->medal : 0);
}

}  // namespace coaster::ui
