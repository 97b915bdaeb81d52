#pragma once

namespace core {

/// Computing time the calling thread has used so far [s]; only differences matter.
///
/// Time during which the computer was busy with something else does not count. Windows counts
/// in steps of 1/64 s.
double threadCpuTime();

}  // namespace core
