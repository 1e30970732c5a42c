#include "ui/context/query_widgets.h"
#include "ui/context/setting_widgets.h"

#include "base/folders.h"
#include "query/context.h"
#include "query/query.h"

namespace coaster::ui {
namespace {

// Returns nothing for none.
std::optional<query::Value> value_of(const Ui& ui, std::string_view name, std::string_view argument) {
  const query::Query* row = query::find_query(name);
  if (row == nullptr) return std::nullopt;
  const query::QueryContext context{ui.find, ui.state.stats, {}, ui.session().document.name};
  auto result = row->evaluate(context, argument);
  if (!result || query::is_none(*result)) return std::nullopt;
  return *result;
}

}  // namespace

std::optional<double> number_of(const Ui& ui, std::string_view name) {
  const auto value = value_of(ui, name, {});
  const double* const number = value ? std::get_if<double>(&*value) : nullptr;
  return number != nullptr ? std::optional(*number) : std::nullopt;
}

void read_query(Ui& ui, std::string_view label, std::string_view name, std::string_view tooltip,
                const ShownValue& shown) {
  const query::Query* row = query::find_query(name);
  const std::string unit = shown.unit != nullptr ? shown.unit : row != nullptr ? std::string(row->unit) : "";
  std::string words = "--";
  if (const auto value = value_of(ui, name, shown.argument)) {
    const double* real = std::get_if<double>(&*value);
    words = real != nullptr ? digits(ui, *real * shown.factor, shown.decimals, unit) : query::to_text(*value);
  }
  read_out(ui, label, words, base::shown_in(ui.units, unit).name, tooltip, shown.warns);
}

exchange::UserSettings& change_kept(Ui& ui) { return ui.out.settings.emplace(ui.state.kept->settings); }

void colouring_box(Ui& ui) {
  setting_list<&world::LabView::colouring>(
      ui, "Colour by",
      with_keys(ui.keys, "What the colours of the track show. A legend appears in the view.", "Next track colours"));
}

int known_medal(const Ui& ui, const std::filesystem::path& challenge) {
  const std::string key = challenge.stem().string();
  const exchange::ChallengeProgress* const now = exchange::find(ui.session().game.earned, key);
  const exchange::ChallengeProgress* const kept =
      ui.state.kept ? exchange::find(ui.state.kept->progress, key) : nullptr;
  return std::max(now ? now->medal : 0, kept ? kept->medal : 0);
}

// --- The user's files

std::vector<std::filesystem::path> json_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (const auto entries = base::list_folder(folder))
    for (const base::FolderEntry& entry : *entries)
      if (!entry.folder && entry.name.ends_with(".json")) files.push_back(folder / entry.name);
  return files;
}

std::optional<std::filesystem::path> challenge_after(const edit::ActiveChallenge& challenge) {
  const std::filesystem::path now(challenge.path);
  for (const std::filesystem::path& file : json_files(now.parent_path()))  // by name
    if (file.filename() > now.filename()) return file;
  return std::nullopt;
}

}  // namespace coaster::ui
