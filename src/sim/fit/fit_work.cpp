#include "sim/fit/fit_work.h"

namespace coaster::sim {
namespace {

constexpr std::size_t kFirstStride = 32;  // rows of the first span to try
constexpr double kLeastScale = 0.4;       // relative to the bounds
constexpr double kCopyScale = 0.2;        // the same for the rows of a track that was fitted before

// Returns the longest span from `first`: doubles the last one's length, then bisects. Assumes that a shorter part of a
// fitting span fits too.
Span longest_span(FitWork& w, std::size_t first, const RollRange& allowed, std::size_t usual) {
  const std::size_t end = w.rows.size() - 1;
  Span good{first, first + 1, w.fit(first, first + 1, allowed), allowed};
  const auto beyond = std::lower_bound(w.distances.begin() + static_cast<std::ptrdiff_t>(first), w.distances.end(),
                                       w.distances[first] + kLeastSpan);
  const auto short_rows = static_cast<std::size_t>(beyond - w.distances.begin()) - first;
  std::size_t bad = end + 1, length = std::max<std::size_t>({usual, 2, short_rows});
  while (good.last < end) {
    const std::size_t last = std::min(first + length, end);
    if (last <= good.last || last >= bad) break;
    SpanFit fit = w.fit(first, last, allowed);
    const bool within = fit.within;
    if (within) good.last = last, good.fit = std::move(fit);
    else bad = last;
    length = within ? length + std::max<std::size_t>(1, length / 2) : length;
    if (bad <= end) break;
  }
  while (bad > good.last + 1 + (good.last - first) / 64) {
    const std::size_t last = good.last + (bad - good.last) / 2;
    SpanFit fit = w.fit(first, last, allowed);
    if (fit.within) good.last = last, good.fit = std::move(fit);
    else bad = last;
  }
  // A knot just before the end moves back slightly: the step that closes a track is shorter than the others.
  if (good.last < end && w.distances[end] - w.distances[good.last] < w.last_span) {
    std::size_t last = good.last;
    while (last > first + 1 && w.distances[end] - w.distances[last] < w.last_span) --last;
    SpanFit fit = w.fit(first, last, allowed);
    if (fit.within) good.last = last, good.fit = std::move(fit);
  }
  return good;
}

// Returns the rolls that a span allows the knot at its last row.
RollRange rolls_after(const FitWork& w, std::size_t last, const SpanFit& fit) {
  const RollRange allowed = second_rolls(fit.window);
  return allowed.low > allowed.high ? RollRange{w.row_rolls.leans[last], w.row_rolls.leans[last]} : allowed;
}

// Where `span` bends too much, ends the span before it earlier, so that neither does. Changes nothing if no row will
// do.
void retreat(FitWork& w, Span& span, std::size_t usual) {
  Span& before = w.spans.back();
  const std::size_t rows = before.last - before.first;
  for (std::size_t back = 1; back < rows && !w.cancelled(); back += 1 + back / 2) {
    const std::size_t last = before.last - back;
    SpanFit fit = w.fit(before.first, last, before.allowed);
    if (!fit.within || fit.bent) continue;
    Span tried = longest_span(w, last, rolls_after(w, last, fit), usual);
    if (tried.fit.bent || !tried.fit.within || tried.last < span.last) continue;
    before.last = last, before.fit = std::move(fit);
    span = std::move(tried);
    return;
  }
}

}  // namespace

void fit_spans(FitWork& w, std::size_t most_spans) {
  const std::size_t end = w.rows.size() - 1;
  w.spans.clear();
  const double most = w.bounds().angle, seam = w.row_rolls.leans[0];
  RollRange allowed = w.closed ? RollRange{seam, seam} : RollRange{-most, most};
  std::size_t usual = kFirstStride;
  for (std::size_t first = 0; first < end && w.spans.size() <= most_spans && !w.cancelled();) {
    Span span = longest_span(w, first, allowed, usual);
    if (span.fit.bent && !w.spans.empty()) retreat(w, span, usual);
    usual = std::max<std::size_t>(2, span.last - span.first);
    allowed = rolls_after(w, span.last, span.fit);
    first = span.last;
    w.spans.push_back(std::move(span));
    w.tell(static_cast<double>(first) / static_cast<double>(end));
  }
  ++w.passes;
}

void even_out(FitWork& w) {
  if (w.spans.size() < 2 || w.rows.size() > kEvenedRows) return;
  std::vector<Span> best = w.spans;
  const std::size_t fewest = best.size();
  const auto suffice = [&](double scale, std::size_t most) {
    w.scale = scale;
    fit_spans(w, most);
    if (w.spans.size() > most) return false;
    best = std::move(w.spans);
    return true;
  };
  // The rows of a track that was fitted before lie on spans that meet much tighter bounds with about as many knots. On
  // other rows a span's length scales with the second to fourth root of the bound: at kCopyScale there are half as many
  // spans more, and with n spans the bounds can shrink by 4 / n at most.
  if (!suffice(kCopyScale, fewest + fewest / 8 + 1) && !suffice(kLeastScale, fewest)) {
    double low = std::max(kLeastScale, 1 - 4.0 / static_cast<double>(fewest)), high = 1;
    for (int i = 0; i < kEvenings && !w.cancelled(); ++i) {
      const double middle = 0.5 * (low + high);
      (suffice(middle, fewest) ? high : low) = middle;
    }
  }
  w.scale = 1;
  w.spans = std::move(best);
}

}  // namespace coaster::sim
