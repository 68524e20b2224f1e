// What `ballpark cost` says of ensembles beyond the horizon.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/cost/ensemble.h"
#include "perf/cost/subject.h"
#include "scenarios/command/cost_text.h"
#include "scenarios/command/text.h"

namespace ballpark::command {
namespace {

using cost::Ensemble;
using cost::EnsembleRuns;

constexpr Column::Align right = Column::Align::right, wrap = Column::Align::wrap;
constexpr double seen = 2;  ///< standard errors from which on an effect of the method is seen

std::string sigma_text(double sigmas) {
  return sigmas < 1000 ? fmt::format("{:.1f}", sigmas) : fmt::format("{:.0e}", sigmas);
}

}  // namespace

std::string mean_text(const cost::Mean& mean, const cost::Observable& observable) {
  const std::string unit = (observable.unit.empty() ? "" : " ") + observable.unit;
  const double margin = mean.margin(), largest = std::max(std::abs(mean.value), margin);
  if (!(margin > 1e-12 * largest)) return number(mean.value, 12) + unit;
  const int first = static_cast<int>(std::floor(std::log10(largest)));
  const int last = static_cast<int>(std::floor(std::log10(margin))) - 1;
  if (first > 6 || first < -4) {
    return fmt::format("{:.{}e} +- {:.1e}{}", mean.value, std::max(first - last, 1), margin, unit);
  }
  const int digits = std::max(-last, 0);
  return fmt::format("{:.{}f} +- {:.{}f}{}", mean.value, digits, margin, digits, unit);
}

namespace {

void add_reference(Page& page, const Ensemble& ensemble) {
  page.fields({{"reference", fmt::format("{} ({})", text(ensemble.reference.setting), ensemble.why_reference)}});
  page.blank();
  Table table{{{"observable"}, {"mean of the reference, and its 95 % interval"}}, {}};
  for (std::size_t o = 0; o < ensemble.observables.size(); ++o) {
    const cost::Observable& observable = ensemble.observables[o];
    table.rows.push_back({observable.name, mean_text(ensemble.reference.means[o], observable)});
  }
  page.table(table);
}

/// How a method changes the energy is told by itself: a kept one shows the least drift.
bool is_energy_change(const Ensemble& ensemble, std::size_t o) {
  return ensemble.observables[o].name == cost::energy_change;
}

/// By setting the energy change, and of the others the one that is seen best.
void add_settings(Page& page, const Ensemble& ensemble) {
  Table table{{{"setting", wrap}, {"a run", right}, {"energy change", right}, {"else farthest off"}, {"sigma", right}},
              {}};
  for (const EnsembleRuns& runs : ensemble.settings) {
    std::string change = "none";
    std::size_t worst = runs.means.size();
    for (std::size_t o = 0; o < runs.means.size(); ++o) {
      const double sigmas = runs.from_reference[o].sigmas();
      if (is_energy_change(ensemble, o)) {
        change = fmt::format("{:.1e} ({})", runs.means[o].value, sigma_text(sigmas));
      } else if (worst == runs.means.size() || sigmas > runs.from_reference[worst].sigmas()) {
        worst = o;
      }
    }
    if (worst == runs.means.size()) continue;
    const double sigmas = runs.from_reference[worst].sigmas();
    table.rows.push_back({text(runs.setting), seconds(runs.seconds), change, Cell(ensemble.observables[worst].name),
                          Cell(sigma_text(sigmas), sigmas > seen ? Style::bad : Style::good)});
  }
  page.table(table);
}

std::vector<std::string> effects_seen(const Ensemble& ensemble) {
  std::vector<std::string> list;
  for (const EnsembleRuns& runs : ensemble.settings) {
    std::string effects;
    for (std::size_t o = 0; o < runs.means.size(); ++o) {
      const double sigmas = runs.from_reference[o].sigmas();
      if (!(sigmas > seen) || is_energy_change(ensemble, o)) continue;
      const cost::Observable& observable = ensemble.observables[o];
      effects += fmt::format("{} {} {} ({} sigma)", effects.empty() ? ":" : ";", observable.name,
                             mean_text(runs.means[o], observable), sigma_text(sigmas));
    }
    if (!effects.empty()) list.push_back(text(runs.setting) + effects);
  }
  return list;
}

/// How many of so many comparisons are seen, and would be by chance.
std::string count_text(const Ensemble& ensemble) {
  std::size_t all = 0, many = 0;
  for (const EnsembleRuns& runs : ensemble.settings) {
    for (std::size_t o = 0; o < runs.means.size(); ++o) {
      if (is_energy_change(ensemble, o)) continue;
      ++all;
      if (runs.from_reference[o].sigmas() > seen) ++many;
    }
  }
  const double by_chance = static_cast<double>(all) * cost::student_tails(seen, 2.0 * (ensemble.copies - 1));
  return fmt::format(
      "Of {} differences (energy change apart) {} {} above {:g} sigma, where a method's effect is seen; "
      "chance alone makes about {:.1g}.",
      all, many, many == 1 ? "is" : "are", seen, by_chance);
}

}  // namespace

void add_ensemble(Page& page, const Ensemble& ensemble) {
  page.heading(
      fmt::format("Beyond the horizon: ensembles of {} runs, at t = {} s", ensemble.copies, number(ensemble.time)));
  page.paragraph(fmt::format(
      "Starts differ by a relative {:g}, and by what the scene's seed draws. Means of two settings count as "
      "independent; where runs remember their starts (not parted yet, or by what is conserved), that overstates the "
      "error of their difference. Intervals are by Student's t; sigma is the standard error of a difference (after the "
      "energy change "
      "in parentheses).",
      ensemble.perturb));
  add_reference(page, ensemble);
  if (ensemble.settings.empty()) return;
  page.blank();
  add_settings(page, ensemble);
  page.paragraph(count_text(ensemble));
  page.list(effects_seen(ensemble));
}

}  // namespace ballpark::command
