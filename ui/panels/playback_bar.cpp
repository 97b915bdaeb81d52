#include "ui/panels/playback_bar.h"

#include <algorithm>
#include <cmath>

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/control/commands.h"
#include "ui/control/quantity_text.h"
#include "ui/panels/large_label.h"

namespace ui {
namespace {

// Speeds are powers of two.
constexpr int kSlowest = -6;
constexpr int kFastest = 2;

constexpr double kTimeType = 2;       // times the base type
constexpr double kMostlyKept = 0.97;  // of the speed: less is noticed and shown
constexpr double kLeastPace = 0.01;   // of real time: less is as good as standing still
constexpr QSize kIconSize(26, 26);
constexpr int kSliderWidth = 120;  // px
constexpr int kSpacing = 12;       // px

int exponentOf(double speed) {
  return std::clamp(static_cast<int>(std::lround(std::log2(speed))), kSlowest, kFastest);
}

QString speedText(double speed) {
  return fractionText(speed) + QStringLiteral("×");
}

/// @param pace  simulated seconds per second
QString slowText(double pace) {
  const QString words = PlaybackBar::tr("%1× real time");
  const QLocale locale;
  if (pace < kLeastPace) return words.arg(u'<' + locale.toString(kLeastPace));
  return words.arg(locale.toString(pace, 'g', pace < 0.1 ? 1 : 2));
}

QToolButton* buttonFor(QAction* action, Qt::ToolButtonStyle style) {
  auto* button = new QToolButton;
  button->setDefaultAction(action);
  button->setToolButtonStyle(style);
  button->setIconSize(kIconSize);
  button->setAutoRaise(true);
  return button;
}

}  // namespace

PlaybackBar::PlaybackBar(const Commands& commands, QWidget* parent)
    : QWidget(parent),
      m_speedSlider(new QSlider(Qt::Horizontal)),
      m_speedLabel(new QLabel),
      m_timeLabel(new LargeLabel(kTimeType, QStringLiteral("000.000 s"))),
      m_paceLabel(new QLabel) {
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 2, 16, 2);
  layout->setSpacing(kSpacing);
  layout->addWidget(buttons(commands));
  layout->addWidget(speedBox());
  layout->addStretch(1);
  layout->addWidget(timeBox());
  showTime(0);
  showSpeed(1);
  showKeptShare(1);
  measure();
}

/// With the pace, whether it is shown now or not.
int PlaybackBar::widthWith(Qt::ToolButtonStyle style) {
  for (QToolButton* button : m_wordButtons) button->setToolButtonStyle(style);
  for (const QObject* child : children()) {
    // Now, not when the event loop comes to it.
    const auto* box = qobject_cast<const QWidget*>(child);
    if (box && box->layout()) box->layout()->activate();
  }
  layout()->activate();
  const int width = layout()->totalMinimumSize().width();
  return m_paceLabel->isHidden() ? width + m_paceLabel->minimumWidth() + kSpacing : width;
}

void PlaybackBar::measure() {
  const int paceWidth = m_paceLabel->fontMetrics().horizontalAdvance(slowText(0.24));
  for (QLabel* label : {m_paceLabel, m_speedLabel}) label->setMinimumWidth(paceWidth);
  // What is resized by this must not choose yet.
  m_isMeasuring = true;
  m_widthWithPace = widthWith(Qt::ToolButtonIconOnly);
  m_leastWidth = m_widthWithPace - paceWidth - kSpacing;
  m_widthWithWords = widthWith(Qt::ToolButtonTextBesideIcon);
  m_isMeasuring = false;
  updateGeometry();
  chooseStyle();
}

void PlaybackBar::chooseStyle() {
  if (m_isMeasuring) return;
  const bool fits = width() >= m_widthWithWords;
  const auto style = fits ? Qt::ToolButtonTextBesideIcon : Qt::ToolButtonIconOnly;
  for (QToolButton* button : m_wordButtons) button->setToolButtonStyle(style);
  m_paceLabel->setVisible(width() >= m_widthWithPace);
  showWords();
}

