// An allocator for LD_PRELOAD whose call number FAIL_AT fails, counted from the program's new-handler on.
#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> calls{0};

long failing_call() {
  const char* const text = std::getenv("FAIL_AT");
  return text != nullptr ? std::atol(text) : 0;
}

}  // namespace

void* operator new(std::size_t size) {
  static const long fail_at = failing_call();
  for (;;) {
    const std::new_handler handler = std::get_new_handler();
    const bool fails = handler != nullptr && ++calls == fail_at;
    void* const memory = fails ? nullptr : std::malloc(size == 0 ? 1 : size);
    if (memory != nullptr) return memory;
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
