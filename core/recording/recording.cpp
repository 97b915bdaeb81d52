#include "core/recording/recording.h"

#include <cassert>
#include <iterator>
#include <memory>

namespace core {

void Recording::start(const Run& run) {
  m_states.clear();
  m_cuts.clear();
  m_stateBytes = 0;
  m_stride = 1;
  m_firstStep = m_lastStep = run.stepCount();
  m_ledger.clear();
  m_events.clear();
  m_ledger.append({run.time(), run.energies()});
  m_motion.start(run);
  keep(run);
}

void Recording::record(const Run& run) {
  if (run.stepCount() <= m_lastStep) return;
  m_lastStep = run.stepCount();
  m_ledger.append({run.time(), run.energies()});
  m_events.append(run.stepEvents());
  m_motion.append(run);
  if ((m_lastStep - m_firstStep) % m_stride == 0) keep(run);
}

void Recording::keep(const Run& run) {
  RunState state = run.state();
  m_stateBytes += state.bytes();
  m_states.insert_or_assign(run.stepCount(), std::move(state));
  while (m_stateBytes > m_budget && m_states.size() > 2) thinStates();
}

void Recording::thinStates() {
  m_stride *= 2;
  for (auto it = m_states.begin(); it != m_states.end();) {
    if ((it->first - m_firstStep) % m_stride == 0) {
      ++it;
      continue;
    }
    m_stateBytes -= it->second.bytes();
    it = m_states.erase(it);
  }
}

void Recording::cutAll(Run& run) {
  forgetAfter(run);
  m_cuts.push_back({run.stepCount(), -1});
  run.cutAll();
}

void Recording::cut(Run& run, int weight) {
  forgetAfter(run);
  m_cuts.push_back({run.stepCount(), weight});
  run.cut(weight);
}

void Recording::forgetAfter(const Run& run) {
  const std::int64_t step = run.stepCount();
  m_lastStep = step;
  for (auto it = m_states.upper_bound(step); it != m_states.end(); it = m_states.erase(it))
    m_stateBytes -= it->second.bytes();
  std::erase_if(m_cuts, [step](const HandCut& cut) { return cut.step > step; });
  m_ledger.dropAfter(run.time());
  m_motion.dropAfter(run.time());
  // Of what happened at just this moment only the end of the latest step stays: cuts by hand
  // are listed with the coming step, and what they led to comes anew.
  m_events.dropFrom(run.time());
  for (const Event& event : run.stepEvents())
    if (event.time >= run.time()) m_events.append({&event, 1});
}

RunStatus Recording::advance(Run& run) {
  if (run.advance() == RunStatus::kRunning) completeStep(run);
  return run.status();
}

void Recording::completeStep(Run& run) {
  record(run);
  repeatCuts(run);
}

void Recording::restore(Run& run, std::int64_t step) const {
  beginRestore(run, step);
  while (run.stepCount() < step) replay(run);
}

void Recording::beginRestore(Run& run, std::int64_t step) const {
  assert(m_firstStep <= step && step <= m_lastStep);
  run.restore(keptBefore(step)->second);
  repeatCuts(run);
}

void Recording::replay(Run& run) const {
  assert(m_firstStep <= run.stepCount() && run.stepCount() < m_lastStep);
  run.advance();
  repeatCuts(run);
}

std::int64_t Recording::keptStepBefore(std::int64_t step) const {
  return keptBefore(step)->first;
}

/// One step earlier if there is one, so that the paths that led to the step are there too.
std::map<std::int64_t, RunState>::const_iterator Recording::keptBefore(std::int64_t step) const {
  const auto from = m_states.lower_bound(step);
  return from == m_states.begin() ? from : std::prev(from);
}

void Recording::follow(const Run& run, int weight) {
  if (m_motion.track(weight) != nullptr) return;
  Run past(std::make_shared<const Scene>(run.scene()), run.solver());
  std::vector<MotionSample> samples;
  samples.reserve(m_states.size());
  for (const auto& [step, state] : m_states) {
    past.restore(state);
    samples.push_back({past.time(), past.weight(weight)});
  }
  m_motion.follow(weight, samples);
}

void Recording::repeatCuts(Run& run) const {
  for (const HandCut& cut : m_cuts) {
    if (cut.step != run.stepCount()) continue;
    if (cut.weight < 0) {
      run.cutAll();
    } else {
      run.cut(cut.weight);
    }
  }
}

}  // namespace core
