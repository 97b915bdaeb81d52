#include "ui/panels/lesson_panel.h"

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLayoutItem>
#include <QToolButton>
#include <QVBoxLayout>

#include "core/scene/scene.h"
#include "ui/control/commands.h"
#include "ui/files/lessons.h"

namespace ui {
namespace {

constexpr QSize kIconSize(20, 20);

QLabel* paragraph(const QString& words = {}) {
  auto* label = new QLabel(words);
  label->setTextFormat(Qt::PlainText);
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  return label;
}

QLabel* heading(const QString& words = {}) {
  QLabel* label = paragraph(words);
  QFont bold = label->font();
  bold.setBold(true);
  label->setFont(bold);
  return label;
}

QToolButton* buttonFor(QAction* action, const QString& words) {
  auto* button = new QToolButton;
  button->setIcon(action->icon());
  button->setText(words);
  button->setToolTip(action->toolTip());
  button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  button->setIconSize(kIconSize);
  button->setFocusPolicy(Qt::TabFocus);
  QObject::connect(button, &QToolButton::clicked, action, &QAction::trigger);
  return button;
}

}  // namespace

LessonPanel::LessonPanel(const Commands& commands, QWidget* parent)
    : QWidget(parent),
      m_title(heading()),
      m_look(paragraph()),
      m_tryHeading(heading(tr("To try"))),
      m_tries(new QGridLayout) {
  m_tryHeading->hide();
  m_tries->setContentsMargins(0, 0, 0, 0);
  m_tries->setHorizontalSpacing(8);
  m_tries->setVerticalSpacing(6);
  m_tries->setColumnStretch(1, 1);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(buttonFor(commands.action(Command::kLessons), tr("All lessons")));
  buttons->addWidget(buttonFor(commands.action(Command::kSheet), tr("Sheet")));
  buttons->addStretch(1);
  buttons->addWidget(buttonFor(commands.action(Command::kLessonText), tr("Hide")));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(12, 10, 12, 8);
  layout->setSpacing(8);
  layout->addWidget(m_title);
  layout->addWidget(m_look);
  layout->addWidget(m_tryHeading);
  layout->addLayout(m_tries);
  layout->addStretch(1);
  layout->addLayout(buttons);
}

void LessonPanel::showScene(const core::Scene& scene) {
  const QString name = lessonNameOf(scene);
  if (name.isEmpty()) {
    m_title->setText(QString::fromStdString(scene.name));
    m_look->setText(QString::fromStdString(scene.description));
    showTries({});
    return;
  }
  const Lesson lesson = lessonNamed(name);
  m_title->setText(lesson.title);
  m_look->setText(lesson.look);
  showTries(lesson.tries);
}

void LessonPanel::showTries(const QStringList& tries) {
  if (tries == m_shownTries) return;
  m_shownTries = tries;
  while (QLayoutItem* item = m_tries->takeAt(0)) {
    delete item->widget();
    delete item;
  }
  for (int i = 0; i < static_cast<int>(tries.size()); ++i) {
    m_tries->addWidget(new QLabel(QStringLiteral("•")), i, 0, Qt::AlignTop);
    m_tries->addWidget(paragraph(tries[i]), i, 1);
  }
  m_tryHeading->setVisible(!tries.isEmpty());
}

}  // namespace ui
