// Runs every target on every file below a folder, without a fuzzer: replay FOLDER. An input that crashed one reader
// remains a test, and is tried on the others.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/targets.h"

int main(int count, char** arguments) {
  if (count != 2) return std::fprintf(stderr, "replay FOLDER\n"), 2;
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(arguments[1]))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& path : files) {
    std::printf("%s\n", path.c_str());
    std::ifstream file(path, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    for (const coaster::fuzz::Target& target : coaster::fuzz::targets()) {
      std::printf("  %.*s\n", static_cast<int>(target.name.size()), target.name.data());
      std::fflush(stdout);
      target.run(bytes);
    }
  }
  return files.empty() ? (std::fprintf(stderr, "%s: no files\n", arguments[1]), 1) : 0;
}
