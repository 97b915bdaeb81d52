#include "tests/support/observed_order.h"

#include <cmath>
#include <string>

namespace tests {

double OrderMeasurement::order() const {
  const auto count = static_cast<double>(steps.size());
  double sumX = 0, sumY = 0, sumXX = 0, sumXY = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double x = std::log(steps[i]), y = std::log(errors[i]);
    sumX += x;
    sumY += y;
    sumXX += x * x;
    sumXY += x * y;
  }
  return (count * sumXY - sumX * sumY) / (count * sumXX - sumX * sumX);
}

QString OrderMeasurement::text() const {
  QString text = QStringLiteral("order %1:").arg(order());
  for (std::size_t i = 0; i < steps.size(); ++i)
    text += QStringLiteral(" %2 m at 1/%1 s;").arg(1 / steps[i]).arg(errors[i]);
  return text;
}

OrderMeasurement measuredOrder(const ReferenceCase& reference, const core::Method& method,
                               std::vector<double> steps) {
  OrderMeasurement measurement{std::move(steps), {}};
  for (const double step : measurement.steps) {
    const core::Solver solver{.method = std::string(method.id), .step = step};
    measurement.errors.push_back(positionError(reference, simulated(reference, solver)));
  }
  return measurement;
}

std::vector<double> stepLadder(double coarsest, double finest, int count) {
  std::vector<double> steps;
  for (int i = 0; i < count; ++i)
    steps.push_back(coarsest * std::pow(finest / coarsest, static_cast<double>(i) / (count - 1)));
  return steps;
}

}  // namespace tests
