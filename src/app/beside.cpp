#include "app/beside.h"

#include <chrono>
#include <utility>

namespace coaster::app {

Beside::Beside(Work work, const std::string&) : result_(std::async(std::launch::async, std::move(work), &progress)) {}
Beside::~Beside() { progress.cancelled = true; }  // the future waits for the thread
bool Beside::is_quick() { return true; }
bool Beside::done() { return result_.wait_for(std::chrono::seconds(0)) == std::future_status::ready; }
base::Result<Found> Beside::take() { return result_.get(); }

}  // namespace coaster::app
