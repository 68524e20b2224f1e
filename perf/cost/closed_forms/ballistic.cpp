// Free flight: uniform gravity and linear drag, by elementary functions.
#include "perf/cost/closed_forms/free_path.h"

namespace ballpark::cost {

namespace {

template <class R>
class Flight {
 public:
  explicit Flight(const LoneBody& body) : path_(body), spin_(body) {}
  bool fits() const { return true; }
  ExactState<R> at(R t) const {
    return state_of<R>(path_.position(t), path_.velocity(t), spin_.orientation(t), spin_.spin());
  }

 private:
  FreePath<R> path_;
  UniformSpin<R> spin_;
};

}  // namespace

std::optional<ExactMotion> ballistic(const LoneBody& body) {
  if (!moves_freely(body) || !spins_uniformly(body)) return std::nullopt;
  return motion_of<Flight>("free flight, with linear drag if any (variation of constants)", body);
}

}  // namespace ballpark::cost
