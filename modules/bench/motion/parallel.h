// Independent pieces of a bench on several threads.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace regista::bench {

/// Calls work(0) … work(count - 1), each once, on up to `jobs` >= 1 threads, and shows progress as `what`. Rethrows the
/// first exception after all threads have ended; work not begun by then is left out.
void in_parallel(const std::string& what, std::size_t count, std::size_t jobs,
                 const std::function<void(std::size_t)>& work);

}  // namespace regista::bench
