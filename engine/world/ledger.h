// The energy ledger: who did work on the bodies, beside the steps and without a say in them.
#pragma once

#include <vector>

#include "ballpark/report.h"
#include "engine/core/real.h"

namespace ballpark::BALLPARK_PRECISION {

/// A sum of many small terms, with what rounding takes from it (Knuth's two-sum).
struct ExactSum {
  double value = 0, rest = 0;
  void add(double term) {
    const double sum = value + term, part = sum - value;
    rest += (value - (sum - part)) + (term - part);
    value = sum;
  }
  double total() const { return value + rest; }
};

/// Energies and powers of all bodies at one time. Lines: local effects in the order of their list, effects between
/// bodies, user effects, penalty contacts.
struct EnergyReading {
  Ledger::Kinetic kinetic;
  std::vector<double> power;      ///< of what does not come back [W]
  std::vector<double> potential;  ///< [J]

  explicit EnergyReading(std::size_t lines) : power(lines), potential(lines) {}
  void add(const EnergyReading& part);
  double energy() const;
};

struct LedgerBook {
  double from = 0;        ///< [s]
  EnergyReading initial;  ///< when it was opened
  std::vector<ExactSum> work;
  std::vector<ExactSum> between_steps;  ///< of each effect that acts there
  ExactSum contacts, outside;  ///< what changes velocities at once: impulses of contacts, and those from outside

  /// All that it holds, to keep in a snapshot.
  std::vector<double> numbers() const;
  /// False if these are of another scene.
  bool set_numbers(const std::vector<double>& numbers);
  /// Over a time, or a node's share of it.
  void add_work(const EnergyReading& at, double seconds);
  /// A change at once. Where bodies were put elsewhere, effects did no work on the way.
  void add_jump(const EnergyReading& before, const EnergyReading& after, ExactSum LedgerBook::*cause);

 private:
  /// Calls act(number) for each, in one order.
  template <class Book, class Act>
  static void for_numbers(Book& book, Act act);
};

}  // namespace ballpark::BALLPARK_PRECISION
