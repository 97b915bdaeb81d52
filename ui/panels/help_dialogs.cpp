#include "ui/panels/help_dialogs.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QStyle>
#include <QVBoxLayout>

#include "ui/control/version.h"
#include "ui/panels/form_area.h"
#include "ui/panels/keys_page.h"
#include "ui/style/icons.h"

namespace ui {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::HelpDialogs)
};

// Of the screen's height and width that the keys may take: title, button and margins need some.
constexpr double kKeysShare = 0.84;
constexpr double kMostShare = 0.97;
constexpr double kTaller = 1.25;   // from one try to the next
constexpr double kTallest = 10.0;  // in one column

/// As high as there is room for, or higher where it is too wide then: whoever scrolls, scrolls
/// down.
KeysPage* keysPageFor(const Commands& commands, const QSize& room) {
  for (double share = 1;; share *= kTaller) {
    auto* page = new KeysPage(commands, static_cast<int>(room.height() * share));
    if (page->sizeHint().width() <= room.width() || share > kTallest) return page;
    delete page;
  }
}

}  // namespace

void showKeys(const Commands& commands, QWidget* window) {
  QDialog dialog(window);
  dialog.setWindowTitle(Words::tr("Keys"));
  const QSize available = window->screen()->availableSize();
  const QSize most(static_cast<int>(available.width() * kMostShare),
                   static_cast<int>(available.height() * kKeysShare));
  const QSize bar(dialog.style()->pixelMetric(QStyle::PM_ScrollBarExtent), 0);
  KeysPage* page = keysPageFor(commands, most - bar);
  auto* area = new FormArea(page);
  area->setMinimumSize((page->sizeHint() + bar).boundedTo(most));
  auto* layout = new QVBoxLayout(&dialog);
  layout->addWidget(area);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  buttons->button(QDialogButtonBox::Close)->setIcon(icon("close"));
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  layout->addWidget(buttons);
  dialog.exec();
}

void showAbout(QWidget* window) {
  QMessageBox::about(
      window, Words::tr("About Angry Cuts"),
      Words::tr("<h3>Angry Cuts %1</h3>"
                "<p>Weights hang on ropes and swing; the ropes are cut; the weights fly, bounce "
                "and come to rest. Two numerical methods compute the same scene side by side, and "
                "an energy ledger shows what each of them gets wrong.</p>"
                "<p>Free software under the GNU General Public License, version 3 or later.</p>")
          .arg(version()));
}

}  // namespace ui
