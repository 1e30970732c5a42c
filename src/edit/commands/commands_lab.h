// The laboratory's commands: layers over the scene, and measurements. See command.h.
#pragma once

#include <string>

#include "edit/commands/command_fields.h"
#include "world/settings.h"

namespace coaster::edit {
COASTER_COMMAND_GROUP(Lab);

struct ShowLayer {
  world::Layer what{};
  bool to = true;
  COASTER_COMMAND(ShowLayer, "show", "Show or hide one of the laboratory's pictures over the scene.", Effect::settings);
  COASTER_FIELDS(visit("", self.what), visit("", self.to))
};
// Measures the table of sim/study/evaluator_benchmark.h, a part per frame.
struct StartMeasuring {
  COASTER_COMMAND(
      StartMeasuring, "measure",
      "Measure time and error of every evaluator on this machine, a part in each frame, on the curves of this track.",
      Effect::settings);
  COASTER_FIELDS()
};
struct StopMeasuring {
  COASTER_COMMAND(StopMeasuring, "measure.stop", "Stop measuring; results so far are kept.", Effect::settings);
  COASTER_FIELDS()
};
struct SaveMeasurements {
  std::string path;
  COASTER_COMMAND(SaveMeasurements, "measure.save", "Write the measurements to a file of comma-separated values.",
                  Effect::session, {}, kWritesFile);
  COASTER_FIELDS(visit("", self.path))
};

COASTER_COMMAND_LIST(Lab, ShowLayer, StartMeasuring, StopMeasuring, SaveMeasurements);

}  // namespace coaster::edit
