#pragma once

#include <vector>

#include <Eigen/Core>

#include "ui/view/shown_scene.h"

namespace ui {

/// How far back trails of this scene reach, so that they show about as much of the way in a
/// thimble as in a valley: some times what a fall from ceiling to floor takes [s].
double trailSpan(const core::Scene& scene);

/// The ways that the weights of all runs came in the last moments.
///
/// Bounded: all trails together keep at most kMostPoints points, so many weights have short
/// trails, and very many none.
class Trails {
 public:
  static constexpr int kMostPoints = 8000;
  static constexpr int kMostPointsEach = 120;
  /// Trails shorter than this say nothing, so there are none then.
  static constexpr int kFewestPointsEach = 4;

  /// Starts anew for so many runs and weights.
  /// @param span  simulated time that the trail of a single weight reaches back [s], > 0
  void reset(int runCount, int weightCount, double span);

  /// Forgets all points.
  void clear();

  /// Adds where the weights are now. After a time before the last ones the trails end there;
  /// after a jump ahead they start anew. Points that would lie closer in time than the trails
  /// can keep replace the last one.
  /// @pre runs and weights are as many as reset() was told
  void record(double time, const std::vector<ShownRun>& runs);

  /// The way of one weight, oldest point first [m]; empty with fewer than two points.
  std::vector<Eigen::Vector2d> points(int run, int weight) const;

  /// Most points one trail can keep; 0 where there are too many weights.
  int pointsEach() const { return m_capacity; }
  /// Whether they reach back less far than those of a single weight, or there are none.
  bool isShortened() const { return m_capacity < kMostPointsEach; }

 private:
  int slotOf(int age) const { return (m_newest - age + m_capacity) % m_capacity; }
  void forgetAfter(double time);
  bool newestIsProvisional(double time) const;

  int m_runCount = 0;
  int m_weightCount = 0;
  int m_capacity = 0;
  double m_span = 1;     // [s]
  double m_spacing = 1;  // least time between points that stay [s]

  // A ring of moments; in m_positions one moment's weights of all runs lie side by side.
  int m_count = 0;
  int m_newest = 0;
  std::vector<double> m_times;
  std::vector<Eigen::Vector2d> m_positions;
};

}  // namespace ui
