#include "ui/panels/task_row.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include "ui/control/background_task.h"

namespace ui {
namespace {

constexpr int kButtonWidth = 120;  // px
constexpr int kProgressWidth = 160;

}  // namespace

TaskRow::TaskRow(BackgroundTask* task, const QString& start, QWidget* parent)
    : QWidget(parent),
      m_task(task),
      m_start(start),
      m_layout(new QHBoxLayout(this)),
      m_button(new QPushButton(start)),
      m_progress(new QProgressBar) {
  m_layout->setContentsMargins(12, 8, 12, 4);
  m_layout->setSpacing(10);
  m_button->setMinimumWidth(kButtonWidth);
  m_button->setDefault(true);
  m_progress->setMinimumWidth(kProgressWidth);
  m_progress->setAccessibleName(tr("Progress"));
  QSizePolicy keepsItsPlace = m_progress->sizePolicy();
  keepsItsPlace.setRetainSizeWhenHidden(true);
  m_progress->setSizePolicy(keepsItsPlace);
  m_progress->hide();
  m_button->setToolTip(tr("Compute in the background; the same button stops it"));
  m_layout->addWidget(m_button);
  m_layout->addWidget(m_progress, 1);
  connect(m_button, &QPushButton::clicked, this, &TaskRow::press);
  connect(task, &BackgroundTask::runningChanged, this, &TaskRow::showRunning);
  connect(task, &BackgroundTask::progressed, m_progress, &QProgressBar::setValue);
}

/// The button and the progress stay behind, also for Tab, which goes by who came first.
void TaskRow::add(const QString& name, QWidget* control) {
  for (QWidget* behind : {static_cast<QWidget*>(m_button), static_cast<QWidget*>(m_progress)}) {
    m_layout->removeWidget(behind);
    behind->setParent(nullptr);
  }
  if (!name.isEmpty()) m_layout->addWidget(new QLabel(name));
  m_layout->addWidget(control);
  m_layout->addWidget(m_button);
  m_layout->addWidget(m_progress, 1);
}

void TaskRow::addLast(QWidget* control) {
  m_layout->addWidget(control);
}

void TaskRow::press() {
  if (m_task->isRunning()) {
    m_task->cancel();
  } else {
    emit startWanted();
  }
}

void TaskRow::showRunning(bool running) {
  m_button->setText(running ? tr("Cancel") : m_start);
  m_progress->setVisible(running);
}

}  // namespace ui
