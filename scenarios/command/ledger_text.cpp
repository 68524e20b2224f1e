#include "scenarios/command/ledger_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

constexpr int digits = 6;

/// "gave 3 J", "took 3 J"; nothing where rounding is all there is.
std::string for_good(const LedgerLine& line, double scale) {
  if (!line.has_energy || std::abs(line.gain()) <= 1e-12 * scale) return "";
  return number(line.gain(), digits);
}

double scale_of(const Ledger& ledger) {
  double scale = std::max(ledger.initial.sum(), ledger.final.sum());
  for (const LedgerLine& line : ledger.lines) scale = std::max(scale, std::abs(line.work));
  return scale;
}

std::string kinetic_text(const Ledger::Kinetic& kinetic) {
  const std::string sum = number(kinetic.sum(), digits) + " J";
  if (kinetic.rotation == 0) return sum;
  return fmt::format("{} ({} translation, {} rotation)", sum, number(kinetic.translation, digits),
                     number(kinetic.rotation, digits));
}

}  // namespace

void add_ledger(Page& text, const Ledger& ledger) {
  constexpr Column::Align right = Column::Align::right;
  const double scale = scale_of(ledger), error = ledger.integrator_error();
  text.heading("Energy ledger");
  text.fields({{"kinetic, at first", kinetic_text(ledger.initial)}, {"kinetic, at last", kinetic_text(ledger.final)}});
  text.blank();
  Table table{{{"cause"}, {"work [J]", right}, {"potential energy [J]", right}, {"for good [J]", right}}, {}};
  for (const LedgerLine& line : ledger.lines) {
    const std::string potential = number(line.initial, digits) + " to " + number(line.final, digits);
    table.rows.push_back(
        {line.name, number(line.work, digits), line.has_energy ? potential : "none", for_good(line, scale)});
  }
  table.rows.push_back({"integrator error", number(error, digits), "", ""});
  text.table(table);
  text.paragraph(fmt::format(
      "Work changes the kinetic energy; with a potential, what it does comes back but for the last column. The "
      "integrator lost or made the rest: {} of the largest of these energies.",
      number(scale > 0 ? std::abs(error) / scale : 0, 2)));
}

}  // namespace ballpark::command
