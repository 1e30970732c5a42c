// The menu File.
#include "edit/commands/commands_challenge.h"
#include "edit/commands/commands_session.h"
#include "exchange/own/link.h"
#include "ui/actions/actions_parts.h"

namespace coaster::ui {
namespace {

using platform::Key;

template <PhotoWish wish>
void photo(Act& act) {
  act.ui.out.photo = wish;
}
constexpr Condition kInChallenge{[](const Act& act) { return act.ui.session().game.challenge.has_value(); },
                                 "No challenge is open."};
// Shares the track as a link, or as a file if it is too large for a link.
void share(Act& act) {
  act.ui.emit(edit::Share{});
  if (edit::link_of(act.ui.session()).size() > exchange::kMaxLinkBytes) act.ui.want = {Want::Kind::save_as};
}
bool filming(const Act& act) { return act.ui.state.movie != nullptr; }
constexpr Condition kFilmable{[](const Act& act) { return filming(act) || kRideable.holds(act); }, kRideable.otherwise};
void record_movie(Act& act) { act.ui.out.movie = filming(act) ? MovieWish::stop : MovieWish::start; }

constexpr Action kFileActions[] = {
    {"New", "File", ctrl(Key::n), kOnStart, "Start an empty track.", want<Want::Kind::fresh>},
    {"Open", "File", ctrl(Key::o), kOnStart, "Choose a track file to open.", want<Want::Kind::browse>},
    {"Save", "File", ctrl(Key::s), 0, "Save the track to its file.", want<Want::Kind::save>},
    {"Save as", "File", ctrl_shift(Key::s), 0, "Save to another file or export. The file extension selects the format.",
     want<Want::Kind::save_as>},
    {"Share", "File", ctrl_shift(Key::l), 0,
     "Copy a link that opens this track in this view. It holds the whole track.", share},
    {"Save sections", "File", kNoKey, 0, "Save the selected sections to a file of their own.",
     want<Want::Kind::save_sections>, kSectionSelected},
    {"Add sections", "File", kNoKey, 0, "Add the sections of a file at the open end of the track.",
     want<Want::Kind::open_sections>},
    {"Start screen", "File", kNoKey, 0, "Recent tracks, samples, challenges and the tutorial.",
     want<Want::Kind::start_screen>},
    {"Tutorial", "File", kNoKey, kOnStart, "Build and ride your first coaster, step by step.",
     want<Want::Kind::tutorial>},
    {"Challenges", "File", ctrl(Key::h), kOnStart, "Choose a challenge with a goal and three medals.",
     want<Want::Kind::challenges>},
    {"Leave challenge", "File", kNoKey, 0, "Leave the challenge. The track stays as it is.", emit<edit::LeaveChallenge>,
     kInChallenge},
    {"Settings", "File", ctrl(Key::comma), kOnStart, "Scale, theme, sound, autosave and keys.",
     want<Want::Kind::settings>},
    {"Screenshot", "File", key(Key::f12), kInDrag, "Save a picture of the scene, without panels and selection.",
     photo<PhotoWish::scene>},
    {"Screenshot with panels", "File", ctrl(Key::f12), kInDrag, "Save a picture of the whole window.",
     photo<PhotoWish::window>},
    {"Record movie", "File", shift(Key::f12), kInDrag,
     "Record one lap as pictures and, where ffmpeg is installed, as a movie. Again to stop.", record_movie, kFilmable,
     filming},
    {"Quit", "File", ctrl(Key::q), kOnStart, "Quit coaster.", want<Want::Kind::quit>},
};

}  // namespace

std::span<const Action> file_actions() { return kFileActions; }

}  // namespace coaster::ui
