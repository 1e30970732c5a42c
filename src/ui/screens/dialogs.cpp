// The questions, and what follows from their answers.
#include "ui/screens/dialogs.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "base/file_lock.h"
#include "exchange/formats.h"
#include "ui/actions/key_map.h"
#include "ui/widgets/theme.h"
#include "ui/widgets/toasts.h"
#include "ui/widgets/widget_parts.h"

namespace coaster::ui {
namespace {

using platform::Key;

bool pressed(const platform::Events& events, Key a, Key b = Key::unknown) {
  return std::any_of(events.begin(), events.end(), [&](const platform::Event& event) {
    const auto* press = std::get_if<platform::KeyPress>(&event);
    return press != nullptr && press->down && !press->repeat &&
           (press->key == a || (b != Key::unknown && press->key == b));
  });
}

void title(std::string_view words) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour(palette().accent));
  ImGui::TextUnformatted(words.data(), words.data() + words.size());
  ImGui::PopStyleColor();
  ImGui::Separator();
}

void paragraph(Ui& ui, std::string_view label, const std::string& words) {
  ImGui::PushTextWrapPos(0);
  ImGui::TextUnformatted(words.c_str());
  ImGui::PopTextWrapPos();
  note_item(ui, label, "label", "", true, words);
}

// Where a file is looked for first: beside the document, else beside the file used last.
std::filesystem::path first_folder(const Ui& ui) {
  const edit::Session& session = ui.session();
  if (!session.file.path.empty()) return base::canonical_path(session.file.path).parent_path();
  if (ui.state.kept != nullptr && !ui.state.kept->settings.recent.empty())
    return std::filesystem::path(ui.state.kept->settings.recent.front()).parent_path();
  return ".";
}

std::string file_name_for(const std::string& track) {
  std::string name;
  for (const char c : track) name += c == '/' || c == '\\' ? '-' : c;
  return (name.empty() || name.starts_with('.') ? "track" : name) + ".json";
}

bool held_by_other(const Ui& ui) { return ui.state.kept != nullptr && !ui.state.kept->holder.empty(); }

}  // namespace

void Dialogs::abandon() {
  stage_ = Stage::none;
  want_ = {};
  saving_ = system_ = false;
}

void Dialogs::request(Ui& ui, Want want) {
  want_ = std::move(want);
  saving_ = false;
  if (edit::dirty(ui.state.find)) stage_ = Stage::unsaved;
  else proceed(ui);
}

void Dialogs::proceed(Ui& ui) {
  const Want want = std::exchange(want_, {});
  stage_ = Stage::none;
  saving_ = false;
  switch (want.kind) {
    case Want::Kind::nothing: break;
    case Want::Kind::fresh: ui.emit(edit::NewTrack{}); break;
    case Want::Kind::browse: browse(ui, FileBrowser::Mode::open); break;
    case Want::Kind::load: ui.emit(edit::Load{want.path}); break;
    case Want::Kind::tutorial: ui.out.wants_tutorial = true; break;
    case Want::Kind::challenge: ui.emit(edit::StartChallenge{want.path}); break;
    case Want::Kind::quit: ui.out.quit = true; break;
  }
}

// The save was carried out after the frame that asked for it: the document is clean now, or a notice says why not and
// everything stays.
void Dialogs::follow_save(Ui& ui) {
  if (!std::exchange(saving_, false)) return;
  if (edit::dirty(ui.state.find)) abandon();
  else proceed(ui);
}

void Dialogs::browse(Ui& ui, FileBrowser::Mode mode) {
  const edit::Session& session = ui.session();
  const bool save = mode == FileBrowser::Mode::save;
  const std::string name =
      session.file.path.empty() ? file_name_for(session.document.name) : session.file.path.filename().string();
  browser_.start(mode, first_folder(ui), save ? name : "");
  stage_ = Stage::browse;
}

void Dialogs::save_as(Ui& ui) { browse(ui, FileBrowser::Mode::save); }

void Dialogs::save(Ui& ui) {
  if (ui.session().file.path.empty()) return save_as(ui);
  if (held_by_other(ui)) {
    ui.toasts.show(edit::NoticeKind::warning, ui.state.kept->holder + " edits this file: save under another name.",
                   ui.state.seconds);
    return save_as(ui);
  }
  ui.emit(edit::Save{ui.session().file.path.string()});
  saving_ = want_.kind != Want::Kind::nothing;
  stage_ = Stage::none;
}

