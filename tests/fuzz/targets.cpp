#include "fuzz/targets.h"

#include <array>
#include <string>

#include "base/check.h"
#include "exchange/challenge_file.h"
#include "exchange/own/envelope_file.h"
#include "exchange/own/progress_file.h"
#include "exchange/own/settings_file.h"
#include "exchange/own/track_file.h"
#ifdef COASTER_FUZZ_SCRIPTS
#include "script/grammar.h"
#endif

namespace coaster::fuzz {
namespace {

void check_error(const base::Status& status) {
  COASTER_CHECK(!status.message.empty() && status.message.find('\n') == std::string::npos, "an error is one line");
}

void check_track(const exchange::Format& format, std::string_view bytes) {
  // Fitting takes milliseconds a hundred rows: longer inputs tell the fuzzer nothing new about the reader.
  if (bytes.size() > 16'000) return;
  const auto loaded = format.parse(bytes, "track");
  if (!loaded) return check_error(loaded.status());
  COASTER_CHECK(!world::broken_invariant(loaded->document), "what a reader accepts is a document");
  const auto again = exchange::parse_track(exchange::print_track(loaded->document), "again");
  COASTER_CHECK(again.ok(), "what a reader accepts can be saved and read again");
  COASTER_CHECK(!format.whole || world::hash(again->document) == world::hash(loaded->document),
                "saving and loading changes nothing");
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
  base::Files files;  // a start track that the text names is looked for in a folder that is not there
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

#ifdef COASTER_FUZZ_SCRIPTS
void script(std::string_view bytes) {
  if (bytes.find("include") != std::string_view::npos) return;  // reads whatever file it names
  base::Files files;
  (void)script::parse_script(bytes, "script", ".", files);
}
#endif

constexpr std::array kReaders{
    Target{"envelope", envelope},   Target{"settings", settings},
    Target{"challenge", challenge}, Target{"progress", progress},
#ifdef COASTER_FUZZ_SCRIPTS
    Target{"script", script},
#endif
};

}  // namespace

void Target::run(std::string_view bytes) const { format ? check_track(*format, bytes) : reader(bytes); }

std::vector<Target> targets() {
  std::vector<Target> all;
  for (const exchange::Format& format : exchange::formats())
    if (format.parse) all.push_back({format.ending.substr(1), nullptr, &format});
  all.insert(all.end(), kReaders.begin(), kReaders.end());
  return all;
}

}  // namespace coaster::fuzz
