#include "ui/panels/travel_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>

#include "ui/control/run_controller.h"

namespace ui {
namespace {

constexpr int kInstant = 3;  // pieces of work: about 0.2 s
constexpr double kWait = 1;  // s that playing waits: less shows in its pace
constexpr int kWidth = 160;  // px
constexpr int kParts = 1000;

}  // namespace

TravelBar::TravelBar(RunController* controller, QWidget* parent)
    : QWidget(parent), m_controller(controller), m_words(new QLabel), m_progress(new QProgressBar) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 0, 8, 0);
  m_progress->setRange(0, kParts);
  m_progress->setTextVisible(false);
  m_progress->setFixedWidth(kWidth);
  m_progress->setAccessibleName(tr("How far the computing has come"));
  auto* stop = new QPushButton(tr("Stop (Esc)"));
  stop->setFocusPolicy(Qt::TabFocus);
  for (QWidget* part : std::initializer_list<QWidget*>{m_words, m_progress, stop})
    layout->addWidget(part);
  connect(stop, &QPushButton::clicked, controller, &RunController::stopWork);
  connect(controller, &RunController::travelled, this, &TravelBar::showProgress);
  connect(controller, &RunController::framePassed, this, &TravelBar::showWaiting);
  connect(controller, &RunController::playingChanged, this, &TravelBar::showWaiting);
  hide();
}

void TravelBar::showProgress() {
  m_told = m_controller->isTravelling() ? m_told + 1 : 0;
  setVisible(m_told >= kInstant);
  if (m_told < kInstant) return;
  say(tr("Computing: %1 s").arg(QLocale().toString(m_controller->time(), 'f', 1)),
      m_controller->travelProgress());
}

void TravelBar::showWaiting() {
  if (m_controller->isTravelling()) return;
  const double waited = m_controller->waited();
  setVisible(waited > kWait);
  if (waited <= kWait) return;
  say(tr("Computing one step for %1 s").arg(QLocale().toString(waited, 'f', 0)),
      m_controller->stepProgress());
}

void TravelBar::say(const QString& words, double progress) {
  m_words->setText(words);
  m_progress->setValue(static_cast<int>(kParts * progress));
}

}  // namespace ui
