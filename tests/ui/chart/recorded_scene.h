#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "core/recording/recording.h"
#include "core/scene/angle.h"
#include "core/scene/arrangement.h"
#include "ui/chart/chart_content.h"

/// A scene whose runs are recorded, for charts to draw.
class RecordedScene {
 public:
  /// @param weights  each on a rope, let go at 60°
  /// @param cutTime  [s]
  RecordedScene(int weights, double cutTime, std::vector<core::Solver> solvers) {
    core::Scene scene = core::withWeightCount(core::Scene(), weights);
    scene.cutTime = cutTime;
    for (core::Weight& weight : scene.weights) weight.rope->angle = core::radians(60);
    m_scene = std::make_shared<const core::Scene>(std::move(scene));
    for (core::Solver& solver : solvers) {
      m_lanes.push_back({core::Run(m_scene, std::move(solver)), core::Recording()});
      m_lanes.back().recording.start(m_lanes.back().run);
    }
  }

  /// @param time  [s]
  void runUntil(double time) {
    for (Lane& lane : m_lanes) {
      while (lane.run.time() < time - 1e-9) {
        lane.run.advance();
        lane.recording.record(lane.run);
      }
    }
  }

  core::Run& run(int index) { return m_lanes[index].run; }
  core::Recording& recording(int index) { return m_lanes[index].recording; }
  const core::Scene& scene() const { return *m_scene; }

  /// All runs, named "run 1", "run 2", …, and these weights.
  ui::ChartSubject subject(std::vector<int> weights) const {
    ui::ChartSubject subject;
    subject.scene = m_scene.get();
    subject.weights = std::move(weights);
    for (std::size_t i = 0; i < m_lanes.size(); ++i) {
      const core::Recording& recording = m_lanes[i].recording;
      subject.runs.push_back(
          {&recording.ledger(), QString("run %1").arg(i + 1), &recording.motion()});
    }
    return subject;
  }

 private:
  struct Lane {
    core::Run run;
    core::Recording recording;
  };

  std::shared_ptr<const core::Scene> m_scene;
  std::vector<Lane> m_lanes;
};
