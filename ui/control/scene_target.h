#pragma once

#include <QObject>

#include "core/aim/target.h"
#include "core/scene/scene.h"

namespace ui {

/// The target on the floor and the weight that is to hit it. Not part of the scene: it stays
/// while the window is open, and always fits the scene.
class SceneTarget : public QObject {
  Q_OBJECT

 public:
  explicit SceneTarget(const core::Scene& scene, QObject* parent = nullptr);

  bool isShown() const { return m_isShown; }
  const core::Target& place() const { return m_place; }
  /// Index.
  int weight() const { return m_weight; }

  /// Keeps weight and place within another scene; a place outside of its room starts anew.
  void fitInto(const core::Scene& scene);

 public slots:
  void setShown(bool shown);
  void setPlace(const core::Target& place);
  void setWeight(int index);

 signals:
  /// Something of it is not what it was.
  void changed();

 private:
  core::Target m_place;
  int m_weight = 0;
  bool m_isShown = false;
  int m_weightCount = 0;
};

}  // namespace ui
