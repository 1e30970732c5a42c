// What queries read.
#pragma once

#include <functional>
#include <string_view>

#include "edit/session/session.h"
#include "query/frame_stats.h"
#include "query/widget.h"

namespace coaster::query {

struct QueryContext {
  edit::SessionFindings find;
  const FrameStats& stats;
  std::string_view toast;  // text of the newest notice, "" if none is shown
  std::string_view title;
  // Code::refused if there is none of that path. Empty outside scripts.
  std::function<base::Result<Widget>(std::string_view path)> widget = {};
  const edit::Session& session = find.session();
};

}  // namespace coaster::query