// `asked`: whether to overwrite it has been asked already.
void Dialogs::take_file(Ui& ui, std::filesystem::path path, bool asked) {
  std::error_code error;
  if (browser_.mode() == FileBrowser::Mode::open) {
    want_ = {Want::Kind::load, path.string()};
    return proceed(ui);  // unsaved changes were asked about before
  }
  const bool own =
      !ui.session().file.path.empty() && base::canonical_path(path) == base::canonical_path(ui.session().file.path);
  chosen_ = std::move(path);
  if (!asked && !own && std::filesystem::exists(chosen_, error)) {
    stage_ = Stage::overwrite;
    return;
  }
  ui.emit(edit::Save{chosen_.string()});
  // Exporting saves nothing: what was to follow waits for an answer again.
  saving_ = want_.kind != Want::Kind::nothing;
  stage_ = Stage::none;
}

void Dialogs::take_system(Ui& ui) {
  if (!system_ || ui.state.kept == nullptr || !ui.state.kept->system.answer) return;
  system_ = false;
  const std::string answer = *ui.state.kept->system.answer;
  if (answer.empty() || stage_ != Stage::browse) return;
  take_file(
      ui,
      exchange::format_of(answer) == nullptr && browser_.mode() == FileBrowser::Mode::save ? answer + ".json" : answer,
      exchange::format_of(answer) != nullptr);
}

void Dialogs::build_unsaved(Ui& ui, const platform::Events& events) {
  ui.panel = "Unsaved changes";
  title("Unsaved changes");
  const std::string& name = ui.session().document.name;
  paragraph(ui, "Question",
            (name.empty() ? std::string("This track") : "\u201C" + name + "\u201D") +
                " has changes that are not saved. Without saving they are lost.");
  const bool enter = pressed(events, Key::enter, Key::keypad_enter);
  const bool save_now = button(ui, "Save", "Save them, then go on. Key Enter.") || enter;
  ImGui::SameLine();
  const bool drop = button(ui, "Discard", "Go on without them. Key D.") || pressed(events, Key::d);
  ImGui::SameLine();
  const bool cancel = button(ui, "Cancel", "Back to the track. Key Escape.") || pressed(events, Key::escape);
  if (cancel) abandon();
  else if (drop) proceed(ui);
  else if (save_now) save(ui);
}

void Dialogs::build_browser(Ui& ui, const platform::Events& events, bool text_had_keyboard) {
  const bool saving = browser_.mode() == FileBrowser::Mode::save;
  ui.panel = saving ? "Save as" : "Open";
  title(saving ? "Save the track as" : "Open a track");
  const SystemDialog system = ui.state.kept != nullptr ? ui.state.kept->system : SystemDialog{};
  if (system.running) {
    paragraph(ui, "Waiting", "The desktop's own dialog is open.");
    if (button(ui, "Cancel", "Do not wait for it.") || pressed(events, Key::escape)) abandon();
    return;
  }
  switch (browser_.build(ui, events, text_had_keyboard, system.available)) {
    case FileBrowser::Answer::none: break;
    case FileBrowser::Answer::cancel: abandon(); break;
    case FileBrowser::Answer::chosen: take_file(ui, browser_.chosen(), false); break;
    case FileBrowser::Answer::make_folder: folder_name_ = "New folder", stage_ = Stage::new_folder; break;
    case FileBrowser::Answer::system:
      system_ = true;
      ui.out.system_dialog = SystemDialogRequest{saving, browser_.folder().string(),
                                                 saving ? file_name_for(ui.session().document.name) : ""};
      break;
  }
}

void Dialogs::build_overwrite(Ui& ui, const platform::Events& events) {
  ui.panel = "Overwrite";
  title("Overwrite?");
  paragraph(ui, "Question",
            chosen_.string() + " exists already, of " + base::local_time(base::change_time(chosen_)) +
                ". What is in it is lost when it is overwritten.");
  const bool yes = button(ui, "Overwrite", "Save in its place.");
  ImGui::SameLine();
  if (yes) take_file(ui, chosen_, true);
  if (button(ui, "Cancel", "Choose another name. Keys Escape and Enter.") || pressed(events, Key::escape, Key::enter))
    stage_ = Stage::browse;
}

void Dialogs::build_new_folder(Ui& ui, const platform::Events& events, bool text_had_keyboard) {
  ui.panel = "New folder";
  title("New folder");
  if (auto typed = text(ui, "Name", folder_name_, "The folder's name.")) folder_name_ = std::move(*typed);
  const bool named = !folder_name_.empty() && folder_name_ != "." && folder_name_ != ".." &&
                     folder_name_.find('/') == std::string::npos;
  const bool make =
      button(ui, "Make", "Make it. Key Enter.", named) || (named && pressed(events, Key::enter, Key::keypad_enter));
  ImGui::SameLine();
  if (button(ui, "Cancel", "Back. Key Escape.") || (!text_had_keyboard && pressed(events, Key::escape)))
    stage_ = Stage::browse;
  if (!make) return;
  ui.out.new_folder = (browser_.folder() / folder_name_).string();
  browser_.go(browser_.folder());
  stage_ = Stage::browse;
}

