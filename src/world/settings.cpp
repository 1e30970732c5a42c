// The boxes of the groups of settings.
#include "world/settings.h"

#include "world/aid_settings.h"
#include "world/appearance_settings.h"
#include "world/camera_feel.h"
#include "world/evaluation_settings.h"
#include "world/heap_value_functions.h"
#include "world/laboratory_settings.h"
#include "world/panel_settings.h"

namespace coaster::world {

template class HeapValue<EditingAids>;
template class HeapValue<CameraFeel>;
template class HeapValue<Evaluation>;
template class HeapValue<LabView>;
template class HeapValue<Appearance>;
template class HeapValue<Panels>;

}  // namespace coaster::world
