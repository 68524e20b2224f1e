// What a scene must satisfy, and its values once they do. Compiled once: precision is a value here.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "ballpark/catalogue.h"
#include "ballpark/scene.h"

namespace ballpark {

/// Collects problems; the words of every message come from here.
class Problems {
 public:
  explicit Problems(Precision precision) : precision_(precision) {}
  void add(const std::string& path, const std::string& message) { all_.push_back({path, message}); }
  /// Finite here: in double, and after rounding to the scene's precision.
  bool finite(const std::string& path, double value, const char* unit);
  bool finite(const std::string& path, const Vector3d& value, const char* unit);
  bool positive(const std::string& path, double value, const char* unit);
  bool not_negative(const std::string& path, double value, const char* unit);
  /// Is it a number > 0 that the scene's precision holds?
  bool holds(double value) const { return std::isfinite(rounded(value)) && rounded(value) > 0; }
  bool known(const std::string& path, const char* what, const std::string& word, const std::vector<std::string>& words);
  const std::vector<Problem>& all() const { return all_; }

 private:
  /// The value as the scene's precision holds it.
  double rounded(double value) const;

  Precision precision_;
  std::vector<Problem> all_;
};

std::string text(double value);
/// "bodies[2].mass", or with a row "bodies[2].mass[5]".
std::string path_of(const char* table, std::size_t index, const char* key = "");
std::string path_of(const std::string& path, std::size_t row, std::size_t rows);

/// Bodies of one copy of the group: the longest list, or what `generate` makes.
std::size_t body_count(const BodyGroup& group);
bool rotates(const BodyGroup& group);
bool acts_on(const Effect& effect, const BodyGroup& group);
const Effect* pivot_of(const Scene& scene, const BodyGroup& group);
/// Mass of a body [kg], from mass or density; principal moments [kg m^2], zero for a particle.
double mass_of(const BodyGroup& group, std::size_t body);
Vector3d inertia_of(const BodyGroup& group, std::size_t body);
/// The effect's parameters with defaults filled in, `vectors` and `numbers` always as rows.
std::map<std::string, Value> complete_parameters(const Effect& effect, const EffectDescription& description);
const EffectDescription* find_effect(const std::string& kind);

void check_integrator(const Scene& scene, Problems& problems);
/// Does the method lose its order where a force reads velocity, and how that is said.
bool blind(const IntegratorDescription& row);
std::string needs_blind_forces(const IntegratorDescription& row, const std::string& reader);
/// Why an implicit method of so many stages cannot use derivatives of the scene's own forces: "" if it can.
std::string without_derivatives(const Scene& scene, int stages);
void check_bodies(const Scene& scene, Problems& problems);
void check_effects(const Scene& scene, Problems& problems);
void check_presence(const Scene& scene, Problems& problems);
void check_contacts(const Scene& scene, Problems& problems);
/// Do bodies with a shape touch in this scene?
bool touches(const Scene& scene);
/// Of all bodies with a shape and all boundaries, each once; "" is the default material.
std::vector<std::string> materials_in_use(const Scene& scene);
/// Restitution and friction of two materials.
Material law_between(const Scene& scene, const std::string& a, const std::string& b);

/// Row `i` of a list of none, one or n rows.
template <class T>
T row_or(const std::vector<T>& rows, std::size_t i, const T& fallback) {
  return rows.empty() ? fallback : rows[rows.size() == 1 ? 0 : i];
}

}  // namespace ballpark