void Dialogs::build_recovery(Ui& ui) {
  ui.panel = "Recovery";
  title("Recover unsaved work?");
  const RecoveryOffer& offer = ui.state.kept->recoveries.front();
  paragraph(ui, "Question",
            "The program ended without being asked to, and \u201C" + offer.name +
                "\u201D had changes that were not saved. They were put aside:");
  read_out(ui, "File", offer.original.empty() ? "none: it was never saved" : offer.original, "",
           "The file whose unsaved state it is.");
  read_out(ui, "File saved", offer.file_time != 0 ? base::local_time(offer.file_time) : "--", "",
           "When the file was last changed.");
  read_out(ui, "Autosaved", base::local_time(offer.time), "", "When the unsaved state was put aside.");
  if (offer.file_time > offer.time) paragraph(ui, "Newer", "The file is newer than the autosave.");
  const std::size_t more = ui.state.kept->recoveries.size() - 1;
  if (more > 0) paragraph(ui, "More", std::to_string(more) + " more after this one.");
  const auto answer = [&](Recovery what) { ui.out.recovery = what, stage_ = Stage::none; };
  if (button(ui, "Recover", "Go on with the unsaved state. The file stays as it is until you save."))
    answer(Recovery::recover);
  ImGui::SameLine();
  if (button(ui, "Discard", "Delete the autosave. The file stays as it is.")) answer(Recovery::discard);
  ImGui::SameLine();
  if (button(ui, "Later", "Keep it, and ask again at the next start.")) answer(Recovery::later), asked_later_ = true;
}

std::pair<float, float> Dialogs::wanted_size() const {
  switch (shown_) {
    case Stage::browse: return {680, 470};
    case Stage::settings: return {560, 520};
    case Stage::challenges: return {620, 640};
    case Stage::recovery: return {480, -168};
    default: return {440, -96};
  }
}

void Dialogs::build_stage(Ui& ui, const platform::Events& events, bool text_had_keyboard) {
  switch (shown_) {
    case Stage::none: break;
    case Stage::unsaved: build_unsaved(ui, events); break;
    case Stage::browse: build_browser(ui, events, text_had_keyboard); break;
    case Stage::overwrite: build_overwrite(ui, events); break;
    case Stage::new_folder: build_new_folder(ui, events, text_had_keyboard); break;
    case Stage::recovery: build_recovery(ui); break;
    case Stage::challenges: build_challenges(ui); break;
    case Stage::settings:
      ui.panel = "Settings";
      title("Settings");
      if (build_settings(ui) || (!text_had_keyboard && pressed(events, Key::escape))) stage_ = Stage::none;
      break;
  }
  ui.panel.clear();
}

void Dialogs::build(Ui& ui, const platform::Events& events, bool text_had_keyboard, float width, float height) {
  follow_save(ui);
  take_system(ui);
  const UserState* const kept = ui.state.kept;
  if (stage_ == Stage::none && kept != nullptr && !kept->recoveries.empty() && !asked_later_) stage_ = Stage::recovery;
  if (stage_ == Stage::recovery && (kept == nullptr || kept->recoveries.empty())) stage_ = Stage::none;
  const platform::Events none;
  const bool changed = std::exchange(shown_, stage_) != stage_;  // what brought it here is not its answer, too
  constexpr const char* kId = "##dialog";
  if (shown_ != Stage::none && !ImGui::IsPopupOpen(kId)) ImGui::OpenPopup(kId);
  const auto [design_width, design_height] = wanted_size();
  const bool fits = design_height < 0;  // itself to what is in it
  const float wide = std::floor(std::min(design_width * ui.scale, width - 16)),
              high = std::floor(std::min(std::abs(design_height) * ui.scale, height - 16));
  // Where the top is does not depend on the height, which is known some frames later alone: nothing moves under the
  // mouse.
  constexpr float kTop = 0.28f;
  const float top = fits ? std::min(height * kTop, height - high - 8) : (height - high) * 0.5f;
  ImGui::SetNextWindowPos({std::floor((width - wide) * 0.5f), std::floor(top)});
  ImGui::SetNextWindowSize({wide, fits ? 0 : high});
  if (fits) ImGui::SetNextWindowSizeConstraints({wide, high}, {wide, std::max(high, height - 16)});
  constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;
  if (!ImGui::BeginPopupModal(kId, nullptr, kFixed)) return;
  if (shown_ == Stage::none) ImGui::CloseCurrentPopup();
  build_stage(ui, changed ? none : events, text_had_keyboard);
  ImGui::EndPopup();
}

}  // namespace coaster::ui
