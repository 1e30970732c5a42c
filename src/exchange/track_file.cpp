// Track files on disk: the format by the path's ending, whole-file reading, atomic writing.
#include "exchange/track_file.h"

#include "exchange/nl2_csv.h"

namespace coaster::exchange {
namespace {

constexpr std::string_view kEnding = ".json", kNl2Ending = ".csv";

std::string unknown_ending(const std::filesystem::path& path) {
  return path.string() + ": error: expected a file ending in " + std::string(kEnding) + " or " + std::string(kNl2Ending);
}

}  // namespace

base::Result<LoadedTrack> load_track(base::Files& files, const std::filesystem::path& path) {
  const bool nl2 = path.extension() == kNl2Ending;
  if (path.extension() != kEnding && !nl2) return base::Status{base::Code::bad_file, unknown_ending(path)};
  const base::Result<std::string> text = files.read(path);
  if (!text) return text.status();
  if (nl2) return parse_nl2_csv(*text, path.string());
  return parse_track(*text, path.string());
}

bool keeps_all(const std::filesystem::path& path) { return path.extension() != kNl2Ending; }

base::Status save_track(base::Files& files, const std::filesystem::path& path,
                        const world::Document& document) {
  const bool nl2 = path.extension() == kNl2Ending;
  if (path.extension() != kEnding && !nl2) return {base::Code::refused, unknown_ending(path)};
  if (nl2)
    if (base::Status status = check_nl2_csv(document, kNl2Spacing); !status) return {status.code, path.string() + ": " + status.message};
  const std::string text = nl2 ? print_nl2_csv(document, kNl2Spacing) : print_track(document);
  // What could not be read again is not written.
  if (text.size() > base::kMaxFileBytes)
    return {base::Code::refused, path.string() + ": error: " + std::to_string(text.size()) +
                                     " bytes are over the limit of " + std::to_string(base::kMaxFileBytes)};
  return files.write_atomic(path, text);
}

}  // namespace coaster::exchange
