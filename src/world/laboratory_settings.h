// Settings of the laboratory: its layers over the scene, the colouring of the track, the open page.
#pragma once

#include "world/components.h"
#include "world/laboratory.h"
#include "world/layers.h"
#include "world/setting_row.h"

namespace coaster::world {

struct LabView {
  Layers layers;  // set by the command `show`, so without a row
  Colouring colouring{};
  double magnification = 100'000;
  double comb_scale = 100;  // m^2: metres of a tooth for a curvature of 1/m
  LabPage page = LabPage::construction;
  Seat seat = Seat::middle;
  int seat_car = 1;  // of Seat::car, from 1
  friend bool operator==(const LabView&, const LabView&) = default;

  static constexpr auto kRows = std::tuple{
      setting(&LabView::colouring, "colour", "Value that colours the track."),
      setting(&LabView::magnification, "magnification",
              "How many times the rounding layer magnifies an evaluator's errors.", {.low = 1, .high = 1e7}),
      setting(&LabView::comb_scale, "comb_scale", "Length of the comb's teeth: metres for a curvature of 1/m.",
              {.low = 0.001, .high = 1e6, .unit = "m^2"}),
      setting(&LabView::page, "page", "Page of the laboratory that is open."),
      setting(&LabView::seat, "seat", "Seat whose ride the plots show."),
      setting(&LabView::seat_car, "seat_car", "Car of the seat called car, counted from the front.",
              {.low = 1, .high = kMaxCars})};
};

}  // namespace coaster::world
