// The number of cases of a randomised test.
#pragma once

namespace coaster::test {

#if defined(__SANITIZE_ADDRESS__)
inline constexpr bool kSanitized = true;
#elif defined(__has_feature)
inline constexpr bool kSanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool kSanitized = false;
#endif

// Returns `full` cases; a quarter of them with the sanitizers, where each takes ten times as long.
constexpr int tries(int full) { return kSanitized ? (full + 3) / 4 : full; }

}  // namespace coaster::test
