#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <QColor>
#include <QString>

#include "core/recording/even_series.h"
#include "core/recording/thinning.h"

namespace ui {

/// Where a curve's points come from: samples that are added at the end, and sometimes
/// thinned or dropped. A point that is not finite is a gap.
class PointSource {
 public:
  virtual ~PointSource() = default;

  virtual std::size_t size() const = 0;
  /// The first settled() points stay as they are while this does.
  virtual std::uint64_t revision() const = 0;
  virtual std::size_t settled() const = 0;
  /// Appends the points from this one on.
  virtual void appendFrom(std::size_t first, std::vector<core::TimedPoint>& points) const = 0;

 protected:
  PointSource() = default;
  PointSource(const PointSource&) = default;
  PointSource& operator=(const PointSource&) = default;
};

/// One point for each sample of a series.
template <class Sample, class Read>
class SeriesPoints final : public PointSource {
 public:
  SeriesPoints(const core::EvenSeries<Sample>& series, Read read)
      : m_series(series), m_read(std::move(read)) {}

  std::size_t size() const override { return m_series.samples().size(); }
  std::uint64_t revision() const override { return m_series.revision(); }
  std::size_t settled() const override { return m_series.settled(); }
  void appendFrom(std::size_t first, std::vector<core::TimedPoint>& points) const override {
    for (const Sample& sample : m_series.samples().subspan(first)) points.push_back(m_read(sample));
  }

 private:
  const core::EvenSeries<Sample>& m_series;
  Read m_read;
};

/// @param series  must outlive the points
/// @param read    TimedPoint(const Sample&)
template <class Sample, class Read>
std::shared_ptr<const PointSource> pointsOf(const core::EvenSeries<Sample>& series, Read read) {
  return std::make_shared<SeriesPoints<Sample, Read>>(series, std::move(read));
}

/// How a curve is drawn.
enum class CurveStyle {
  kLine,
  kBand,     ///< filled down to its base
  kHatched,  ///< hatched between it and its base, on top of bands
};

/// One curve of a chart, in SI units, degrees for angles.
struct ChartCurve {
  QString name;         ///< curves of one name share their entry in the legend
  std::size_t run = 0;  ///< decides dashes, and the direction of a hatch
  QColor color;
  std::shared_ptr<const PointSource> points;
  CurveStyle style = CurveStyle::kLine;
  double width = 2;             ///< of the line [px]
  double base = 0;              ///< height at which a band ends
  bool holdsPotential = false;  ///< moves with the height that counts as zero
  /// In energyQuantities(): shown when that is, for there may be nothing of it.
  std::optional<std::size_t> quantity;
  /// What is read off where it is not the curve's own y, as in a stack; may be null.
  std::shared_ptr<const PointSource> amounts;
};

}  // namespace ui
