// From a scene to a world: the only place that decides what exists.
#pragma once

#include "engine/world/check.h"
#include "engine/world/start.h"
#include "engine/world/world.h"

namespace ballpark::BALLPARK_PRECISION {

/// Does contact friction turn bodies of this group?
bool has_friction(const Scene& scene, const BodyGroup& group);
/// The first effect between bodies, or nullptr.
const Effect* pair_effect_of(const Scene& scene);
/// Does an effect between bodies act on this group?
bool has_pair_effect(const Scene& scene, const BodyGroup& group);
/// All numbers of an effect's parameters, by name: the order in which effects of one kind are summed.
std::vector<double> numbers_of(const Effect& effect);

/// Is its state within a step a rotation vector? Its rate at the end of one is not that at the start of the next.
bool turns_by_vector(const Group& group);

class Builder {
 public:
  Builder(World& world, const Scene& scene, const Options& options);
  void build();

 private:
  void check_options();
  void choose_motion(std::size_t g);
  MotionKind stepped(MotionKind carried) const;
  void place_groups();
  void add_state_columns();
  void fill_constants(Group& group);
  void fill_state(Group& group);
  void fill_row(Group& group, std::size_t row, const Start& start);
  void repeat_last_row(Group& group);
  void add_effects(Group& group);
  double lightest(const Group& group) const;
  void check_stability();
  void check_stability(const std::string& whose, const Stiffness& per_mass);
  void add_carry(Group& group);
  void choose_method();
  void add_rates(Group& group);
  void add_before(Group& group);
  void add_scratch(Group& group);
  void add_blocks();
  void add_implicit();
  void check_iteration() const;
  void add_parts();
  void add_events();
  // build_pairs.cpp
  void weave();
  void add_pair_systems();
  void add_pair_system(const Effect& effect);
  // build_contacts.cpp
  void add_contacts();
  void choose_impulse();
  void choose_penalty();
  void start_penalty();
  void describe_contacts(const std::vector<std::string>& materials);
  void add_walls(const std::vector<std::string>& materials);
  void add_slots(const std::vector<std::string>& materials);
  void choose_path();

  /// A constant of the group: a value if it is equal for all bodies, else a column.
  template <int n, class F>
  void constant(Group& group, const char* name, const char* unit, PerBody (&out)[n], const char* why, F values_of_body);

  World& world_;
  const Scene& scene_;
  const Options& options_;
  std::vector<Problem> problems_;
  std::vector<std::pair<const Group*, Stiffness>> local_stiffness_;  ///< per mass [1/s^2, 1/s], of each group
};

}  // namespace ballpark::BALLPARK_PRECISION
