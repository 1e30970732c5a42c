// The menu File.
#include "edit/commands/commands_challenge.h"
#include "ui/actions/actions_parts.h"

namespace coaster::ui {
namespace {

using platform::Key;

void new_track(Act& act) { act.ui.want = {Want::Kind::fresh}; }
void open(Act& act) { act.ui.want = {Want::Kind::browse}; }
void save(Act& act) { act.ui.want = {Want::Kind::save}; }
void save_as(Act& act) { act.ui.want = {Want::Kind::save_as}; }
void settings(Act& act) { act.ui.want = {Want::Kind::settings}; }
void screenshot(Act& act) { act.ui.out.wants_screenshot = true; }
void challenges(Act& act) { act.ui.want = {Want::Kind::challenges}; }
bool in_challenge(const Act& act) { return act.ui.session().game.challenge.has_value(); }
void leave_challenge(Act& act) { act.ui.emit(edit::LeaveChallenge{}); }
bool filming(const Act& act) { return act.ui.state.movie != nullptr; }
bool filmable(const Act& act) { return filming(act) || rideable(act); }
void record_movie(Act& act) { act.ui.out.movie = filming(act) ? MovieWish::stop : MovieWish::start; }
void show_start(Act& act) { act.ui.want = {Want::Kind::start_screen}; }
void tutorial(Act& act) { act.ui.want = {Want::Kind::tutorial}; }
void quit(Act& act) { act.ui.want = {Want::Kind::quit}; }

constexpr Action kFileActions[] = {
    {"New", "File", "Ctrl+N", ctrl(Key::n), kNoKey, false, false, "Start an empty track.", always, nullptr, new_track},
    {"Open", "File", "Ctrl+O", ctrl(Key::o), kNoKey, false, false, "Choose a track file to open.", always, nullptr,
     open},
    {"Save", "File", "Ctrl+S", ctrl(Key::s), kNoKey, false, false, "Save the track to its file.", always, nullptr,
     save},
    {"Save as",
     "File",
     "Ctrl+Shift+S",
     {Key::s, {.shift = true, .ctrl = true}},
     kNoKey,
     false,
     false,
     "Save to another file or export. The file extension selects the format.",
     always,
     nullptr,
     save_as},
    {"Start screen", "File", "", kNoKey, kNoKey, false, false, "Recent tracks, samples, challenges and the tutorial.",
     always, nullptr, show_start},
    {"Tutorial", "File", "", kNoKey, kNoKey, false, false, "Build and ride your first coaster, step by step.", always,
     nullptr, tutorial},
    {"Challenges", "File", "Ctrl+H", ctrl(Key::h), kNoKey, false, false,
     "Choose a challenge with a goal and three medals.", always, nullptr, challenges},
    {"Leave challenge", "File", "", kNoKey, kNoKey, false, false, "Leave the challenge. The track stays as it is.",
     in_challenge, nullptr, leave_challenge},
    {"Settings", "File", "Ctrl+,", ctrl(Key::comma), kNoKey, false, false, "Scale, theme, sound, autosave and keys.",
     always, nullptr, settings},
    {"Screenshot", "File", "F12", key(Key::f12), kNoKey, false, true, "Save a screenshot of the window.", always,
     nullptr, screenshot},
    {"Record movie", "File", "Shift+F12", shift(Key::f12), kNoKey, false, true,
     "Record one lap as pictures and, where ffmpeg is installed, as a movie. Again to stop.", filmable, filming,
     record_movie},
    {"Quit", "File", "Ctrl+Q", ctrl(Key::q), kNoKey, false, false, "Quit coaster.", always, nullptr, quit},
};

}  // namespace

std::span<const Action> file_actions() { return kFileActions; }

}  // namespace coaster::ui
