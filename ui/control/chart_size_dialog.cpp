#include "ui/control/chart_size_dialog.h"

#include <array>

#include <QComboBox>
#include <QCoreApplication>
#include <QDialog>
#include <QDialogButtonBox>
#include <QFormLayout>
#include <QSpinBox>

namespace ui {
namespace {

constexpr int kLeast = 40;   // mm
constexpr int kMost = 1000;  // mm

struct Words {
  Q_DECLARE_TR_FUNCTIONS(ui::ChartSizeDialog)
};

/// A size with a name.
struct Preset {
  const char* name;
  QSize size;  // mm
};

constexpr std::array kPresets = {
    Preset{QT_TRANSLATE_NOOP("ui::ChartSizeDialog", "Page width"), QSize(160, 100)},
    Preset{QT_TRANSLATE_NOOP("ui::ChartSizeDialog", "Half the page width"), QSize(80, 60)},
    Preset{QT_TRANSLATE_NOOP("ui::ChartSizeDialog", "Slide, 16:9"), QSize(254, 143)},
    Preset{QT_TRANSLATE_NOOP("ui::ChartSizeDialog", "Poster, A3"), QSize(420, 297)},
};

/// Two fields in mm, and names for sizes that are often wanted.
class Dialog : public QDialog {
 public:
  Dialog(QWidget* window, QSize suggested)
      : QDialog(window), m_width(new QSpinBox), m_height(new QSpinBox), m_preset(new QComboBox) {
    setWindowTitle(Words::tr("Size of the chart"));
    for (QSpinBox* field : {m_width, m_height}) {
      field->setRange(kLeast, kMost);
      field->setSuffix(Words::tr(" mm"));
      connect(field, &QSpinBox::valueChanged, this, [this] { showPreset(); });
    }
    m_preset->setToolTip(Words::tr("Sizes that are often wanted"));
    m_width->setToolTip(Words::tr("Width of the chart on paper, in mm"));
    m_height->setToolTip(Words::tr("Height of the chart on paper, in mm"));
    m_preset->setAccessibleName(Words::tr("Purpose"));
    m_width->setAccessibleName(Words::tr("Width"));
    m_height->setAccessibleName(Words::tr("Height"));
    for (const Preset& preset : kPresets) m_preset->addItem(Words::tr(preset.name));
    m_preset->addItem(Words::tr("Own size"));
    connect(m_preset, &QComboBox::activated, this, [this](int index) { takePreset(index); });

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto* rows = new QFormLayout(this);
    rows->addRow(Words::tr("&For"), m_preset);
    rows->addRow(Words::tr("&Width"), m_width);
    rows->addRow(Words::tr("&Height"), m_height);
    rows->addRow(buttons);
    showSize(suggested);
  }

  QSize chosen() const { return {m_width->value(), m_height->value()}; }

 private:
  void showSize(QSize size) {
    m_width->setValue(size.width());
    m_height->setValue(size.height());
    showPreset();
  }

  void takePreset(int index) {
    if (index < static_cast<int>(kPresets.size())) showSize(kPresets[index].size);
  }

  void showPreset() {
    int index = 0;
    while (index < static_cast<int>(kPresets.size()) && kPresets[index].size != chosen()) ++index;
    m_preset->setCurrentIndex(index);
  }

  QSpinBox* m_width;
  QSpinBox* m_height;
  QComboBox* m_preset;
};

}  // namespace

bool isChartSize(QSizeF size) {
  const auto fits = [](double length) { return kLeast <= length && length <= kMost; };
  return fits(size.width()) && fits(size.height());
}

std::optional<QSizeF> askChartSize(QWidget* window, QSizeF suggested) {
  Dialog dialog(window, suggested.toSize());
  if (dialog.exec() != QDialog::Accepted) return std::nullopt;
  return QSizeF(dialog.chosen());
}

}  // namespace ui