QSize PlaybackBar::minimumSizeHint() const {
  return {m_leastWidth, QWidget::minimumSizeHint().height()};
}

bool PlaybackBar::event(QEvent* event) {
  const bool handled = QWidget::event(event);
  if (event->type() == QEvent::Show) measure();
  return handled;
}

void PlaybackBar::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::FontChange) measure();
}

void PlaybackBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  chooseStyle();
}

QWidget* PlaybackBar::buttons(const Commands& commands) {
  auto* box = new QWidget;
  auto* layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  layout->addWidget(buttonFor(commands.action(Command::kStepBack), Qt::ToolButtonIconOnly));
  for (const Command command : {Command::kPlay, Command::kStep, Command::kCut, Command::kReset}) {
    m_wordButtons.push_back(buttonFor(commands.action(command), Qt::ToolButtonTextBesideIcon));
    layout->addWidget(m_wordButtons.back());
  }
  return box;
}

QWidget* PlaybackBar::speedBox() {
  auto* box = new QWidget;
  auto* layout = new QVBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(2);
  m_speedSlider->setRange(kSlowest, kFastest);
  m_speedSlider->setPageStep(1);
  m_speedSlider->setTickPosition(QSlider::TicksBelow);
  m_speedSlider->setFocusPolicy(Qt::TabFocus);
  m_speedSlider->setFixedWidth(kSliderWidth);
  m_speedSlider->setAccessibleName(tr("Speed"));
  m_speedSlider->setToolTip(tr("Speed (, and .)"));
  m_speedLabel->setToolTip(tr("Simulated seconds in a second of real time"));
  m_speedLabel->setAlignment(Qt::AlignHCenter);
  layout->addStretch(1);
  layout->addWidget(m_speedLabel);
  layout->addWidget(m_speedSlider);
  layout->addStretch(1);
  connect(m_speedSlider, &QSlider::valueChanged, this,
          [this](int exponent) { emit speedChosen(std::ldexp(1, exponent)); });
  return box;
}

QWidget* PlaybackBar::timeBox() {
  auto* box = new QWidget;
  auto* layout = new QHBoxLayout(box);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kSpacing);
  m_timeLabel->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_timeLabel->setAccessibleName(tr("Simulated time"));
  m_timeLabel->setToolTip(tr("Simulated time t, in s: the moment that all views show"));
  m_paceLabel->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  m_paceLabel->setObjectName("pace");
  m_paceLabel->setToolTip(tr("Whether the computer keeps up with the chosen speed"));
  layout->addWidget(m_paceLabel);
  layout->addWidget(m_timeLabel);
  return box;
}

void PlaybackBar::showTime(double time) {
  m_timeLabel->setText(tr("%1 s").arg(QLocale().toString(time, 'f', 3)));
}

void PlaybackBar::showSpeed(double speed) {
  const QSignalBlocker quiet(m_speedSlider);
  m_speedSlider->setValue(exponentOf(speed));
  m_speed = speed;
  showWords();
}

void PlaybackBar::showKeptShare(double keptShare) {
  m_keptShare = keptShare;
  showWords();
}

void PlaybackBar::showWords() {
  const auto say = [](QLabel* label, const QString& words) {
    if (words != label->text()) label->setText(words);
  };
  const bool isKept = m_keptShare >= kMostlyKept;
  const QString slow = slowText(m_keptShare * m_speed);
  const bool hasPlace = !m_paceLabel->isHidden();
  say(m_paceLabel, isKept ? tr("in real time") : slow);
  say(m_speedLabel, isKept || hasPlace ? tr("Speed %1").arg(speedText(m_speed)) : slow);
}

double PlaybackBar::speedBeside(double speed, int steps) const {
  return std::ldexp(1, std::clamp(exponentOf(speed) + steps, kSlowest, kFastest));
}

}  // namespace ui
