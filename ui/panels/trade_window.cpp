#include "ui/panels/trade_window.h"

#include <QLabel>
#include <QScreen>
#include <QTabBar>
#include <QTabWidget>
#include <QVBoxLayout>

#include "ui/control/open_as_run.h"
#include "ui/control/run_words.h"
#include "ui/control/scene_editor.h"
#include "ui/panels/accuracy_panel.h"
#include "ui/panels/stability_panel.h"

namespace ui {
namespace {

constexpr QSize kFirstSize(1360, 820);

}  // namespace

TradeWindow::TradeWindow(SceneEditor* editor, QWidget* parent)
    : QDialog(parent),
      m_editor(editor),
      m_accuracy(new AccuracyPanel(editor)),
      m_stability(new StabilityPanel(editor)),
      m_opened(new QLabel) {
  setObjectName("trade");
  setWindowTitle(tr("Speed and accuracy"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  auto* tabs = new QTabWidget;
  tabs->setDocumentMode(true);
  tabs->addTab(m_accuracy, tr("Speed and accuracy"));
  tabs->addTab(m_stability, tr("Stability"));
  tabs->tabBar()->setAccessibleName(tr("What is measured"));
  tabs->tabBar()->setAccessibleDescription(tr("What accuracy costs, or how large steps may be"));
  m_opened->setContentsMargins(12, 0, 12, 8);
  m_opened->hide();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 4, 0, 0);
  layout->setSpacing(0);
  layout->addWidget(tabs, 1);
  layout->addWidget(m_opened);
  const QSize room = screen()->availableSize();
  resize(kFirstSize.boundedTo(room * 0.95));
  connect(m_accuracy, &AccuracyPanel::picked, this, &TradeWindow::openAsRun);
}

void TradeWindow::bringUp() {
  show();
  raise();
  activateWindow();
}

void TradeWindow::openAsRun(const core::Solver& solver) {
  const int run = ui::openAsRun(*m_editor, solver);
  m_opened->setText(tr("%1 is run %2 now.").arg(runWords(solver)).arg(run + 1));
  m_opened->show();
}

}  // namespace ui
