#pragma once

#include <chrono>
#include <memory>
#include <optional>

#include <QLockFile>
#include <QObject>
#include <QString>
#include <QTimer>

#include "core/scene/scene.h"
#include "ui/control/background_task.h"

namespace ui {

struct KeptDraft;
class SceneEditor;

/// Where drafts are kept for a start after a crash.
QString draftFolder();

/// Keeps what is edited and not saved in a file of its own, so that a crash or a power cut
/// takes no more than the last few seconds. Writes beside the window, and only when there is
/// something new. A lock beside the file says that somebody still works on it.
class DraftKeeper : public QObject {
  Q_OBJECT

 public:
  /// With the time that writing takes on a slow disk, well below the ten seconds promised.
  static constexpr std::chrono::milliseconds kUsualDelay{5000};

  /// @param folder  is made when it is needed
  /// @param delay   from a change until it is written, at most
  DraftKeeper(const SceneEditor* editor, const QString& folder,
              std::chrono::milliseconds delay = kUsualDelay, QObject* parent = nullptr);
  /// Lets a file that is being written become complete. What is kept stays.
  ~DraftKeeper() override;

  QString file() const { return m_file; }
  static QString lockOf(const QString& draftFile);

  /// Writes what is not saved, and waits until it is on the disk.
  /// @return  whether it is
  bool keepAndWait();

 public slots:
  /// Writes what is not saved, beside the window.
  void keepNow();
  /// What was not saved is not wanted any more, such as at the end.
  void letGo();

 signals:
  /// What is edited cannot be kept; said once until it can again.
  void failed(const QString& reason);

 private:
  /// What is or was written.
  struct Content {
    QString file;
    std::shared_ptr<const core::Scene> scene;
    std::optional<core::Scene> draft;

    bool operator==(const Content&) const = default;
  };

  void follow();
  Content content() const;
  QString prepare();
  void note(const Content& written, const QString& error);
  void remove();

  const SceneEditor* m_editor;
  QString m_file;
  QLockFile m_lock;
  QTimer m_timer{this};
  std::optional<Content> m_written;
  bool m_hasFailed = false;
  bool m_isWanted = true;  // false: what is being written is to go again
  std::unique_ptr<BackgroundTask> m_task;
};

}  // namespace ui
