#include <atomic>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>

#include <QtTest>

#include "core/run/run.h"
#include "core/scene/scene_limits.h"

using core::Run;
using core::Scene;

namespace {

// What the program asks for; the test's own needs are few and come before and after.
std::atomic<std::int64_t> allocations = 0;
std::atomic<std::int64_t> bytesHeld = 0;

// Each block begins with its size.
constexpr std::size_t kHeader = 64;

/// Null where there is no memory left.
void* take(std::size_t size) noexcept {
  ++allocations;
  bytesHeld += static_cast<std::int64_t>(size);
  auto* block = static_cast<char*>(std::aligned_alloc(kHeader, (size / kHeader + 2) * kHeader));
  if (block == nullptr) return nullptr;
  *reinterpret_cast<std::size_t*>(block) = size;
  return block + kHeader;
}

void* takeOrThrow(std::size_t size) {
  if (void* place = take(size)) return place;
  throw std::bad_alloc();
}

void giveBack(void* place) {
  if (place == nullptr) return;
  char* block = static_cast<char*>(place) - kHeader;
  bytesHeld -= static_cast<std::int64_t>(*reinterpret_cast<std::size_t*>(block));
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) {
  return takeOrThrow(size);
}
void* operator new(std::size_t size, std::align_val_t) {
  return takeOrThrow(size);
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  return take(size);
}
void operator delete(void* place) noexcept {
  giveBack(place);
}
void operator delete(void* place, std::size_t) noexcept {
  giveBack(place);
}
void operator delete(void* place, std::align_val_t) noexcept {
  giveBack(place);
}
void operator delete(void* place, std::size_t, std::align_val_t) noexcept {
  giveBack(place);
}

namespace {

/// Half of the weights swing, half fly and bounce off the floor and each other.
std::shared_ptr<const Scene> mixedScene(int count) {
  auto scene = std::make_shared<Scene>();
  const int columns = static_cast<int>(std::ceil(std::sqrt(count)));
  scene->room = {.width = 0.3 * columns, .height = 0.3 * columns + 1, .restitution = 1};
  for (int i = 0; i < count; ++i) {
    core::Weight weight;
    const int row = i / columns;
    const Eigen::Vector2d place(0.3 * (i % columns) + 0.15, 0.3 * row + 0.3);
    if (i % 2 == 0) {
      weight.rope = core::Rope{.pivot = place, .length = 0.1, .angle = 1};
    } else {
      weight.position = place;
      weight.velocity = {1, 0.1 * (i % 7)};
    }
    scene->weights.push_back(weight);
  }
  return scene;
}

}  // namespace

class MemoryTest : public QObject {
  Q_OBJECT

 private slots:
  void takesStepsWithoutAskingForMemory();
  void needsLessThanAKibibyteForAWeight();
};

void MemoryTest::takesStepsWithoutAskingForMemory() {
  const auto scene = mixedScene(100);
  QVERIFY(core::problemsIn(*scene).empty());
  Run run(scene, {.method = "rk4", .step = 1.0 / 60});
  std::int64_t events = 0;
  for (int i = 0; i < 300; ++i) run.advance();
  const std::int64_t before = allocations;
  for (int i = 0; i < 300; ++i) {
    run.advance();
    events += static_cast<std::int64_t>(run.stepEvents().size());
  }
  QVERIFY(events > 1000);
  // Lists grow when a step holds more than any step before it: a few times, not each step.
  QVERIFY2(allocations - before <= 30, qPrintable(QString::number(allocations - before)));
}

void MemoryTest::needsLessThanAKibibyteForAWeight() {
  constexpr int kWeights = 10'000;
  const auto scene = mixedScene(kWeights);
  const std::int64_t before = bytesHeld;
  Run run(scene, {.method = "rk4", .step = 1.0 / 60});
  for (int i = 0; i < 10; ++i) run.advance();
  const std::int64_t perWeight = (bytesHeld - before) / kWeights;
  QVERIFY2(perWeight < 1024, qPrintable(QString::number(perWeight)));
  QVERIFY(perWeight > 100);
}

QTEST_APPLESS_MAIN(MemoryTest)
#include "memory_test.moc"
