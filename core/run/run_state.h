#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>

namespace core {

struct EngineState;

/// Everything that decides how a run goes on, as a value: taken with Run::state(), given
/// back with Run::restore().
class RunState {
 public:
  RunState();
  ~RunState();
  RunState(const RunState&);
  RunState& operator=(const RunState&);
  RunState(RunState&&) noexcept;
  RunState& operator=(RunState&&) noexcept;

  std::int64_t stepCount() const;
  /// Memory this state takes [bytes].
  std::size_t bytes() const;

 private:
  friend class Run;
  std::unique_ptr<EngineState> m_content;
};

}  // namespace core
