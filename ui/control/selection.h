#pragma once

#include <optional>

#include <QObject>

namespace ui {

class SceneEditor;

/// Which weight of the scene is selected, for all parts of the window to follow: one or none.
///
/// Belongs to the weights of the editor's draft. Another scene starts with none, and so does a
/// change that takes the selected weight away.
class Selection : public QObject {
  Q_OBJECT

 public:
  explicit Selection(const SceneEditor* editor, QObject* parent = nullptr);

  /// Index of the selected weight.
  std::optional<int> weight() const;

 public slots:
  /// @param weight  index; one that no weight of the draft has, such as −1, selects none
  void select(int weight);
  void clear() { select(kNone); }
  /// Selects the next weight in the order of the list; after the last one the first.
  void selectNext() { selectBeside(1); }
  void selectPrevious() { selectBeside(-1); }
  /// Says again what is selected, for those who have just begun to listen.
  void tellAgain() { emit weightSelected(m_weight); }

 signals:
  /// Another weight is selected: its index, or −1 for none.
  void weightSelected(int weight);

 private:
  static constexpr int kNone = -1;

  int count() const;
  void selectBeside(int way);

  const SceneEditor* m_editor;
  int m_weight = kNone;
};

}  // namespace ui
