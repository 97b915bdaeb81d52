#pragma once

#include <memory>
#include <vector>

#include <QDialog>

#include "core/aim/cut_sweep.h"

class QTimer;

namespace ui {

class BackgroundTask;
class CutQuestions;
class CutResults;
class SceneEditor;
class SceneTarget;
class TaskRow;
struct CutSweepResult;

/// When to cut? Landing place of a weight against cut time, and the moments that hit the target,
/// found in the background. Beside the main window, which stays usable.
class CutWindow : public QDialog {
  Q_OBJECT

 public:
  CutWindow(SceneEditor* editor, SceneTarget* target, QWidget* parent = nullptr);
  ~CutWindow() override;

  /// Shows the window, in front of others, and the target; finds the moments if need be.
  void bringUp();

  /// The latest sweep, with the hits on the target as it is; null if there is none.
  const std::shared_ptr<const CutSweepResult>& result() const;
  CutResults* results() const { return m_results; }

 public slots:
  /// Sweeps the scene as the questions say; what is under way is given up.
  void find();

 signals:
  /// The scene cuts all ropes at this time [s] from now on: the user chose it.
  void momentPicked(double cutTime);

 private:
  struct Work;

  void connectParts();
  void noteTarget();
  void noteScene();
  void forget();
  void begin(bool sweepsAnew);
  void finish(const std::vector<core::Hit>& hits, const core::Target& target);
  void goOn();
  void pick(double cutTime);
  bool findsByItself() const;

  SceneEditor* m_editor;
  SceneTarget* m_target;
  BackgroundTask* m_task;
  TaskRow* m_row;
  CutQuestions* m_questions;
  CutResults* m_results;
  QTimer* m_pause;               // so that hits are not looked for at every pixel of a drag
  bool m_wantsSweep = false;     // once what is under way has ended
  bool m_wantsHits = false;      // likewise
  std::shared_ptr<Work> m_work;  // the latest sweep; used by one thread at a time
};

}  // namespace ui
