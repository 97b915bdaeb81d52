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

void TaskRow::add(const QString& name, QWidget* control) {
  if (!name.isEmpty()) m_layout->insertWidget(m_layout->indexOf(m_button), new QLabel(name));
  m_layout->insertWidget(m_layout->indexOf(m_button), control);
}

void TaskRow::addLast(QWidget* control) {
  m_layout->addWidget(control);
}

/// The button was there first, but stands among the others.
void TaskRow::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  QWidget* last = nullptr;
  for (int i = 0; i < m_layout->count(); ++i) {
    QWidget* control = m_layout->itemAt(i)->widget();
    if (!control || qobject_cast<QLabel*>(control) || control == m_progress) continue;
    if (control->focusProxy()) control = control->focusProxy();
    if (last) setTabOrder(last, control);
    last = control;
  }
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
