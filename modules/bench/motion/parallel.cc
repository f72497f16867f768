#include "modules/bench/motion/parallel.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "modules/bench/progress.h"

namespace regista::bench {

void in_parallel(const std::string& what, std::size_t count, std::size_t jobs,
                 const std::function<void(std::size_t)>& work) {
  Progress progress(what, count);
  std::atomic<std::size_t> next{0};
  std::mutex mutex;  // of progress and error
  std::exception_ptr error;
  const auto worker = [&] {
    for (std::size_t i = next++; i < count; i = next++) {
      std::exception_ptr thrown;
      try {
        work(i);
      } catch (...) {
        thrown = std::current_exception();
        next = count;
      }
      const std::scoped_lock lock(mutex);
      if (thrown != nullptr && error == nullptr) error = thrown;
      progress.advance();
    }
  };
  std::vector<std::jthread> threads;
  for (std::size_t k = 1; k < std::min(jobs, count); ++k) threads.emplace_back(worker);
  worker();
  threads.clear();
  if (error != nullptr) std::rethrow_exception(error);
}

}  // namespace regista::bench
