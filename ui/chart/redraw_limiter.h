#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace ui {

/// Turns many requests to redraw something into few redraws, the last of which is never
/// left out.
class RedrawLimiter : public QObject {
  Q_OBJECT

 public:
  /// @param shortestPause  between redraws [ms]
  explicit RedrawLimiter(int shortestPause, QObject* parent = nullptr);

  /// Something has changed: due() comes at once, or when the pause is over.
  void request();
  /// due() comes at once.
  void hurry();

 signals:
  void due();

 private:
  int m_shortestPause;
  QElapsedTimer m_sinceDue;
  QTimer m_catchUp;
};

}  // namespace ui
