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
  // build_effects.cpp
  void add_effects(Group& group);
  void add_effective_mass(Group& group);
  void add_stiffness(Group& group, const std::vector<Effect>& effects);
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
  // between_steps.cpp
  void add_step_effects();
  void open_group(std::size_t g);
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
  // start_limits.cpp
  void check_orbits();
  void check_resolution();

  /// A constant of the group: a value if it is equal for all bodies, else a column.
  template <int n, class F>
  void constant(Group& group, const char* name, const char* unit, PerBody (&out)[n], const char* why, F values_of_body);

  World& world_;
  const Scene& scene_;
  const Options& options_;
  std::vector<Problem> problems_;
  std::vector<std::pair<const Group*, Stiffness>> local_stiffness_;  ///< per mass [1/s^2, 1/s], of each group
  std::vector<std::pair<const Group*, double>> spin_damping_;        ///< of a group's spin, over its least moment [1/s]
};

template <int n, class F>
void Builder::constant(Group& group, const char* name, const char* unit, PerBody (&out)[n], const char* why,
                       F values_of_body) {
  if (group.copies.per_copy == 0) return;
  const std::array<Wide, n> first = values_of_body(std::size_t{0});
  bool equal = true;
  for (std::size_t i = 1; i < group.live && equal; ++i) equal = values_of_body(i) == first;
  if (equal) {
    for (int c = 0; c < n; ++c) out[c].value = static_cast<Real>(first[static_cast<std::size_t>(c)]);
    return;
  }
  const std::size_t rows = padded(group.live);
  Column& column = world_.columns_.add({name, unit, n, Role::constant, why}, group.first_row, rows);
  for (std::size_t row = 0; row < rows; ++row) {
    const std::array<Wide, n> values = values_of_body(std::min(row, group.live - 1));
    for (int c = 0; c < n; ++c)
      *column.at(c, group.first_row + row) = static_cast<Real>(values[static_cast<std::size_t>(c)]);
  }
  for (int c = 0; c < n; ++c) out[c].rows = column.at(c, group.first_row);
}

}  // namespace ballpark::BALLPARK_PRECISION
