// The laboratory's commands: what is drawn over the scene, which page shows, and measuring. See commands.h.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"
#include "world/settings.h"

namespace coaster::edit {

struct ShowLayer {
  world::Layer what{};
  bool to = true;
  COASTER_COMMAND("show", "Show or hide one of the laboratory's pictures over the scene.", Effect::settings);
  COASTER_FIELDS(visit("", self.what), visit("", self.to))
};
struct SetColouring {
  world::Colouring to{};
  COASTER_COMMAND("colour", "Colour the track by a value of the ride, the curve or the evaluator.", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetMagnification {
  double to = 100'000;
  COASTER_COMMAND("magnification", "Set how many times the rounding layer magnifies an evaluator's errors (1..1e7).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct SetCombScale {
  double to = 100;
  COASTER_COMMAND("comb_scale", "Set the length of the comb's teeth: metres for a curvature of 1/m (0.001..1e6).",
                  Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct ShowLaboratory {
  bool to = true;
  COASTER_COMMAND("laboratory", "Show or fold the laboratory's pages (on, off).", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
struct OpenPage {
  world::LabPage to{};
  COASTER_COMMAND("page", "Choose which page of the laboratory shows.", Effect::settings);
  COASTER_FIELDS(visit("", self.to))
};
// The table of sim/study/measure.h, a part in each frame.
struct Measure {
  COASTER_COMMAND(
      "measure",
      "Measure time and error of every evaluator on this machine, a part in each frame, on curves of this track.",
      Effect::settings);
  COASTER_FIELDS()
};
struct StopMeasuring {
  COASTER_COMMAND("measure.stop", "Stop measuring; what is measured stays.", Effect::settings);
  COASTER_FIELDS()
};
struct SaveMeasurements {
  std::string path;
  COASTER_COMMAND("measure.save", "Write what was measured to a file of comma-separated values.", Effect::session);
  COASTER_FIELDS(visit("", self.path))
};

}  // namespace coaster::edit
