#include "ui/panels/presentation_header.h"

#include <QHBoxLayout>
#include <QLocale>

#include "ui/panels/large_label.h"

namespace ui {
namespace {

constexpr double kTimeShare = 1.4;

}  // namespace

PresentationHeader::PresentationHeader(QWidget* parent)
    : QWidget(parent),
      m_sentence(new QLabel),
      m_time(new LargeLabel(kTimeShare, QStringLiteral("000.000 s"))) {
  m_sentence->setTextFormat(Qt::PlainText);
  m_sentence->setWordWrap(true);
  m_time->setAlignment(Qt::AlignRight | Qt::AlignTop);
  m_time->setAccessibleName(tr("Simulated time"));
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(12, 6, 12, 6);
  layout->setSpacing(24);
  layout->addWidget(m_sentence, 1);
  layout->addWidget(m_time, 0, Qt::AlignTop | Qt::AlignRight);
  hide();
}

void PresentationHeader::showTime(double time) {
  m_time->setText(tr("%1 s").arg(QLocale().toString(time, 'f', 3)));
}

}  // namespace ui
