#include "ui/panels/keys_page.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include <QAction>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>

#include "ui/control/commands.h"

namespace ui {
namespace {

constexpr int kColumnGap = 28;  // px
constexpr int kKeysGap = 12;    // from keys to what they mean [px]
constexpr int kRowGap = 1;      // px

/// One line of the page; a heading has no meaning.
struct Line {
  QString keys;
  QString meaning;
};

struct Group {
  QString name;
  std::vector<Line> lines;
};

QString plain(QString text) {
  return text.remove('&').remove(QStringLiteral("…"));
}

/// The menu an action stands in; context menus have no name.
QString menuOf(const QAction* action) {
  for (const QObject* object : action->associatedObjects()) {
    const auto* menu = qobject_cast<const QMenu*>(object);
    if (menu && !menu->title().isEmpty()) return plain(menu->title());
  }
  return {};
}

/// Commands that are each other's opposite share a line, that of the first.
constexpr std::pair<Command, Command> kOpposites[] = {
    {Command::kNextEvent, Command::kPreviousEvent},
    {Command::kNextImpact, Command::kPreviousImpact},
    {Command::kNextTurningPoint, Command::kPreviousTurningPoint},
    {Command::kNextCut, Command::kPreviousCut},
    {Command::kNextWeight, Command::kPreviousWeight},
    {Command::kNextChart, Command::kPreviousChart},
};

QString keysOf(const QAction* action) {
  return action->shortcut().toString(QKeySequence::NativeText);
}

/// Alt with each of the arrow keys: the scene has one line for all of them.
bool isWithAlt(const QAction* action) {
  return action->shortcut()[0].keyboardModifiers().testFlag(Qt::AltModifier);
}

/// Nothing where the command has no line of its own.
std::optional<Line> lineOf(const QAction* action, const Commands& commands) {
  if (action->shortcut().isEmpty() || isWithAlt(action)) return std::nullopt;
  const QString meaning = plain(action->text());
  for (const auto& [next, previous] : kOpposites) {
    if (action == commands.action(previous)) return std::nullopt;
    if (action == commands.action(next))
      return Line{keysOf(action) + QStringLiteral(", ") + keysOf(commands.action(previous)),
                  KeysPage::tr("%1, previous").arg(meaning)};
  }
  return Line{keysOf(action), meaning};
}

std::vector<Group> commandGroups(const Commands& commands) {
  std::vector<Group> groups;
  for (const QAction* action : commands.all()) {
    const std::optional<Line> line = lineOf(action, commands);
    if (!line) continue;
    const QString name = menuOf(action);
    auto group = std::ranges::find(groups, name, &Group::name);
    if (group == groups.end()) group = groups.insert(groups.end(), Group{name, {}});
    group->lines.push_back(*line);
  }
  return groups;
}

std::vector<Group> otherGroups() {
  const auto tr = [](const char* words) { return KeysPage::tr(words); };
  return {{tr("In the scene"),
           {{tr("Wheel, drag"), tr("Zoom, move the view")},
            {tr("Double click"), tr("Fit the room")},
            {tr("Click"), tr("Select a weight")},
            {tr("Drag a weight"), tr("Set its angle or place")},
            {tr("Shift+drag"), tr("Set its rope's length")},
            {tr("Drag its arrow"), tr("Set its velocity")},
            {tr("Ctrl+drag"), tr("Snap")},
            {tr("Alt+arrows"), tr("Move the weight")},
            {tr("Alt+Shift+arrows"), tr("Change its velocity")}}},
          {tr("In the table"),
           {{tr("Ins, Del"), tr("Add, remove weights")},
            {tr("Ctrl+C, Ctrl+V"), tr("Copy, paste cells")},
            {tr("Ctrl+D"), tr("Fill down")}}},
          {tr("In a chart"),
           {{tr("Wheel, + −"), tr("Zoom")},
            {tr("Drag"), tr("Zoom to a box")},
            {tr("Shift+drag, Alt+arrows"), tr("Move what it shows")},
            {tr("Double click, 0"), tr("Show all")}}},
          {tr("Everywhere"),
           {{tr("Return, Escape"), tr("Apply, restore a field")},
            {tr("Tab, Shift+Tab"), tr("Next, previous field")},
            {tr("Alt+letter"), tr("Open that menu")}}}};
}

/// Lines from the top of a column on.
class Column {
 public:
  Column() : m_grid(new QGridLayout) {
    m_grid->setHorizontalSpacing(kKeysGap);
    m_grid->setVerticalSpacing(kRowGap);
  }

  QGridLayout* grid() const { return m_grid; }
  int rows() const { return m_row; }

  void addHeading(const QString& words) {
    auto* label = new QLabel(words);
    QFont bold = label->font();
    bold.setBold(true);
    label->setFont(bold);
    m_grid->addWidget(label, m_row++, 0, 1, 2);
  }

  void addLine(const Line& line) {
    auto* keys = new QLabel(line.keys);
    keys->setForegroundRole(QPalette::Link);
    m_grid->addWidget(keys, m_row, 0);
    m_grid->addWidget(new QLabel(line.meaning), m_row++, 1);
  }

  void end() { m_grid->setRowStretch(m_row, 1); }

 private:
  QGridLayout* m_grid;
  int m_row = 0;
};

}  // namespace

KeysPage::KeysPage(const Commands& commands, int height, QWidget* parent) : QWidget(parent) {
  std::vector<Group> groups = commandGroups(commands);
  for (Group& group : otherGroups()) groups.push_back(std::move(group));
  int lines = 0;
  for (const Group& group : groups) lines += static_cast<int>(group.lines.size()) + 1;
  const int most = std::max(4, height / (fontMetrics().height() + kRowGap));
  // Evenly, and with room for a group's end that would rather not be torn off.
  const int columns = std::max(1, (lines + most - 1) / most);
  const int rows = std::min(most, (lines + columns - 1) / columns + 1);

  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(kColumnGap);
  Column column;
  const auto begin = [&] {
    column.end();
    layout->addLayout(column.grid());
    column = Column();
  };
  for (const Group& group : groups) {
    if (column.rows() + 2 > rows) begin();  // no heading without a line below it
    column.addHeading(group.name);
    for (const Line& line : group.lines) {
      if (column.rows() >= rows) begin();
      column.addLine(line);
    }
  }
  begin();
  delete column.grid();
}

}  // namespace ui
