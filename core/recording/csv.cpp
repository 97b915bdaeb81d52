#include "core/recording/csv.h"

#include "core/recording/csv_row.h"
#include "core/scene/angle.h"

namespace core {

namespace {

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
  CsvRow row(csv);
  row << time << weight << nameOf(state.phase) << state.position.x() << state.position.y()
      << state.velocity.x() << state.velocity.y();
  if (state.phase == Phase::kTethered) {
    row << degrees(state.angle) << degrees(state.angularVelocity);
  } else {
    row << kEmpty << kEmpty;
  }
}

void appendEnergyRow(std::string& csv, double time, const Energies& energies) {
  CsvRow(csv) << time << energies.kinetic << energies.potential << energies.lostToAir
              << energies.lostToImpacts << energies.lostToRopes << energies.lostToFriction
              << energies.numericalDrift;
}

void appendEventRow(std::string& csv, const Event& event) {
  CsvRow row(csv);
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
