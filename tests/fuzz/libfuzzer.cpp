// One target for libFuzzer; COASTER_FUZZ_TARGET is its name.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "fuzz/targets.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  for (const coaster::fuzz::Target& target : coaster::fuzz::targets())
    if (target.name == COASTER_FUZZ_TARGET) target.run({reinterpret_cast<const char*>(data), size});
  return 0;
}
