// Track files on disk: the format by the path's extension, whole-file reading, atomic writing.
#include "exchange/own/track_file.h"

#include <fmt/format.h>

#include "base/utf8.h"
#include "exchange/formats.h"

namespace coaster::exchange {
namespace {

// Returns "a.txt: error: expected a file ending in .json"; names a format that works only in the other direction.
std::string unfit_ending(const std::filesystem::path& path, const Format* format, Direction direction) {
  std::string text = path.string() + ": error: ";
  if (format)
    text += fmt::format("{} ({}) can only be {}; ", format->ending, format->label,
                        direction == Direction::read ? "written" : "read");
  return fmt::format("{}expected a file ending in {}", text, known_endings(direction));
}

}  // namespace

std::string name_of_file(std::string_view path) {
  const std::string printable = base::printable_utf8(std::filesystem::path(path).stem().string());
  return std::string(base::utf8_start(printable, world::kMaxNameBytes));
}

base::Result<LoadedTrack> load_track(base::Files& files, const std::filesystem::path& path, base::Progress* progress) {
  const Format* const format = format_of(path);
  if (!format || !format->parse) return base::Status{base::Code::bad_file, unfit_ending(path, format, Direction::read)};
  const base::Result<std::string> bytes = files.read(path);
  if (!bytes) return bytes.status();
  return progress && format->parse_watched ? format->parse_watched(*bytes, path.string(), progress)
                                           : format->parse(*bytes, path.string());
}

base::Status save_track(base::Files& files, const std::filesystem::path& path, const world::Document& document) {
  const Format* const format = format_of(path);
  if (!format || !format->print) return {base::Code::refused, unfit_ending(path, format, Direction::write)};
  if (format->check)
    if (const base::Status fit = format->check(document); !fit)
      return {fit.code, fmt::format("{}: {}", path.string(), fit.message)};
  const std::string bytes = format->print(document);
  // Does not write a file too large to be read again.
  if (format->parse && bytes.size() > base::kMaxFileBytes)
    return {base::Code::refused, fmt::format("{}: error: {} bytes are over the limit of {}", path.string(),
                                             bytes.size(), base::kMaxFileBytes)};
  return files.write_atomic(path, bytes);
}

}  // namespace coaster::exchange
