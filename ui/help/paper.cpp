#include "ui/help/paper.h"

#include <string_view>

#include <QBuffer>
#include <QCoreApplication>
#include <QPageSize>
#include <QPdfWriter>
#include <QPrintDialog>
#include <QPrinter>
#include <QTextDocument>

#include "ui/files/output_file.h"

namespace ui {
namespace {

/// QTextDocument leaves two centimetres itself.
void leaveMarginsToTheDocument(QPagedPaintDevice* paper) {
  paper->setPageMargins(QMarginsF());
}

}  // namespace

void printDocument(const QTextDocument& document, QPagedPaintDevice* paper) {
  leaveMarginsToTheDocument(paper);
  document.print(paper);
}

bool askAndPrint(const QTextDocument& document, const QString& title, QWidget* window) {
  QPrinter printer(QPrinter::HighResolution);
  printer.setDocName(title);
  printer.setFullPage(true);
  QPrintDialog dialog(&printer, window);
  dialog.setWindowTitle(title);
  if (dialog.exec() != QDialog::Accepted) return false;
  printDocument(document, &printer);
  return true;
}

QString writePdf(const QTextDocument& document, const QString& title, const QString& file) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  {
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setCreator(QCoreApplication::applicationName());
    writer.setTitle(title);
    printDocument(document, &writer);
  }
  OutputFile target;
  const std::string_view whole(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  const bool written = target.open(file) && target.write(whole) && target.finish();
  return written ? QString() : target.error();
}

}  // namespace ui
