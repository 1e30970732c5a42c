// What queries read.
#pragma once

#include <functional>
#include <string>
#include <string_view>

#include "edit/session/session.h"
#include "query/frame_stats.h"

namespace coaster::query {

struct Context {
  edit::Finder find;
  const FrameStats& stats;
  std::string_view toast;  // text of the newest notice, "" if none is shown
  std::string_view title;
  std::function<base::Result<std::string>(std::string_view path)> widget_text = {};  // empty outside scripts
  const edit::Session& session = find.session();
};

}  // namespace coaster::query
