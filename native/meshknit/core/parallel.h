#pragma once

#include <functional>

namespace meshknit {

/// On how many threads for_each_in_parallel works: one for each processor that this process may use,
/// but no more than there are things to do. At least 1.
int workers_for(int count);

/// Calls work(k, worker) once for every k in [0, count), on workers_for(count) threads. They begin in
/// the order of k. The caller's own thread is worker 0 and, where no other can be had, the only one.
/// Scratch may be kept for each worker; what is computed for k must not depend on the worker.
/// Throws: what the work for the lowest k throws that throws at all, as a plain loop would; work that
/// was begun before is done then, and what comes after may or may not be.
void for_each_in_parallel(int count, const std::function<void(int k, int worker)>& work);

}  // namespace meshknit
