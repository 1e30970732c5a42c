#include "fuzz/targets.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include "base/check.h"
#include "base/file_lock.h"
#include "base/scratch_folder.h"
#include "exchange/challenge_file.h"
#include "exchange/own/challenge_progress_file.h"
#include "exchange/own/force_limits_file.h"
#include "exchange/own/settings_file.h"
#include "exchange/own/share_link.h"
#include "exchange/own/track_file.h"
#ifdef COASTER_FUZZ_SCRIPTS
#include "script/grammar.h"
#endif

namespace coaster::fuzz {
namespace {

void check_error(const base::Status& status) {
  COASTER_CHECK(!status.message.empty() && status.message.find('\n') == std::string::npos, "an error is one line");
}

void check_track(const exchange::TrackFormat& format, std::string_view bytes) {
  // Fitting takes milliseconds per hundred rows, and longer inputs test nothing more of the reader.
  if (bytes.size() > 16'000) return;
  const auto loaded = format.parse(bytes, "track");
  if (!loaded) return check_error(loaded.status());
  COASTER_CHECK(!world::broken_invariant(loaded->document), "what a reader accepts is a document");
  const auto again = exchange::parse_track(exchange::print_track(loaded->document), "again");
  COASTER_CHECK(again.ok(), "what a reader accepts can be saved and read again");
  COASTER_CHECK(!format.whole || world::hash(again->document) == world::hash(loaded->document),
                "saving and loading changes nothing");
}

// The text of a link, or text to pack into one.
void link(std::string_view bytes) {
  if (bytes.size() > 16'000) return;
  const std::string text = exchange::is_link(bytes) ? std::string(bytes) : "#coaster=1." + exchange::pack(bytes);
  const auto loaded = exchange::parse_link(text);
  if (!loaded) return check_error(loaded.status());
  COASTER_CHECK(!world::broken_invariant(loaded->document), "what a link holds is a document");
  const auto again = exchange::parse_link(exchange::print_link(loaded->document, *loaded->view));
  COASTER_CHECK(again.ok() && world::hash(again->document) == world::hash(loaded->document),
                "sharing what was shared changes nothing");
  COASTER_CHECK(again->view == loaded->view, "the view stays the same");
}

void envelope(std::string_view bytes) {
  const auto loaded = exchange::parse_envelope(bytes, "envelope");
  if (!loaded) return check_error(loaded.status());
  COASTER_CHECK(exchange::parse_envelope(exchange::print_envelope(loaded->envelope, loaded->name), "again").ok(),
                "an envelope can be saved and read again");
}

void settings(std::string_view bytes) {
  const auto loaded = exchange::parse_settings(bytes, "settings");
  if (!loaded) return check_error(loaded.status());
  const auto again = exchange::parse_settings(exchange::print_settings(loaded->settings), "again");
  COASTER_CHECK(again.ok() && again->warnings.empty() && again->settings == loaded->settings,
                "what is kept of settings is read back the same");
}

void challenge(std::string_view bytes) {
  base::Files files;  // a start track that the text names is searched for in a folder that does not exist
  const auto loaded = exchange::parse_challenge(bytes, "challenge", "no such folder", files);
  if (!loaded) return check_error(loaded.status());
  COASTER_CHECK(!loaded->challenge.list(exchange::RuleList::goals).empty(), "a challenge has a goal");
  COASTER_CHECK(!world::broken_invariant(loaded->challenge.start), "its start track is a document");
}

void progress(std::string_view bytes) {
  const auto loaded = exchange::parse_progress(bytes, "progress");
  if (!loaded) return check_error(loaded.status());
  const auto again = exchange::parse_progress(exchange::print_progress(*loaded), "again");
  COASTER_CHECK(again.ok() && *again == *loaded, "what is kept of progress is read back the same");
}

// Returns everything below a folder, without following links: path, mode, inode, bytes.
std::string census(const std::filesystem::path& folder) {
  std::vector<std::string> lines;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    struct stat info {};
    COASTER_CHECK(::lstat(entry.path().c_str(), &info) == 0, "what is listed is there");
    std::string line = entry.path().string() + " " + std::to_string(info.st_mode) + " " + std::to_string(info.st_ino);
    if (S_ISREG(info.st_mode)) line += " " + *base::Files().read(entry.path());
    lines.push_back(std::move(line));
  }
  std::sort(lines.begin(), lines.end());
  std::string all;
  for (const std::string& line : lines) all += line + "\n";
  return all;
}

// A folder "run" with links out of it, next to the folder that they lead to, "outside". Both are deeply nested, for
// names with many "..".
class LinkFarm {
 public:
  LinkFarm() {
    std::filesystem::path deep = scratch_.path();
    for (int i = 0; i <= kMostUp; ++i) deep /= "n";
    outside = deep / "outside", run = deep / "run";
    std::filesystem::create_directories(outside / "folder");
    std::filesystem::create_directories(run / "folder");
    std::ofstream(outside / "victim") << "victim";
    for (const auto& [name, target] :
         std::array<std::pair<const char*, std::filesystem::path>, 7>{{{"away", "../outside"},
                                                                       {"up", ".."},
                                                                       {"absolute", outside},
                                                                       {"dangling", "../outside/new"},
                                                                       {"file", "../outside/victim"},
                                                                       {"self", "self"},
                                                                       {"folder/away", "../../outside"}}})
      std::filesystem::create_symlink(target, run / name);
    for (const char* const name : {"hard", ".x.lock"})
      std::filesystem::create_hard_link(outside / "victim", run / name);
    COASTER_CHECK(::mkfifo((run / "pipe").c_str(), 0600) == 0 && ::mkfifo((run / ".y.lock").c_str(), 0600) == 0,
                  "pipes are made");
  }

  static constexpr int kMostUp = 10;
  std::filesystem::path outside, run;

 private:
  test::ScratchFolder scratch_;
};

// Each line is an operation's letter and a path below the run's folder, or below the folder outside when it begins with
// "/".
void outputs(std::string_view bytes) {
  if (bytes.size() > 2'000) return;
  const LinkFarm farm;
  const std::string before = census(farm.outside);
  base::Files files(*base::FileRoot().open(farm.run));
  while (!bytes.empty()) {
    const std::string line(bytes.substr(0, bytes.find('\n')));
    bytes.remove_prefix(std::min(bytes.size(), line.size() + 1));
    const std::string name = line.empty() ? "" : line.substr(1);
    int up = 0;
    for (std::size_t at = name.find(".."); at != std::string::npos; at = name.find("..", at + 2)) ++up;
    if (up > LinkFarm::kMostUp) continue;
    const std::filesystem::path path = name.starts_with('/') ? farm.outside / name.substr(1) : farm.run / name;
    switch (line.empty() ? ' ' : line.front()) {
      case 'w':
        if (const base::Status wrote = files.write_atomic(path, "written"); !wrote) check_error(wrote);
        break;
      case 'm': (void)files.root().make_folders(path); break;
      case 'l': (void)base::try_lock(path, files.root()); break;
      case 'o':
        if (const auto inner = files.root().open(path))
          (void)base::Files(*inner).write_atomic(path / "inner", "written");
        break;
      case 'n': (void)files.rename(path, "renamed"); break;
      case 's': (void)(files.remove_leftovers(path) + files.remove_leftovers_in(path)); break;
      case 'r': (void)files.remove(path); break;
      case 't': (void)files.remove_made(path); break;
      default: break;
    }
  }
  COASTER_CHECK(census(farm.outside) == before, "nothing outside of the folder is made, changed or removed");
}

#ifdef COASTER_FUZZ_SCRIPTS
void script(std::string_view bytes) {
  if (bytes.find("include") != std::string_view::npos) return;  // reads whatever file it names
  base::Files files;
  (void)script::parse_script(bytes, "script", ".", files);
}
#endif

constexpr std::array kReaders{
    Target{"envelope", envelope}, Target{"settings", settings}, Target{"challenge", challenge},
    Target{"progress", progress}, Target{"outputs", outputs},   Target{"link", link},
#ifdef COASTER_FUZZ_SCRIPTS
    Target{"script", script},
#endif
};

}  // namespace

void Target::run(std::string_view bytes) const { format ? check_track(*format, bytes) : reader(bytes); }

std::vector<Target> targets() {
  std::vector<Target> all;
  for (const exchange::TrackFormat& format : exchange::formats())
    if (format.parse) all.push_back({format.ending.substr(1), nullptr, &format});
  all.insert(all.end(), kReaders.begin(), kReaders.end());
  return all;
}

}  // namespace coaster::fuzz
