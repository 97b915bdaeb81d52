#pragma once

#include <memory>

#include <QObject>
#include <QString>
#include <QStringList>

class QLockFile;

namespace ui {

class DraftKeeper;
class SceneEditor;
class SceneFiles;
struct KeptDraft;

/// Finds drafts that a crash or a power cut has left, and offers them one after the other.
/// One that is neither brought back nor discarded is offered again at the next start.
class Recovery : public QObject {
  Q_OBJECT

 public:
  /// @param folder  of drafts, those of running programs among them
  Recovery(SceneEditor* editor, SceneFiles* files, DraftKeeper* keeper, const QString& folder,
           QObject* parent = nullptr);
  ~Recovery() override;

  /// Looks for drafts; call once somebody listens.
  void start();
  /// Offers the same draft again, if one is offered, for those who have just begun to listen.
  void offerAgain();

 public slots:
  /// Brings the draft that is offered back, unless the user wants to stay with the scene.
  void bringBack();
  /// Deletes the draft that is offered.
  void discard();

 signals:
  /// A draft can be brought back, in words; empty: no more.
  void offered(const QString& words);

 private:
  void offerNext();
  bool take(const QString& file);
  void removeOffered();

  SceneEditor* m_editor;
  SceneFiles* m_files;
  DraftKeeper* m_keeper;
  QString m_folder;
  QStringList m_found;  // not offered yet, the latest last

  // What is offered.
  QString m_file;
  std::unique_ptr<QLockFile> m_lock;
  std::unique_ptr<KeptDraft> m_kept;
};

}  // namespace ui
