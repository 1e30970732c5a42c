// Opens dialogs and acts on their answers.
#include "ui/screens/dialogs.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/file_lock.h"
#include "base/folders.h"
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"

namespace coaster::ui {
namespace {

// Returns the folder shown first: the document's, else that of the file used last; never one of the program's
// own folders.
std::filesystem::path first_folder(const Ui& ui) {
  std::vector<std::filesystem::path> files;
  if (const auto& own = ui.session().file.path; !own.empty()) files.push_back(base::canonical_path(own));
  if (ui.state.kept != nullptr)
    files.insert(files.end(), ui.state.kept->settings.recent.begin(), ui.state.kept->settings.recent.end());
  const auto theirs = std::find_if_not(files.begin(), files.end(), base::is_installed);
  return theirs == files.end() ? "." : theirs->parent_path();
}

}  // namespace

std::string file_name_for(const std::string& track) {
  std::string name;
  for (const char c : track) name += c == '/' || c == '\\' ? '-' : c;
  return (name.empty() || name.starts_with('.') ? "track" : name) + ".json";
}

void Dialogs::abandon() {
  dialog_ = Dialog::none;
  want_ = {};
  saving_ = system_ = false;
}

void Dialogs::take(Ui& ui, Want want) {
  if (want.kind >= Want::Kind::fresh && want.kind <= Want::Kind::quit) request(ui, std::move(want));
  else perform(ui, want);
}

void Dialogs::request(Ui& ui, Want want) {
  want_ = std::move(want);
  saving_ = false;
  if (edit::dirty(ui.find)) dialog_ = Dialog::unsaved;
  else proceed(ui);
}

void Dialogs::proceed(Ui& ui) {
  dialog_ = Dialog::none;
  saving_ = false;
  perform(ui, std::exchange(want_, {}));
}

void Dialogs::perform(Ui& ui, const Want& want) {
  switch (want.kind) {
    case Want::Kind::nothing:
    case Want::Kind::start_screen: break;
    case Want::Kind::fresh: ui.emit(edit::NewTrack{}); break;
    case Want::Kind::browse: browse(ui, FileBrowser::Mode::open); break;
    case Want::Kind::load: load(ui, want); break;
    case Want::Kind::tutorial: ui.out.wants_tutorial = true; break;
    case Want::Kind::challenge: ui.emit(edit::StartChallenge{want.path}); break;
    case Want::Kind::quit: ui.out.quit = true; break;
    case Want::Kind::save: save(ui); break;
    case Want::Kind::save_as: browse(ui, FileBrowser::Mode::save); break;
    case Want::Kind::save_sections: browse(ui, FileBrowser::Mode::save, true); break;
    case Want::Kind::open_sections: browse(ui, FileBrowser::Mode::open, true); break;
    case Want::Kind::settings: dialog_ = Dialog::settings; break;
    case Want::Kind::challenges: dialog_ = Dialog::challenges, challenges_.reset(); break;
  }
}

// Asks how points become a track, unless the words say so.
void Dialogs::load(Ui& ui, const Want& want) {
  base::Files files;
  const auto question = want.import == exchange::Import{} ? exchange::question_of(files, want.path) : std::nullopt;
  if (!question) return ui.emit(edit::Load{want.path, want.import});
  want_ = want, question_ = *question, dialog_ = Dialog::import;
}

// The save ran after the frame that requested it. If the document is still unsaved, a notice says why.
void Dialogs::follow_save(Ui& ui) {
  if (!std::exchange(saving_, false)) return;
  if (edit::dirty(ui.find)) abandon();
  else proceed(ui);
}

void Dialogs::browse(Ui& ui, FileBrowser::Mode mode, bool sections) {
  const edit::Session& session = ui.session();
  sections_ = sections;
  const bool save = mode == FileBrowser::Mode::save;
  const std::string name = sections                    ? file_name_for("section")
                           : session.file.path.empty() ? file_name_for(session.document.name)
                                                       : session.file.path.filename().string();
  browser_.start(mode, first_folder(ui), save ? name : "");
  dialog_ = Dialog::browse;
}

void Dialogs::save(Ui& ui) {
  if (ui.session().file.path.empty()) return browse(ui, FileBrowser::Mode::save);
  if (const UserState* const kept = ui.state.kept; kept != nullptr && !kept->holder.empty()) {
    ui.warn("This file is open in " + kept->holder + ". Save under another name.");
    return browse(ui, FileBrowser::Mode::save);
  }
  if (base::is_installed(ui.session().file.path)) {
    ui.warn("This track belongs to the program. Save under another name.");
    return browse(ui, FileBrowser::Mode::save);
  }
  chosen_ = ui.session().file.path;
  if (edit::changed_outside(ui.session())) dialog_ = Dialog::changed;
  else write(ui, chosen_, false);
}

// An export does not save the document: follow_save() then drops the request that was to follow.
void Dialogs::write(Ui& ui, const std::filesystem::path& path, bool overwrite) {
  if (sections_) {
    edit::Sections selected;
    selected.which = edit::Knots::Which::selected;
    ui.emit(edit::SaveSections{path.string(), selected});
  } else {
    ui.emit(edit::Save{path.string(), {overwrite}});
  }
  saving_ = want_.kind != Want::Kind::nothing;
  dialog_ = Dialog::none;
}

// `asked`: the user has already confirmed overwriting. An export may write a second file beside a new one.
void Dialogs::take_file(Ui& ui, std::filesystem::path path, bool asked) {
  std::error_code error;
  if (browser_.mode() == FileBrowser::Mode::open && sections_) {
    dialog_ = Dialog::none;
    return ui.emit(edit::OpenSections{path.string()});
  }
  if (browser_.mode() == FileBrowser::Mode::open) {
    want_ = {Want::Kind::load, path.string()};
    return proceed(ui);  // the question about unsaved changes came before
  }
  const bool own = !sections_ && edit::is_own_file(ui.session(), path);
  chosen_ = std::move(path);
  if (own && edit::changed_outside(ui.session())) dialog_ = Dialog::changed;
  else if (!asked && !own && std::filesystem::exists(lost_file(), error)) dialog_ = Dialog::overwrite;
  else write(ui, chosen_, false);
}

std::filesystem::path Dialogs::lost_file() const {
  std::error_code error;
  return sections_ || std::filesystem::exists(chosen_, error) ? chosen_ : exchange::materials_of(chosen_);
}

void Dialogs::take_system(Ui& ui) {
  if (!system_ || ui.state.kept == nullptr || !ui.state.kept->system.answer) return;
  system_ = false;
  const std::string answer = *ui.state.kept->system.answer;
  if (answer.empty() || dialog_ != Dialog::browse) return;
  const bool known = exchange::format_of(answer) != nullptr, save = browser_.mode() == FileBrowser::Mode::save;
  std::error_code error;
  take_file(ui, save && !known ? answer + ".json" : answer, known && std::filesystem::exists(answer, error));
}

std::pair<float, float> Dialogs::wanted_size() const {
  switch (shown_) {
    case Dialog::browse: return {680, 470};
    case Dialog::settings: return {560, 660};
    case Dialog::challenges: return {620, 640};
    case Dialog::recovery: return {480, -168};
    default: return {440, -96};
  }
}

void Dialogs::build(Ui& ui, const platform::Events& events, bool text_had_keyboard, float width, float height) {
  follow_save(ui);
  take_system(ui);
  const UserState* const kept = ui.state.kept;
  if (dialog_ == Dialog::none && kept != nullptr && !kept->recoveries.empty() && !asked_later_)
    dialog_ = Dialog::recovery;
  if (dialog_ == Dialog::recovery && (kept == nullptr || kept->recoveries.empty())) dialog_ = Dialog::none;
  const platform::Events none;
  const bool changed = std::exchange(shown_, dialog_) != dialog_;  // the key that opened it does not answer it
  constexpr const char* kId = "##dialog";
  if (shown_ != Dialog::none && !ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
  const auto [design_width, design_height] = wanted_size();
  const bool fits = design_height < 0;  // its height to the content
  const float wide = std::floor(std::min(design_width * ui.scale, width - 16)),
              high = std::floor(std::min(std::abs(design_height) * ui.scale, height - 16));
  // The height is known only after some frames. The top does not depend on it, so that nothing moves under the mouse.
  constexpr float kTop = 0.28f;
  const float top = fits ? std::min(height * kTop, height - high - 8) : (height - high) * 0.5f;
  ImGui::SetNextWindowPos({std::floor((width - wide) * 0.5f), std::floor(top)});
  ImGui::SetNextWindowSize({sized(wide), fits ? 0 : sized(high)});
  if (fits) ImGui::SetNextWindowSizeConstraints(sized({wide, high}), sized({wide, std::max(high, height - 16)}));
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
  if (!ImGui::BeginPopupModal(kId, nullptr, kFixed)) return;
  build_shown(ui, changed ? none : events, text_had_keyboard);
  if (dialog_ == Dialog::none) ImGui::CloseCurrentPopup();  // at once: the next frame would show an empty card
  ImGui::EndPopup();
}

}  // namespace coaster::ui
