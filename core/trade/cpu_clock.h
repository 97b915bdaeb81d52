#pragma once

namespace core {

/// Computing time the calling thread has used so far [s]; only differences matter.
///
/// Time during which the computer was busy with something else does not count. Where a system
/// counts per program only, the time of all its threads.
double threadCpuTime();

}  // namespace core
