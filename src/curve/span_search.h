// Finds the fewest spans that follow a path: which of its points become knots. The caller judges what a span may miss:
// elements by distance and frames, force sections by what riders feel, imported rows by both.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace coaster::curve {

// How longest_span() searches: a length that holds grows by one `growth`th and `more`; a first one that does not
// shrinks by quarters, or by half of what is above the least; the result is exact, or to one `coarseness`th of it.
struct SpanSteps {
  std::size_t growth = 2, more = 0, coarseness = 0;
  bool by_quarters = false;
};
// Returns the largest number of points, from `least` to `most`, for which holds(number), if a shorter part of a span
// that holds does, too; `least` counts as holding. Tries `guess` first.
template <class Holds>
std::size_t longest_span(std::size_t least, std::size_t most, std::size_t guess, SpanSteps steps, Holds&& holds) {
  std::size_t good = least, bad = most + 1;
  for (std::size_t length = std::max(guess, least + 1); good < most && bad > most;
       length += std::max<std::size_t>(1, length / steps.growth + steps.more)) {
    const std::size_t tried = std::min(length, most);
    (holds(tried) ? good : bad) = tried;
  }
  while (bad > good + 1 + (steps.coarseness > 0 ? good / steps.coarseness : 0)) {
    const bool first = steps.by_quarters && good == least;
    const std::size_t tried = first ? std::max(least + 1, bad - 1 - bad / 4) : good + (bad - good) / 2;
    (holds(tried) ? good : bad) = tried;
  }
  return good;
}

// The ends of the spans are ascending indices of the path's points, from the first point to the last.

// Returns the ends of `count` spans of about equal difficulty, or of fewer where points are too few; `difficulties` has
// a positive number for each present span, which grows with its length.
std::vector<std::size_t> even_ends(std::span<const std::size_t> ends, std::span<const double> difficulties,
                                   std::size_t count);
// Returns the ends with the middle of each of these spans added, once for each span; of two points nothing is added.
std::vector<std::size_t> halved(std::span<const std::size_t> ends, std::span<const std::size_t> spans);

// A choice of knots.
struct SpanTrial {
  std::vector<std::size_t> ends;
  std::vector<double> difficulties;  // by span, for even_ends()
  double strain = 0;                 // the largest error as a part of what is allowed
  bool holds = false;
};

// Tries one span fewer, evened out over some rounds, as long as that holds. `attempt(ends)` returns the Trial, a
// SpanTrial, of these ends. `mend(trial)` may change the one with the least strain where none held, and returns true if
// it holds then.
template <class Trial, class Attempt, class Mend>
void remove_spans(Trial& best, int rounds, Attempt&& attempt, Mend&& mend) {
  while (best.ends.size() > 2) {
    const std::size_t count = best.ends.size() - 2;
    Trial now = best;
    std::optional<Trial> least;
    for (int round = 0; round < rounds; ++round) {
      now = attempt(even_ends(now.ends, now.difficulties, count));
      if (!least || now.holds || now.strain < least->strain) least = now;
      if (now.holds) break;
    }
    if (!least || (!least->holds && !mend(*least))) return;
    best = std::move(*least);
  }
}

}  // namespace coaster::curve
