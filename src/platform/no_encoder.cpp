// Encoder for a program that is not in a page.
#include "platform/encoder.h"

namespace coaster::platform {

bool Encoder::in_page() { return false; }
base::Result<std::unique_ptr<Encoder>> Encoder::start(int) {
  return base::Status{base::Code::refused, "Only a browser has an encoder."};
}
Encoder::~Encoder() = default;
bool Encoder::ready() const { return true; }
base::Status Encoder::add(int, int, std::span<const std::uint8_t>) { return {}; }
void Encoder::finish(const std::string&) {}
std::optional<std::string> Encoder::poll() { return std::nullopt; }
double Encoder::done() const { return 0; }

}  // namespace coaster::platform
