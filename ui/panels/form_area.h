#pragma once

#include <QScrollArea>

namespace ui {

/// A form as high as it likes if there is room; where there is not, it scrolls rather than
/// squeezes. As wide as its fields need, in whatever type, but never most of the screen.
class FormArea : public QScrollArea {
  Q_OBJECT

 public:
  enum class Height { kScrolls, kWhole };

  /// @param height  kWhole: it is so important that it is never scrolled away
  explicit FormArea(QWidget* form, Height height = Height::kScrolls);

  QSize sizeHint() const override { return widget()->sizeHint(); }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fitToForm();

  Height m_height;
};

}  // namespace ui
