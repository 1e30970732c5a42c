// Track files on disk: the format by the path's ending, whole-file reading, atomic writing.
#include "exchange/track_file.h"

namespace coaster::exchange {
namespace {

constexpr std::string_view kEnding = ".json";

std::string unknown_ending(const std::filesystem::path& path) {
  return path.string() + ": error: expected a file ending in " + std::string(kEnding);
}

}  // namespace

base::Result<LoadedTrack> load_track(base::Files& files, const std::filesystem::path& path) {
  if (path.extension() != kEnding) return base::Status{base::Code::bad_file, unknown_ending(path)};
  const base::Result<std::string> text = files.read(path);
  if (!text) return text.status();
  return parse_track(*text, path.string());
}

base::Status save_track(base::Files& files, const std::filesystem::path& path,
                        const world::Document& document) {
  if (path.extension() != kEnding) return {base::Code::refused, unknown_ending(path)};
  const std::string text = print_track(document);
  // What could not be read again is not written.
  if (text.size() > base::kMaxFileBytes)
    return {base::Code::refused, path.string() + ": error: " + std::to_string(text.size()) +
                                     " bytes are over the limit of " + std::to_string(base::kMaxFileBytes)};
  return files.write_atomic(path, text);
}

}  // namespace coaster::exchange
