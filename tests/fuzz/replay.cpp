// Runs a target over the files of a folder, without a fuzzer: replay TARGET FOLDER. A crash that was found stays fixed.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/targets.h"

int main(int count, char** arguments) {
  if (count != 3) return std::fprintf(stderr, "replay TARGET FOLDER\n"), 2;
  for (const coaster::fuzz::Target& target : coaster::fuzz::targets()) {
    if (target.name != arguments[1]) continue;
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(arguments[2])) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& path : files) {
      std::printf("%s\n", path.filename().c_str());
      std::fflush(stdout);
      std::ifstream file(path, std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(file), {}};
      target.run(bytes);
    }
    return files.empty() ? (std::fprintf(stderr, "%s: no files\n", arguments[2]), 1) : 0;
  }
  std::fprintf(stderr, "%s: no such target\n", arguments[1]);
  return 2;
}
