#pragma once

#include <QProxyStyle>

namespace ui {

/// Fusion with check boxes that stand out in the dark, too: its own outlines are darker than the
/// window, and nothing on a dark one.
class OutlinedStyle : public QProxyStyle {
  Q_OBJECT

 public:
  OutlinedStyle() : QProxyStyle(QStringLiteral("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget = nullptr) const override;
};

}  // namespace ui
