#include "ui/view/scene_accessible.h"

#include <QAccessibleWidget>

#include "ui/view/scene_view.h"

namespace ui {
namespace {

class SceneAccessible : public QAccessibleWidget {
 public:
  explicit SceneAccessible(SceneView* view)
      : QAccessibleWidget(view, QAccessible::Graphic), m_view(view) {}

  QString text(QAccessible::Text part) const override {
    return part == QAccessible::Value ? m_view->announcement() : QAccessibleWidget::text(part);
  }

 private:
  SceneView* m_view;
};

QAccessibleInterface* newAccessible(const QString&, QObject* object) {
  auto* view = qobject_cast<SceneView*>(object);
  return view ? new SceneAccessible(view) : nullptr;
}

}  // namespace

void installSceneAccessible() {
  // Installing the same one again does nothing.
  QAccessible::installFactory(newAccessible);
}

}  // namespace ui
