// Runs the target named by FUZZ_TARGET in the environment under libFuzzer; without it, lists the names of all targets.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "fuzz/targets.h"

namespace {

coaster::fuzz::Target chosen;

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
  const char* const name = std::getenv("FUZZ_TARGET");
  for (const coaster::fuzz::Target& target : coaster::fuzz::targets()) {
    if (!name) std::printf("%.*s\n", static_cast<int>(target.name.size()), target.name.data());
    if (name && target.name == name) chosen = target;
  }
  if (!name) std::exit(0);
  if (chosen.name.empty()) std::fprintf(stderr, "%s: no such target\n", name), std::exit(2);
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen.run({reinterpret_cast<const char*>(data), size});
  return 0;
}
