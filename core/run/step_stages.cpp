#include "core/run/step_stages.h"

#include "core/run/stepper.h"

namespace core {
namespace {

void placeStages(const Body& body, const Method& method, StepPart& part) {
  for (std::size_t i = 0; i < part.stages.size(); ++i) {
    Stage& stage = part.stages[i];
    stage.node = method.nodes[i];
    if (!method.shares.empty()) stage.share = method.shares[i];
    stage.position = positionOf(body, part.mode, stage.state);
    stage.velocity = velocityOf(body, part.mode, stage.state);
  }
}

}  // namespace

StepPart opened(const Body& body, const Piece& piece, Stepper stepper, double stepStart) {
  StepPart part;
  part.begin = stepStart + piece.begin;
  part.end = stepStart + piece.end;
  part.mode = piece.mode;
  part.beginState = piece.beginState;
  part.endState = piece.endState;
  part.beginPosition = positionOf(body, piece.mode, piece.beginState);
  part.endPosition = positionOf(body, piece.mode, piece.endState);
  part.stages = stepper.stages(body, piece);
  placeStages(body, stepper.method(), part);
  return part;
}

}  // namespace core
