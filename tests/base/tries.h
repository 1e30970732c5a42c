// How many cases of a test with many are tried.
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

// Returns whether case `i` of a fixed list is tried: each one, or every fourth with the sanitizers.
constexpr bool tried(int i) { return !kSanitized || i % 4 == 0; }

}  // namespace coaster::test
