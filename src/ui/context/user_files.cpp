#include "ui/context/user_files.h"

#include "base/folders.h"

namespace coaster::ui {

std::vector<std::filesystem::path> json_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  if (const auto entries = base::list_folder(folder))
    for (const base::FolderEntry& entry : *entries)
      if (!entry.folder && entry.name.ends_with(".json")) files.push_back(folder / entry.name);
  return files;
}

std::optional<std::filesystem::path> challenge_after(const edit::ActiveChallenge& challenge) {
  const std::filesystem::path now(challenge.path);
  for (const std::filesystem::path& file : json_files(now.parent_path()))  // by name
    if (file.filename() > now.filename()) return file;
  return std::nullopt;
}

}  // namespace coaster::ui
