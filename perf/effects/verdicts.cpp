// What is said of an effect that was dropped: drop it or keep it, in one sentence.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "perf/effects/ablation.h"

namespace ballpark::cost {

namespace {

/// "3.1 m", "2e-09 m"
std::string size_text(double size, const std::string& unit) {
  return fmt::format("{:.2g}{}{}", size, unit.empty() ? "" : " ", unit);
}

std::string percent_text(double share) {
  const double percent = 100 * std::abs(share);
  return fmt::format("{:.{}f}", percent, percent < 0.95 ? 1 : 0);
}

/// "9 % of the time"; "5 to 9 %" where minima and medians do not agree.
std::string time_part(const Beside& time) {
  if (!time.shows()) return "no time that shows";
  const auto [less, more] = std::minmax({std::abs(time.saved_of_minima()), std::abs(time.saved_of_medians())});
  const std::string from = percent_text(less), to = percent_text(more);
  const std::string share = (from == to ? to : from + " to " + to) + " % of the time";
  return time.saved_of_minima() > 0 ? share : share + " gained with it";
}

std::string what_moves(const Ablation& ablation) {
  const std::string quantity = name(ablation.about.quantity);
  const bool end = ablation.about.which == "end";
  if (ablation.about.quantity == Quantity::position) return end ? "the end point" : "the path";
  return end ? quantity + " at the end" : "the " + quantity;
}

std::string path_part(const Ablation& ablation, const Loss& loss) {
  const std::string what = what_moves(ablation), unit = ablation.about.measure_unit;
  if (loss.same_bits) return "changes no bit";
  if (loss.moved > ablation.own_error) return fmt::format("moves {} by {}", what, size_text(loss.moved, unit));
  return fmt::format("moves {} by less than the scene's own error of {}", what, size_text(ablation.own_error, unit));
}

bool is_place(const Change& change) {
  return change.unit == "m";  // of an event; an expectation's unit is open
}

/// Places that move as far as counts, and expectations that are missed.
bool counts(const Ablation& ablation, const Change& change) {
  if (!change.seen()) return false;
  const bool gone = change.full.there && !change.without.there;
  const bool place = is_place(change) && ablation.about.quantity == Quantity::position;
  return gone || change.breaks() || (place && change.size > ablation.most);
}

/// "a, b, c and 2 more"
std::string few_of(const std::vector<std::string>& names) {
  constexpr std::size_t most = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, names.size()); ++i) text += (i > 0 ? ", " : "") + names[i];
  return names.size() > most ? fmt::format("{} and {} more", text, names.size() - most) : text;
}

std::string own_part(const Ablation& ablation, const Loss& loss) {
  std::string text;
  std::vector<std::string> gone, missed;
  for (const Change& change : loss.own) {
    if (!counts(ablation, change)) continue;
    if (change.full.there && !change.without.there) {
      if (!is_place(change)) gone.push_back(change.name);
    } else if (change.breaks()) {
      missed.push_back(change.name);
    } else {
      text += fmt::format(", the {} by {}", change.name, size_text(change.size, change.unit));
    }
  }
  if (!gone.empty()) text += ", leaves no " + few_of(gone);
  if (!missed.empty()) text += ", misses the expected " + few_of(missed);
  return text;
}

std::string mean_part(const Loss& loss) {
  const MeanChange* clearest = nullptr;
  for (const MeanChange& mean : loss.means) {
    if (mean.seen && (!clearest || mean.difference.sigmas() > clearest->difference.sigmas())) clearest = &mean;
  }
  if (!clearest) return ", changes no mean beyond the horizon";
  return fmt::format(", changes the mean {} of runs by {}", clearest->observable.name,
                     size_text(std::abs(clearest->difference.value), clearest->observable.unit));
}

/// Beyond a horizon paths part whatever is dropped: there means decide.
bool to_keep(const Ablation& ablation, const Loss& loss) {
  if (!loss.trouble.empty()) return true;
  if (!loss.means.empty()) return std::any_of(loss.means.begin(), loss.means.end(), [](auto& m) { return m.seen; });
  return loss.moved > std::max(ablation.most, ablation.own_error) ||
         std::any_of(loss.own.begin(), loss.own.end(), [&](auto& change) { return counts(ablation, change); });
}

std::string sentence(const Ablation& ablation, const Loss& loss) {
  if (!loss.trouble.empty()) return fmt::format("{}: without it {}: keep it.", loss.label, loss.trouble);
  const std::string beyond = loss.means.empty() ? own_part(ablation, loss) : mean_part(loss);
  const bool saves = loss.time.shows() && loss.time.saved_of_minima() > 0;
  const std::string verdict = loss.keep ? "keep it" : saves ? "drop it" : "it may go";
  return fmt::format("{}: {}, {}{}: {}.", loss.label, time_part(loss.time), path_part(ablation, loss), beyond, verdict);
}

}  // namespace

void judge(Ablation& ablation) {
  for (Loss& loss : ablation.losses) {
    loss.keep = to_keep(ablation, loss);
    loss.sentence = sentence(ablation, loss);
  }
  const auto error = [&](const Loss& loss) { return loss.moved > ablation.own_error ? loss.moved : 0; };
  std::stable_sort(ablation.losses.begin(), ablation.losses.end(), [&](const Loss& a, const Loss& b) {
    if (a.keep != b.keep) return b.keep;
    if (a.trouble.empty() != b.trouble.empty()) return a.trouble.empty();
    if (error(a) != error(b)) return error(a) < error(b);
    return a.time.saved_of_minima() > b.time.saved_of_minima();
  });
}

}  // namespace ballpark::cost
