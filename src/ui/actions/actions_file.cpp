// The menu File.
#include "ui/actions/actions_parts.h"
#include "ui/screens/dialogs.h"
#include "ui/screens/start_screen.h"

namespace coaster::ui {
namespace {

using platform::Key;

void new_track(Act& act) { act.ui.dialogs.request(act.ui, {Want::Kind::fresh, {}}); }
void open(Act& act) { act.ui.dialogs.request(act.ui, {Want::Kind::browse, {}}); }
void save(Act& act) { act.ui.dialogs.save(act.ui); }
void save_as(Act& act) { act.ui.dialogs.save_as(act.ui); }
void settings(Act& act) { act.ui.dialogs.show_settings(); }
void screenshot(Act& act) { act.ui.out.wants_screenshot = true; }
void challenges(Act& act) { act.ui.dialogs.show_challenges(); }
bool in_challenge(const Act& act) { return act.ui.session().game.challenge.has_value(); }
void leave_challenge(Act& act) { act.ui.emit(edit::LeaveChallenge{}); }
bool filming(const Act& act) { return act.ui.state.movie != nullptr; }
bool filmable(const Act& act) { return filming(act) || rideable(act); }
void record_movie(Act& act) { act.ui.out.movie = filming(act) ? MovieWish::stop : MovieWish::start; }
void show_start(Act& act) { act.ui.start.show(); }
void tutorial(Act& act) { act.ui.dialogs.request(act.ui, {Want::Kind::tutorial, {}}); }
void quit(Act& act) { act.ui.dialogs.request(act.ui, {Want::Kind::quit, {}}); }

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
     "Save the track to another file, or export it: the ending tells the format.",
     always,
     nullptr,
     save_as},
    {"Start screen", "File", "", kNoKey, kNoKey, false, false, "The page with recent tracks, samples and the tutorial.",
     always, nullptr, show_start},
    {"Tutorial", "File", "", kNoKey, kNoKey, false, false,
     "Build and ride a first coaster, step by step, with your own hands.", always, nullptr, tutorial},
    {"Challenges", "File", "Ctrl+H", ctrl(Key::h), kNoKey, false, false,
     "Choose a challenge: a start track, a goal and three medals.", always, nullptr, challenges},
    {"Leave challenge", "File", "", kNoKey, kNoKey, false, false, "End the challenge; the track stays as it is.",
     in_challenge, nullptr, leave_challenge},
    {"Settings", "File", "Ctrl+,", ctrl(Key::comma), kNoKey, false, false, "Scale, colours, autosave, keys.", always,
     nullptr, settings},
    {"Screenshot", "File", "F12", key(Key::f12), kNoKey, false, true, "Write a picture of the window.", always, nullptr,
     screenshot},
    {"Record movie", "File", "Shift+F12", shift(Key::f12), kNoKey, false, true,
     "Record one lap of the ride as pictures and, where ffmpeg is installed, a movie; once more: stop.", filmable,
     filming, record_movie},
    {"Quit", "File", "Ctrl+Q", ctrl(Key::q), kNoKey, false, false, "Leave the program.", always, nullptr, quit},
};

}  // namespace

std::span<const Action> file_actions() { return kFileActions; }

}  // namespace coaster::ui
