#pragma once

#include <QStringList>
#include <QWidget>

class QGridLayout;
class QLabel;

namespace core {
struct Scene;
}

namespace ui {

class Commands;

/// What to look for in a scene and what to try with it. Of somebody's own scene it shows name
/// and description.
class LessonPanel : public QWidget {
  Q_OBJECT

 public:
  /// @param commands  whose buttons stand below the text
  explicit LessonPanel(const Commands& commands, QWidget* parent = nullptr);

  void showScene(const core::Scene& scene);

 private:
  void showTries(const QStringList& tries);

  QStringList m_shownTries;
  QLabel* m_title;
  QLabel* m_look;
  QLabel* m_tryHeading;
  QGridLayout* m_tries;
};

}  // namespace ui
