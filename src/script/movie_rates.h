// Frame rates of movies, in pictures a second.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace coaster::script {

// A picture shows a whole tick of 1/120 s, so rates divide 120.
inline constexpr std::array kMovieRates{10, 12, 15, 20, 24, 30, 40, 60, 120};
inline constexpr int kUsualMovieRate = 30;
inline constexpr std::string_view kMovieRateWords = "10, 12, 15, 20, 24, 30, 40, 60 or 120";
constexpr bool is_movie_rate(std::int64_t fps) {
  return std::find(kMovieRates.begin(), kMovieRates.end(), fps) != kMovieRates.end();
}

}  // namespace coaster::script
