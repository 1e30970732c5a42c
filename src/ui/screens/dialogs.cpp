// Opens dialogs, builds their content, and acts on their answers.
#include "ui/screens/dialogs.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/file_lock.h"
#include "base/folders.h"
#include "edit/commands/commands_ride.h"
#include "edit/commands/commands_sections.h"
#include "edit/commands/commands_session.h"
#include "exchange/points/points.h"
#include "ui/widgets/theme.h"

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

using platform::Key;

void title(std::string_view words) {
  tinted(words, palette().accent);
  ImGui::Separator();
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

void Dialogs::take(Ui& ui, ScreenRequest want) {
  if (want.kind >= ScreenRequest::Kind::replace && want.kind <= ScreenRequest::Kind::quit) request(ui, std::move(want));
  else perform(ui, want);
}

void Dialogs::request(Ui& ui, ScreenRequest want) {
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

void Dialogs::perform(Ui& ui, const ScreenRequest& want) {
  switch (want.kind) {
    case ScreenRequest::Kind::nothing:
    case ScreenRequest::Kind::start_screen: break;
    case ScreenRequest::Kind::browse: browse(ui, FileBrowser::Mode::open); break;
    case ScreenRequest::Kind::replace: replace(ui, want); break;
    case ScreenRequest::Kind::tutorial: ui.out.wants_tutorial = true; break;
    case ScreenRequest::Kind::quit: ui.out.quit = true; break;
    case ScreenRequest::Kind::save: save(ui); break;
    case ScreenRequest::Kind::save_as: browse(ui, FileBrowser::Mode::save); break;
    case ScreenRequest::Kind::save_sections: browse(ui, FileBrowser::Mode::save, true); break;
    case ScreenRequest::Kind::open_sections: browse(ui, FileBrowser::Mode::open, true); break;
    case ScreenRequest::Kind::settings: dialog_ = Dialog::settings; break;
    case ScreenRequest::Kind::challenges: dialog_ = Dialog::challenges, challenges_.reset(); break;
  }
}

// Asks how points become a track, unless the words say so.
void Dialogs::replace(Ui& ui, const ScreenRequest& want) {
  base::Files files;
  const auto* const load = want.command->as<edit::LoadTrack>();
  const bool asks = load != nullptr && load->import == exchange::ImportOptions{};
  const auto question = asks ? exchange::question_of(files, load->path) : std::nullopt;
  if (!question) return ui.out.commands.push_back(*want.command);
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
    const exchange::TrackFormat* const format = exchange::format_of(path);
    const bool park =
        park_ && !ui.session().document.park.plain() && format != nullptr && format->print_park != nullptr;
    ui.emit(edit::Save{path.string(), {overwrite}, {park}});
  }
  saving_ = want_.kind != ScreenRequest::Kind::nothing;
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
    want_ = {ScreenRequest::Kind::replace, edit::LoadTrack{path.string()}};
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

bool pressed(const platform::Events& events, Key a, Key b) {
  return std::any_of(events.begin(), events.end(), [&](const platform::Event& event) {
    const auto* press = std::get_if<platform::KeyPress>(&event);
    if (press == nullptr || !press->down || press->repeat || press->key == Key::unknown) return false;
    const Key key = press->key == Key::keypad_enter ? Key::enter : press->key;
    return key == a || key == b;
  });
}

bool pasted(const platform::Events& events) {
  return std::any_of(events.begin(), events.end(), [](const platform::Event& event) {
    const auto* press = std::get_if<platform::KeyPress>(&event);
    return press != nullptr && press->down && press->key == Key::v && press->modifiers.ctrl;
  });
}

void Dialogs::build_unsaved(Ui& ui, const platform::Events& events) {
  ui.panel = "Unsaved changes";
  title("Unsaved changes");
  const std::string& name = ui.session().document.name;
  paragraph(ui, "Question",
            fmt::format(
                "{} {} lost unless you save.", name.empty() ? "This track" : fmt::format("\u201C{}\u201D", name),
                ui.session().file.path.empty() ? "is not saved yet. It will be" : "has unsaved changes. They will be"),
            palette().text);
  const bool enter = pressed(events, Key::enter);
  const bool save_now = button(ui, "Save", "Save, then continue. Key Enter.") || enter;
  ImGui::SameLine();
  const bool drop = button(ui, "Discard", "Continue without saving. Key D.") || pressed(events, Key::d);
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
  if (!saving && !sections_ && pasted(events)) ui.out.wants_link = true;
  const SystemDialog system = ui.state.kept != nullptr ? ui.state.kept->system : SystemDialog{};
  if (system.running) {
    paragraph(ui, "Waiting", "The system's file dialog is open.", palette().text);
    if (button(ui, "Cancel", "Stop waiting for it.") || pressed(events, Key::escape)) abandon();
    return;
  }
  if (saving && !sections_ && !ui.session().document.park.plain())
    if (const auto on =
            checkbox(ui, "Park in glTF and OBJ", park_, "Such files also hold land, water, tunnels, plants."))
      park_ = *on;
  switch (browser_.build(ui, events, text_had_keyboard, system.available)) {
    case FileBrowser::Answer::none: break;
    case FileBrowser::Answer::cancel: abandon(); break;
    case FileBrowser::Answer::chosen: take_file(ui, browser_.chosen(), false); break;
    case FileBrowser::Answer::make_folder: folder_name_ = "New folder", dialog_ = Dialog::new_folder; break;
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
            fmt::format("{} already exists, changed on {}. Its content will be lost.", lost_file().string(),
                        base::local_time(base::change_time(lost_file()))),
            palette().text);
  const bool yes = button(ui, "Overwrite", "Replace the file.");
  ImGui::SameLine();
  if (yes) take_file(ui, chosen_, true);
  if (button(ui, "Cancel", "Choose another name. Keys Escape and Enter.") || pressed(events, Key::escape, Key::enter))
    dialog_ = Dialog::browse;
}

void Dialogs::build_changed(Ui& ui, const platform::Events& events) {
  ui.panel = "Changed file";
  title("The file has changed");
  paragraph(ui, "Question",
            fmt::format("Another program changed {} on {}, after you opened it. Overwriting loses its changes.",
                        chosen_.string(), base::local_time(base::change_time(chosen_))),
            palette().text);
  const bool other = button(ui, "Save as", "Save under another name. Key Enter.") || pressed(events, Key::enter);
  ImGui::SameLine();
  const bool yes = button(ui, "Overwrite", "Replace the file.");
  ImGui::SameLine();
  const bool cancel = button(ui, "Cancel", "Back to the track. Key Escape.") || pressed(events, Key::escape);
  if (cancel) abandon();
  else if (yes) write(ui, chosen_, true);
  else if (other) browse(ui, FileBrowser::Mode::save);
}

void Dialogs::build_new_folder(Ui& ui, const platform::Events& events, bool text_had_keyboard) {
  ui.panel = "New folder";
  title("New folder");
  if (auto typed = text(ui, "Name", folder_name_, "The folder's name.")) folder_name_ = std::move(*typed);
  const bool named = !folder_name_.empty() && folder_name_ != "." && folder_name_ != ".." &&
                     folder_name_.find('/') == std::string::npos;
  const bool make =
      button(ui, "Create###Make", "Create the folder. Key Enter.", named) || (named && pressed(events, Key::enter));
  ImGui::SameLine();
  if (button(ui, "Cancel", "Back. Key Escape.") || (!text_had_keyboard && pressed(events, Key::escape)))
    dialog_ = Dialog::browse;
  if (!make) return;
  ui.out.new_folder = (browser_.folder() / folder_name_).string();
  browser_.go(browser_.folder());
  dialog_ = Dialog::browse;
}

void Dialogs::build_recovery(Ui& ui) {
  ui.panel = "Recovery";
  title("Recover unsaved work?");
  const RecoveryOffer& offer = ui.state.kept->recoveries.front();
  paragraph(ui, "Question",
            fmt::format("coaster closed unexpectedly. Unsaved changes to \u201C{}\u201D were recovered:", offer.name),
            palette().text);
  read_out(ui, "File", offer.original.empty() ? "none: never saved" : offer.original, "",
           "File that the changes belong to.");
  read_out(ui, "File saved", offer.file_time != 0 ? base::local_time(offer.file_time) : "--", "",
           "When the file was last changed.");
  read_out(ui, "Autosaved", base::local_time(offer.time), "", "Time of the autosave.");
  if (offer.file_time > offer.time) paragraph(ui, "Newer", "The file is newer than the autosave.", palette().text);
  const std::size_t more = ui.state.kept->recoveries.size() - 1;
  if (more > 0) paragraph(ui, "More", fmt::format("{} more after this one.", more), palette().text);
  const auto answer = [&](RecoveryAnswer what) { ui.out.recovery = what, dialog_ = Dialog::none; };
  if (button(ui, "Recover", "Open the unsaved changes. The file stays as it is until you save."))
    answer(RecoveryAnswer::recover);
  ImGui::SameLine();
  if (button(ui, "Discard", "Delete the autosave. The file stays as it is.")) answer(RecoveryAnswer::discard);
  ImGui::SameLine();
  if (button(ui, "Later", "Keep the autosave and ask again at the next start."))
    answer(RecoveryAnswer::later), asked_later_ = true;
}

void Dialogs::build_challenges(Ui& ui) {
  ui.panel = "Challenges";
  title("Challenges");
  const bool opened_now = !challenges_;  // perhaps by a key, which must not answer it
  if (opened_now) challenges_ = read_challenges(ui);
  const auto chosen = draw_challenge_list(ui, *challenges_, challenge_,
                                          ImGui::GetContentRegionAvail().y - ImGui::GetFrameHeightWithSpacing());
  const bool cancel =
      button(ui, "Cancel", "Back to the track. Key Escape.") || ImGui::IsKeyPressed(ImGuiKey_Escape, false);
  if (opened_now) return;
  if (cancel) abandon();
  else if (chosen) request(ui, {ScreenRequest::Kind::replace, edit::StartChallenge{chosen->string()}});
}

void Dialogs::build_import(Ui& ui, const platform::Events& events, bool text_had_keyboard) {
  exchange::ImportOptions& to = question_.proposed;
  const bool rows = question_.points == 0;
  const auto hit = [&](Key a, Key b = Key::unknown) { return !text_had_keyboard && pressed(events, a, b); };
  ui.panel = rows ? "Import rows" : "Import points";
  title(ui.panel);
  if (hit(Key::tab) && ui.wish) ui.wish->panel = ui.panel;
  if (rows) {
    paragraph(ui, "Size", "The track is far from the origin, where positions are rounded.", palette().text);
  } else {
    const double height = *to.scale * std::abs(exchange::with_y_up(question_.size, *to.up).y);
    paragraph(
        ui, "Size",
        fmt::format("{} points: {:.4g} m long, {:.3g} m high.", question_.points, *to.scale * question_.length, height),
        palette().text);
    for (const auto& [key, axis] :
         {std::pair{Key::x, world::Axis::x}, {Key::y, world::Axis::y}, {Key::z, world::Axis::z}})
      if (hit(key)) to.up = axis;
    to.up = combo_of(ui, "Up axis", *to.up, "The file's axis of height. Keys X, Y, Z.").value_or(*to.up);
    const Number scale{.value = *to.scale,
                       .decimals = *to.scale < 0.1 ? 6 : 3,
                       .step = 0.01 * *to.scale,
                       .low = 1 / exchange::kMostScale,
                       .high = exchange::kMostScale};
    to.scale =
        number(ui, "Metres a unit", scale, "Length of one unit of the file in metres. Key Tab.").value_or(*to.scale);
    const Number within{.value = to.smooth.value_or(0), .unit = "m", .step = 0.005, .high = exchange::kMostSmooth};
    if (const auto most =
            number(ui, "Smooth within", within,
                   "Largest distance of the track from the points, at least 0.02 m. 0 leads through every point."))
      to.smooth = *most > 0 ? std::optional(std::max(*most, exchange::kLeastSmooth)) : std::nullopt;
    using enum exchange::ImportBank;
    if (hit(Key::b)) to.bank = to.bank == automatic ? level : automatic;
    if (const auto bank = combo_of(ui, "Roll", to.bank.value_or(level), "How the track rolls. Key B.")) to.bank = bank;
  }
  const auto moves =
      checkbox(ui, "Move to the origin", to.origin, "Move the middle of the track to the origin. Key O.");
  to.origin = moves.value_or(hit(Key::o) ? !to.origin : to.origin);
  const bool go = button(ui, "Import", "Open the track. Key Enter.") || hit(Key::enter);
  ImGui::SameLine();
  const bool cancel = button(ui, "Cancel", "Keep the open track. Key Escape.") || hit(Key::escape);
  if (cancel) return abandon();
  if (!go) return;
  ui.emit(edit::LoadTrack{want_.command->as<edit::LoadTrack>()->path, to});
  abandon();
}

void Dialogs::build_shown(Ui& ui, const platform::Events& events, bool text_had_keyboard) {
  switch (shown_) {
    case Dialog::none: break;
    case Dialog::unsaved: build_unsaved(ui, events); break;
    case Dialog::browse: build_browser(ui, events, text_had_keyboard); break;
    case Dialog::overwrite: build_overwrite(ui, events); break;
    case Dialog::changed: build_changed(ui, events); break;
    case Dialog::new_folder: build_new_folder(ui, events, text_had_keyboard); break;
    case Dialog::recovery: build_recovery(ui); break;
    case Dialog::challenges: build_challenges(ui); break;
    case Dialog::import: build_import(ui, events, text_had_keyboard); break;
    case Dialog::settings:
      ui.panel = "Settings";
      title("Settings");
      if (build_settings(ui, text_had_keyboard ? platform::Events{} : events)) dialog_ = Dialog::none;
      break;
  }
  ui.panel.clear();
}

}  // namespace coaster::ui
