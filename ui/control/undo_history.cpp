#include "ui/control/undo_history.h"

#include <utility>

namespace ui {
namespace {

std::size_t bytesOf(const UndoStep& step) {
  std::size_t bytes = sizeof(UndoStep) + step.change.bytes();
  // Neighbors share what ran, so that this counts it once.
  if (step.ranAfter) bytes += step.ranAfter->weights.size() * sizeof(core::Weight);
  return bytes;
}

}  // namespace

UndoStep* UndoHistory::stepAt(int index) {
  const bool exists = 0 <= index && index < static_cast<int>(m_steps.size());
  return exists ? &m_steps[static_cast<std::size_t>(index)] : nullptr;
}

const UndoStep* UndoHistory::stepBefore(int back) const {
  return const_cast<UndoHistory*>(this)->stepAt(m_undoable - 1 - back);
}

UndoStep* UndoHistory::stepToMergeWith(const QString& mergeKey) {
  UndoStep* last = undoStep();
  if (!last || redoStep() || mergeKey.isEmpty() || last->mergeKey != mergeKey) return nullptr;
  return last;
}

void UndoHistory::add(UndoStep step) {
  m_steps.erase(m_steps.begin() + m_undoable, m_steps.end());
  m_steps.push_back(std::move(step));
  ++m_undoable;
  limit();
}

void UndoHistory::dropLast() {
  m_steps.pop_back();
  --m_undoable;
}

void UndoHistory::closeStep() {
  if (UndoStep* last = undoStep()) last->mergeKey.clear();
}

void UndoHistory::forgetSaved() {
  for (UndoStep& step : m_steps)
    if (step.otherOrigin) step.otherOrigin->savedAt.reset();
}

void UndoHistory::limit() {
  std::size_t bytes = 0;
  for (const UndoStep& step : m_steps) bytes += bytesOf(step);
  while (bytes > m_mostBytes && m_undoable > 1) {
    bytes -= bytesOf(m_steps.front());
    m_steps.pop_front();
    --m_undoable;
    ++m_forgotten;
  }
}

}  // namespace ui
