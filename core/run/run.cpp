#include "core/run/run.h"

#include "core/run/engine.h"
#include "core/run/run_state.h"

namespace core {

RunState::RunState() : m_content(std::make_unique<EngineState>()) {}
RunState::~RunState() = default;
RunState::RunState(const RunState& other)
    : m_content(std::make_unique<EngineState>(*other.m_content)) {}
RunState& RunState::operator=(const RunState& other) {
  *m_content = *other.m_content;
  return *this;
}
RunState::RunState(RunState&&) noexcept = default;
RunState& RunState::operator=(RunState&&) noexcept = default;

std::int64_t RunState::stepCount() const {
  return m_content->stepCount;
}

std::size_t RunState::bytes() const {
  return sizeof(EngineState) + m_content->weights.capacity() * sizeof(WeightRecord) +
         m_content->contacts.capacity() * sizeof(CarriedContact) +
         m_content->paces.capacity() * sizeof(Pace) + m_content->pending.capacity() * sizeof(Event);
}

Run::Run(std::shared_ptr<const Scene> scene, Solver solver)
    : m_engine(std::make_unique<Engine>(std::move(scene), std::move(solver))) {}
Run::~Run() = default;
Run::Run(Run&&) noexcept = default;
Run& Run::operator=(Run&&) noexcept = default;

const Scene& Run::scene() const {
  return m_engine->scene();
}
const Solver& Run::solver() const {
  return m_engine->solver();
}
const Method& Run::method() const {
  return m_engine->method();
}
int Run::weightCount() const {
  return static_cast<int>(scene().weights.size());
}
std::int64_t Run::stepCount() const {
  return m_engine->stepCount();
}
double Run::time() const {
  return m_engine->time();
}
RunStatus Run::status() const {
  return m_engine->status();
}
RunStatus Run::advance() {
  return m_engine->advance();
}
bool Run::tryAdvance(const StepProgress& progress) {
  return m_engine->tryAdvance(progress);
}
bool Run::knowsLatestStep() const {
  return m_engine->knowsLatestStep();
}
void Run::cutAll() {
  m_engine->cutNow(-1);
}
void Run::cut(int weight) {
  m_engine->cutNow(weight);
}
bool Run::allCut() const {
  return m_engine->allCut();
}
WeightState Run::weight(int index) const {
  return m_engine->weight(index);
}
WeightState Run::weightAt(int index, double time) const {
  return m_engine->weightAt(index, time);
}
Energies Run::energies() const {
  return m_engine->energies();
}
Energies Run::energiesAt(double time) const {
  return m_engine->energiesAt(time);
}
double Run::startEnergy() const {
  return m_engine->startEnergy();
}
std::span<const Event> Run::pendingEvents() const {
  return m_engine->pendingEvents();
}
std::span<const Event> Run::stepEvents() const {
  return m_engine->stepEvents();
}
std::vector<StepPart> Run::latestStep(int index) const {
  return m_engine->latestStep(index);
}
std::vector<StepPart> Run::nextStep(int index, const StepProgress& progress) const {
  Engine ahead(m_engine->sharedScene(), solver());
  ahead.restore(m_engine->state());
  ahead.tryAdvance(progress);
  return ahead.latestStep(index);
}
StepPart Run::retaken(int index, const StepPart& part, const Method& method) const {
  return m_engine->retaken(index, part, method);
}
ExactWay Run::exactWay(int index, const StepPart& part, double tolerance) const {
  return m_engine->exactWay(index, part, tolerance);
}
std::int64_t Run::slopeEvaluations() const {
  return m_engine->evaluations();
}

RunState Run::state() const {
  RunState state;
  *state.m_content = m_engine->state();
  return state;
}

void Run::restore(const RunState& state) {
  m_engine->restore(*state.m_content);
}

}  // namespace core
