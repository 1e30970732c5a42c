// Records a session as a script: a snapshot of the track, then every command with the ticks between them.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>

#include "base/files.h"
#include "edit/commands/command.h"

namespace coaster::edit {
struct Session;
}

namespace coaster::script {

class Recorder {
 public:
  // Begins the script `path` and saves the track next to it (rec.coaster: rec.json), with the faults of `files`. Both
  // are new files, or such that runs made; links in the folder's own path are followed. Code::io if either cannot be
  // written, Code::refused for another file or a link of these names.
  static base::Result<std::unique_ptr<Recorder>> start(const base::Files& files, const std::filesystem::path& path,
                                                       const edit::Session& session);
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  // Records a command that was applied successfully; `after` is the session afterwards. Leaves out saving. Copies an
  // opened file next to the script, so that a recording is self-contained.
  base::Status command(const edit::Command& command, const edit::Session& after);
  // Counts ticks. They are written before the next command, or after a second of ticks.
  base::Status ticks(int count);
  // Writes the remaining ticks. So does the destructor, but without reporting errors.
  base::Status finish() { return write_ticks(); }

 private:
  Recorder(std::filesystem::path path, base::Files files, base::NewFile out)
      : path_(std::move(path)), files_(std::move(files)), out_(std::move(out)) {}
  base::Status line(const std::string& text);
  base::Status write_ticks();
  base::Status snapshot(const edit::Session& session);

  std::filesystem::path path_;
  base::Files files_;  // writes only into the folder of path_
  base::NewFile out_;
  int snapshots_ = 0;
  std::int64_t pending_ticks_ = 0;
};

}  // namespace coaster::script
