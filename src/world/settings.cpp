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

template class Box<Aids>;
template class Box<CameraFeel>;
template class Box<Evaluation>;
template class Box<LabView>;
template class Box<Look>;
template class Box<Panels>;

}  // namespace coaster::world
