// A web page cannot start other programs.
#include "app/process.h"

namespace coaster::app {

std::string find_program(const char*) { return {}; }

Process::~Process() = default;
base::Status Process::start(std::vector<std::string>, int, bool, int) {
  return {base::Code::io, "a page starts no programs"};
}
std::optional<int> Process::poll() { return std::nullopt; }
void Process::end() {}

}  // namespace coaster::app
