#include "core/methods/method.h"

#include <algorithm>
#include <string_view>

#include <QtTest>

#include "core/methods/method_list.h"

using core::Method;
using core::methods;

Q_DECLARE_METATYPE(const core::Method*)

class MethodTest : public QObject {
  Q_OBJECT

 private slots:
  void listsTheMethodsOfSceneFilesSimplestFirst();
  void findsEveryMethodById();
  void knowsNoOtherNames_data();
  void knowsNoOtherNames();
  void saysWhoseStepsAreSplitAtKinks();
  void handsOutTheUnitOfEachRow();
};

void MethodTest::listsTheMethodsOfSceneFilesSimplestFirst() {
  std::vector<std::string_view> ids;
  for (const Method& method : methods()) ids.push_back(method.id);
  QCOMPARE(ids, (std::vector<std::string_view>{"euler", "semi-implicit-euler", "rk4", "dopri5"}));
  QVERIFY(std::ranges::is_sorted(methods(), {}, &Method::slopesPerStep));
}

void MethodTest::findsEveryMethodById() {
  for (const Method& method : methods()) QCOMPARE(core::findMethod(method.id), &method);
}

void MethodTest::knowsNoOtherNames_data() {
  QTest::addColumn<QByteArray>("id");
  QTest::newRow("none") << QByteArray();
  QTest::newRow("upper case") << QByteArray("RK4");
  QTest::newRow("its name") << QByteArray("Euler (explicit)");
  QTest::newRow("longer") << QByteArray("rk45");
}

void MethodTest::knowsNoOtherNames() {
  QFETCH(QByteArray, id);
  QCOMPARE(core::findMethod(id.toStdString()), static_cast<const Method*>(nullptr));
}

void MethodTest::saysWhoseStepsAreSplitAtKinks() {
  QVERIFY(!core::findMethod("euler")->mindsKinks());
  QVERIFY(!core::findMethod("semi-implicit-euler")->mindsKinks());
  QVERIFY(core::findMethod("rk4")->mindsKinks());
}

void MethodTest::handsOutTheUnitOfEachRow() {
  for (std::size_t i = 0; i < methods().size(); ++i) {
    int calls = 0;
    core::withMethod(i, [&](auto unit) {
      ++calls;
      QCOMPARE(decltype(unit)::kRow.id, methods()[i].id);
    });
    QCOMPARE(calls, 1);
  }
}

QTEST_APPLESS_MAIN(MethodTest)
#include "method_test.moc"
