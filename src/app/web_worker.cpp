// A page has no threads. Its worker is a second instance of the program with a copy of the page's memory, so it does
// the work as a thread would, and sends back what it finds as text (packaging/web/page.js).
#include <emscripten.h>

#include <cstdlib>
#include <cstring>
#include <utility>

#include "app/long_job.h"
#include "base/cancellable_job.h"

namespace coaster::app {
namespace {

// clang-format off
EM_JS(int, begin_work, (const void* work, const char* file), {
  return Module.coasterWork ? Module.coasterWork.begin(work, UTF8ToString(file)) : 0;
});
EM_JS(double, part_done, (), { return Module.coasterWork.part; });
EM_JS(int, is_over, (), { return Module.coasterWork.found === undefined ? 0 : 1; });
EM_JS(void, end_work, (), { Module.coasterWork.end(); });
EM_JS(char*, found_text, (), {
  const size = lengthBytesUTF8(Module.coasterWork.found) + 1;
  const text = _malloc(size);
  stringToUTF8(Module.coasterWork.found, text, size);
  return text;
});
EM_JS(void, tell_part, (double part), { postMessage({ part: part }); });
// clang-format on

}  // namespace

// Called in the worker: returns what the work finds, as text.
extern "C" EMSCRIPTEN_KEEPALIVE const char* coaster_work(BackgroundWork::Work* work) {
  base::JobProgress progress;
  progress.told = tell_part;
  const base::JobScope watched(&progress);
  return ::strdup(print_job_result((*work)()).c_str());
}

BackgroundWork::BackgroundWork(Work work, const std::string& file) : work_(std::make_unique<Work>(std::move(work))) {
  if (begin_work(work_.get(), file.c_str()) != 0) in_worker_ = true;
}

BackgroundWork::~BackgroundWork() {
  if (in_worker_) end_work();
}

bool BackgroundWork::is_quick() { return false; }
bool BackgroundWork::done() {
  if (!in_worker_ || progress.cancelled) return true;
  progress.report(part_done());
  return is_over() != 0;
}

base::Result<JobResult> BackgroundWork::take() {
  if (progress.cancelled) return base::Status{base::Code::refused, "cancelled"};
  if (!in_worker_) {
    const base::JobScope watched(&progress);
    return (*work_)();
  }
  char* const text = found_text();
  base::Result<JobResult> found = parse_job_result(text);
  std::free(text);
  return found;
}

void watch_work(const std::function<void()>& work, base::JobProgress&, double, const std::function<void()>&) { work(); }

}  // namespace coaster::app
