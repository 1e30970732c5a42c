#include "exchange/own/autosave.h"

#include <unistd.h>

#include <algorithm>
#include <functional>
#include <limits>

#include <fmt/format.h>

#include "base/folders.h"
#include "base/hash.h"
#include "base/text.h"
#include "exchange/own/json.h"
#include "exchange/own/track_file.h"

namespace coaster::exchange {
namespace {

constexpr std::string_view kInfoEnding = ".info.json", kTrackEnding = ".track.json";

void remove_file(base::Files& files, const std::filesystem::path& file) {
  if (!file.empty()) (void)files.remove(file);
}

// Returns the first unused name: "4711-1".
std::filesystem::path free_info(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (int i = 1;; ++i) {
    std::filesystem::path info = folder / (fmt::format("{}-{}{}", ::getpid(), i, kInfoEnding));
    if (!std::filesystem::exists(info, ignored)) return info;
  }
}

std::string stem_of(const std::filesystem::path& info) {
  const std::string name = info.filename().string();
  return name.substr(0, name.size() - kInfoEnding.size());
}

std::string print_info(const std::filesystem::path& track, const world::Document& document, const std::string& original,
                       std::int64_t time) {
  return print_autosave_info({track, original, document.name, time, ::getpid(), base::hex16(world::hash(document))});
}

}  // namespace

base::Result<AutosaveInfo> parse_autosave_info(std::string_view text, std::string_view name) {
  return read_object<AutosaveInfo>(text, name, [](JsonFieldReader& fields, AutosaveInfo& info) {
    constexpr std::int64_t kMost = std::numeric_limits<std::int64_t>::max() / 2;
    std::string track;
    std::int64_t pid = 0;
    const bool read = fields.head(kAutosaveFormat, kAutosaveVersion) && fields.text("track", track) &&
                      fields.text("original", info.original) && fields.text("name", info.name) &&
                      fields.whole("time", info.time, 0, kMost) &&
                      fields.whole("pid", pid, 0, std::numeric_limits<int>::max()) && fields.text("hash", info.hash);
    info.track = track, info.pid = static_cast<int>(pid);
    return read && (info.track.filename() == track || fields.reject("track", "a name without a folder"));
  });
}

std::string print_autosave_info(const AutosaveInfo& info) {
  return json_file({{"format", kAutosaveFormat},
                    {"version", kAutosaveVersion},
                    {"track", info.track.filename().string()},
                    {"original", info.original},
                    {"name", info.name},
                    {"time", info.time},
                    {"pid", info.pid},
                    {"hash", info.hash}});
}

base::Status Autosave::reserve(base::Files& files, const std::filesystem::path& folder) {
  if (!info_.empty() && info_.parent_path() == folder) return {};
  if (folder.empty()) return {base::Code::io, "no folder for autosaves: HOME is not set"};
  if (const base::Status made = files.root().make_folders(folder, 0700); !made) return made;
  remove();
  files_ = files;
  info_ = free_info(folder);
  lock_ = base::try_lock(info_, files.root()).lock;
  return {};
}

base::Status Autosave::write(base::Files& files, const std::filesystem::path& folder, const world::Document& document,
                             const std::string& original, std::int64_t time) {
  if (const base::Status reserved = reserve(files, folder); !reserved) return reserved;
  std::filesystem::path track = folder / (fmt::format("{}.{}{}", stem_of(info_), ++serial_, kTrackEnding));
  if (const base::Status wrote = files.write_atomic(track, print_track(document)); !wrote) {
    remove_file(files, track);  // may already exist if the folder's fsync failed
    return wrote;
  }
  const std::string info = print_info(track, document, original, time);
  if (const base::Status told = files.write_atomic(info_, info); !told) {
    // Only reading the small file shows which of the two it names.
    base::Files plain;
    const auto now = plain.read(info_);
    const auto named = now ? parse_autosave_info(*now, "") : base::Result<AutosaveInfo>(now.status());
    const bool names_new = named && folder / named->track == track;
    if (names_new) std::swap(track_, track);
    remove_file(files, track);  // the track that the info file does not name
    return told;
  }
  if (track_ != track) remove_file(files, track_);
  track_ = track;
  return {};
}

void Autosave::remove() {
  remove_file(files_, info_);
  remove_file(files_, track_);
  lock_.release();
  info_.clear();
  track_.clear();
}

std::vector<base::CrashFile> crash_files(base::Files& files, const std::filesystem::path& info,
                                         const world::Document& document, const std::string& original,
                                         std::int64_t time) {
  const std::filesystem::path track = info.parent_path() / fmt::format("{}.crash{}", stem_of(info), kTrackEnding);
  base::Result<base::NewFile> first = files.create(track), second = files.create(info);
  std::vector<base::CrashFile> made;
  if (!first || !second) return made;
  made.push_back({std::move(*first), print_track(document)});
  made.push_back({std::move(*second), print_info(track, document, original, time)});
  return made;
}

std::vector<FoundAutosave> find_autosaves(base::Files& files, const std::filesystem::path& folder) {
  std::vector<FoundAutosave> found;
  (void)files.remove_leftovers_in(folder);
  const auto entries = base::list_folder(folder, true);
  if (!entries) return found;
  std::vector<std::string> spared;  // stems of running programs and of unreadable files, and tracks that are named
  for (const base::FolderEntry& entry : *entries) {
    if (entry.folder || !entry.name.ends_with(kInfoEnding) || entry.name.starts_with('.')) continue;
    const std::filesystem::path file = folder / entry.name;
    spared.push_back(stem_of(file));
    base::LockAttempt attempt = base::try_lock(file, files.root());
    if (attempt.outcome == base::LockAttempt::Outcome::held) continue;
    const base::Result<std::string> text = files.read(file);
    base::Result<AutosaveInfo> info =
        text ? parse_autosave_info(*text, entry.name) : base::Result<AutosaveInfo>(text.status());
    if (!info) continue;
    if (attempt.outcome == base::LockAttempt::Outcome::impossible && base::process_runs(info->pid)) continue;
    spared.back() = info->track.string();
    info->track = folder / info->track;
    const std::int64_t file_time = info->original.empty() ? 0 : base::change_time(info->original);
    found.push_back({std::move(*info), file, std::move(attempt.lock), file_time});
  }
  for (const base::FolderEntry& entry : *entries) {
    if (entry.folder || !entry.name.ends_with(kTrackEnding) || entry.name.starts_with('.')) continue;
    const std::string stem = entry.name.substr(0, entry.name.find('.'));
    const auto is_spared = [&](const std::string& name) { return name == stem || name == entry.name; };
    if (std::ranges::any_of(spared, is_spared)) continue;
    const auto pid = base::parse_int(stem.substr(0, stem.find('-')));
    if (!pid || base::process_runs(*pid)) continue;  // without a number it is none of ours
    remove_file(files, folder / entry.name);
  }
  std::ranges::sort(found, std::greater(), [](const FoundAutosave& autosave) { return autosave.info.time; });
  return found;
}

void discard(base::Files& files, FoundAutosave& found) {
  remove_file(files, found.info_file);
  remove_file(files, found.info.track);
  found.lock.release();
}

}  // namespace coaster::exchange
