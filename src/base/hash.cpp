#include "base/hash.h"

#include <fmt/format.h>
#include <xxhash.h>

namespace coaster::base {

struct Hasher::State {
  XXH64_state_t* xxh = XXH64_createState();
  ~State() { XXH64_freeState(xxh); }
};

Hasher::Hasher() : state_(std::make_unique<State>()) { XXH64_reset(state_->xxh, 0); }
Hasher::~Hasher() = default;

void Hasher::bytes(const void* data, std::size_t size) {
  if (size > 0) XXH64_update(state_->xxh, data, size);
}

std::uint64_t Hasher::digest() const { return XXH64_digest(state_->xxh); }

std::uint64_t content_hash(std::string_view bytes) { return XXH64(bytes.data(), bytes.size(), 0); }

std::string hex16(std::uint64_t value) { return fmt::format("{:016x}", value); }

}  // namespace coaster::base
