#include "core/trade/work_meter.h"

#include <algorithm>

namespace core {

bool WorkMeter::add(double work) {
  const std::scoped_lock lock(m_mutex);
  m_done += work;
  if (m_goesOn && m_progress) m_goesOn = m_progress(std::min(1.0, m_done / m_total));
  return m_goesOn;
}

}  // namespace core
