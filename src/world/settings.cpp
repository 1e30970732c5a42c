// The boxes of the groups of settings.
#include "world/settings.h"

#include "world/aids.h"
#include "world/box_functions.h"
#include "world/camera_feel.h"
#include "world/evaluation.h"
#include "world/lab_view.h"
#include "world/look.h"
#include "world/panels.h"

namespace coaster::world {

template class HeapValue<Aids>;
template class HeapValue<CameraFeel>;
template class HeapValue<Evaluation>;
template class HeapValue<LabView>;
template class HeapValue<Appearance>;
template class HeapValue<Panels>;

}  // namespace coaster::world
