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
  return {{KeysPage::tr("In the scene"),
           {{KeysPage::tr("Wheel, drag"), KeysPage::tr("Zoom, move the view")},
            {KeysPage::tr("Double click"), KeysPage::tr("Fit the room")},
            {KeysPage::tr("Click"), KeysPage::tr("Select a weight")},
            {KeysPage::tr("Drag a weight"), KeysPage::tr("Set its angle or place")},
            {KeysPage::tr("Shift+drag"), KeysPage::tr("Set its rope's length")},
            {KeysPage::tr("Drag its arrow"), KeysPage::tr("Set its velocity")},
            {KeysPage::tr("Ctrl+drag"), KeysPage::tr("Snap")},
            {KeysPage::tr("Alt+arrows"), KeysPage::tr("Move the weight")},
            {KeysPage::tr("Alt+Shift+arrows"), KeysPage::tr("Change its velocity")}}},
          {KeysPage::tr("In the table"),
           {{KeysPage::tr("Ins, Del"), KeysPage::tr("Add, remove weights")},
            {KeysPage::tr("Ctrl+C, Ctrl+V"), KeysPage::tr("Copy, paste cells")},
            {KeysPage::tr("Ctrl+D"), KeysPage::tr("Fill down")}}},
          {KeysPage::tr("In a chart"),
           {{KeysPage::tr("Wheel, + −"), KeysPage::tr("Zoom")},
            {KeysPage::tr("Drag"), KeysPage::tr("Zoom to a box")},
            {KeysPage::tr("Shift+drag, Alt+arrows"), KeysPage::tr("Move what it shows")},
            {KeysPage::tr("Double click, 0"), KeysPage::tr("Show all")}}},
          {KeysPage::tr("Everywhere"),
           {{KeysPage::tr("Return, Escape"), KeysPage::tr("Apply, restore a field")},
            {KeysPage::tr("Tab, Shift+Tab"), KeysPage::tr("Next, previous field")},
            {KeysPage::tr("Alt+letter"), KeysPage::tr("Open that menu")}}}};
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
