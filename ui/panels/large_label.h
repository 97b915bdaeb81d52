#pragma once

#include <QLabel>

namespace ui {

/// Words in larger type than the widget around them, however large that is at the moment.
class LargeLabel : public QLabel {
  Q_OBJECT

 public:
  /// @param share    of the window's type size, ≥ 1
  /// @param longest  common text, for which room is kept so that nothing moves; may be empty
  explicit LargeLabel(double share, const QString& longest = {}, QWidget* parent = nullptr);

 protected:
  bool event(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void followParent();
  void applySize();

  double m_share;
  QString m_longest;
};

}  // namespace ui
