#include "ui/panels/help_dialogs.h"

#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
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

// Of the screen's height that the keys may take: title, button and margins need some, too.
constexpr double kKeysShare = 0.84;
constexpr double kMostShare = 0.97;

}  // namespace

void showKeys(const Commands& commands, QWidget* window) {
  QDialog dialog(window);
  dialog.setWindowTitle(Words::tr("Keys"));
  const QSize available = window->screen()->availableSize();
  auto* page = new KeysPage(commands, static_cast<int>(available.height() * kKeysShare));
  auto* area = new FormArea(page);
  area->setMinimumSize(page->sizeHint().boundedTo(available * kMostShare));
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
