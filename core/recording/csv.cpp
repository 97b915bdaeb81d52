#include "core/recording/csv.h"

#include <array>
#include <charconv>

#include "core/scene/angle.h"

namespace core {

namespace {

constexpr std::string_view kLineEnd = "\r\n";

/// Puts the fields of one row behind each other. None of them needs quotes.
class Row {
 public:
  explicit Row(std::string& csv) : m_csv(csv) {}
  Row(const Row&) = delete;
  Row& operator=(const Row&) = delete;
  ~Row() { m_csv += kLineEnd; }

  Row& operator<<(std::string_view field) {
    if (m_hasFields) m_csv += ',';
    m_hasFields = true;
    m_csv += field;
    return *this;
  }

  Row& operator<<(double number) { return addNumber(number); }
  Row& operator<<(int number) { return addNumber(number); }

 private:
  template <class Number>
  Row& addNumber(Number number) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number).ptr;
    return *this << std::string_view(text.data(), end);
  }

  std::string& m_csv;
  bool m_hasFields = false;
};

constexpr std::string_view kEmpty;

}  // namespace

std::string_view trajectoryHeader() {
  return "time,weight,phase,x,y,vx,vy,angle,angular_velocity\r\n";
}

std::string_view energyHeader() {
  return "time,kinetic,potential,lost_to_air,lost_to_impacts,lost_to_ropes,lost_to_friction,"
         "numerical_drift\r\n";
}

std::string_view eventHeader() {
  return "time,event,weight,other,x,y,energy_lost\r\n";
}

void appendTrajectoryRow(std::string& csv, double time, int weight, const WeightState& state) {
  Row row(csv);
  row << time << weight << nameOf(state.phase) << state.position.x() << state.position.y()
      << state.velocity.x() << state.velocity.y();
  if (state.phase == Phase::kTethered) {
    row << degrees(state.angle) << degrees(state.angularVelocity);
  } else {
    row << kEmpty << kEmpty;
  }
}

void appendEnergyRow(std::string& csv, double time, const Energies& energies) {
  Row(csv) << time << energies.kinetic << energies.potential << energies.lostToAir
           << energies.lostToImpacts << energies.lostToRopes << energies.lostToFriction
           << energies.numericalDrift;
}

void appendEventRow(std::string& csv, const Event& event) {
  Row row(csv);
  row << event.time << nameOf(event.kind);
  if (event.weight < 0) {
    // All ropes cut at once: no one weight, and no one place.
    row << kEmpty << kEmpty << kEmpty << kEmpty;
  } else {
    row << event.weight;
    if (event.other < 0) {
      row << kEmpty;
    } else {
      row << event.other;
    }
    row << event.position.x() << event.position.y();
  }
  row << event.energyLost;
}

}  // namespace core
