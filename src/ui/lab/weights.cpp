// Weights: the Bernstein basis, and the weight of each control point at the probe.
#include <string>

#include <fmt/format.h>

#include "curve/bernstein.h"
#include "ui/lab/cache.h"

namespace coaster::ui {
namespace {

constexpr int kLargestDegree = 8;

std::string subscript(std::size_t digit) {
  std::string text = "\u2080";
  text.back() = static_cast<char>(text.back() + static_cast<char>(digit));
  return text;
}

BasisStudy basis_study(int degree) {
  constexpr int kSamples = 160;
  BasisStudy study;
  study.y.resize(static_cast<std::size_t>(degree) + 1);
  std::vector<double> weights(study.y.size());
  for (int k = 0; k <= kSamples; ++k) {
    const double t = double(k) / kSamples;
    study.t.push_back(t);
    curve::bernstein_basis<double>(t, weights);
    for (std::size_t i = 0; i < weights.size(); ++i) study.y[i].push_back(weights[i]);
  }
  return study;
}

void weights_plot(Ui& ui, const Probe& probe, int degree, const std::vector<double>& weights, float height) {
  const BasisStudy& study = ui.lab.basis.get(degree, [&] { return basis_study(degree); });
  std::vector<Series> series;
  std::vector<Spot> spots;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    series.push_back({"B" + subscript(i), study.t, study.y[i], row_colour(i), SeriesKind::line, 2.0f});
    spots.push_back({probe.t, weights[i], row_colour(i), ""});
  }
  plot_over_t(
      ui, probe, "Weights plot",
      {.x = {}, .y = {"weight", "", AxisScale::linear, 0, 1}, .series = series, .spots = spots, .height = height},
      "B_i,n(t) = C(n,i) t^i (1-t)^(n-i): never negative, with sum 1 for every t. Drag the cursor to move the probe.");
}

}  // namespace

void weights_page(Ui& ui) {
  const auto probe = need_probe(ui);
  if (!probe) return;
  const int degree = ui.lab.degree;
  std::vector<double> weights(static_cast<std::size_t>(degree) + 1);
  curve::bernstein_basis<double>(probe->t, weights);
  Page page(ui, 200);
  probe_slider(ui, *probe);
  if (const auto to = slider(ui, "Degree n", degree, 1, kLargestDegree, false,
                             "Degree of the basis, 1 to 8. The track's curves are cubic: n = 3."))
    ui.lab.degree = std::clamp(*to, 1, kLargestDegree);
  for (std::size_t i = 0; i < weights.size(); ++i)
    colour_value(ui, row_colour(i), fmt::format("B{}", i),
                 fmt::format("B{}{}{}", subscript(i), degree == 3 ? " weighs p" : "", degree == 3 ? subscript(i) : ""),
                 fixed(weights[i], 4),
                 "C(n,i) t^i (1-t)^(n-i) at the probe: the weight of this control point in B(t).");
  weights_plot(ui, *probe, degree, weights, page.pictures());
}

}  // namespace coaster::ui
