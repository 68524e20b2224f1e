// A world whatever its precision: what the facade holds.
#pragma once

#include <memory>
#include <string_view>

#include "ballpark/catalogue.h"
#include "ballpark/options.h"
#include "ballpark/report.h"
#include "ballpark/state.h"
#include "ballpark/user_effect.h"
#include "engine/core/function_ref.h"

namespace ballpark {

struct RawView {
  std::size_t first_row = 0, rows = 0;
  std::vector<const void*> components;
};

class WorldInterface {
 public:
  virtual ~WorldInterface() = default;
  virtual void step(std::uint64_t n) = 0;
  virtual void advance_to(double t, std::uint64_t most_steps) = 0;
  virtual bool approach(double t, double end, std::uint64_t most_steps) = 0;
  virtual void look_ahead(double t, FunctionRef<void()> look) = 0;
  virtual double step_size() const = 0;
  virtual double time() const = 0;
  virtual const Status& status() const = 0;
  virtual Counters counters() const = 0;
  virtual std::size_t body_count() const = 0;
  virtual std::size_t row_of(std::size_t id) const = 0;
  virtual RawView view(const std::string& column) const = 0;
  virtual double constant(const std::string& name, const std::string& group) const = 0;
  virtual BodyState body(std::size_t id) const = 0;
  virtual void set(std::size_t id, const BodyState& state) = 0;
  virtual void apply_impulse(std::size_t id, const Vector3d& J, const Vector3d& offset) = 0;
  virtual void schedule_impulse(const Impulse& impulse) = 0;
  virtual void apply_load(const std::string& kind, std::size_t id, const Vector3d& load, double at, double until) = 0;
  virtual std::vector<ContactLoad> contact_loads() const = 0;
  virtual Totals totals() const = 0;
  virtual void keep_ledger(bool on) = 0;
  virtual Ledger ledger() const = 0;
  virtual std::uint64_t state_hash() const = 0;
  virtual Explanation explain() const = 0;
  virtual Snapshot snapshot() const = 0;
  virtual void restore(const Snapshot& snapshot) = 0;
  virtual void profile(bool on) = 0;
  virtual std::vector<PassTime> pass_times() const = 0;
  virtual Precision precision() const = 0;
  virtual std::string target() const = 0;
  virtual int threads() const = 0;
};

/// The largest step at which an oscillation does not grow under a method [s]: infinity if nothing is stiff, 0 if it
/// grows at every step. `growth`: its amplification by a step of size h.
struct StepLimit {
  double largest = 0;
  double growth = 1;
};
namespace f64 {
/// For x'' = -k x - c v - g (n x v), n across x and v; measured in double, whatever the world's precision.
StepLimit step_limit(std::string_view integrator, double h, double k, double c, double g);
}  // namespace f64

// Each precision of the engine offers these.
#define BALLPARK_PRECISION_FACE(ns)                                                                  \
  namespace ns {                                                                                     \
  std::unique_ptr<WorldInterface> make_world(const Scene&, const Options&, std::vector<UserEffect>); \
  std::vector<EffectDescription> describe_effects();                                                 \
  std::vector<IntegratorDescription> describe_integrators();                                         \
  bool estimates_at_end(std::string_view integrator);                                                \
  }
BALLPARK_PRECISION_FACE(f32)
BALLPARK_PRECISION_FACE(f64)
BALLPARK_PRECISION_FACE(extended)
#undef BALLPARK_PRECISION_FACE

}  // namespace ballpark
