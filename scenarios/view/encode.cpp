#include "scenarios/view/encode.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scenarios/view/deflate.h"
#include "scenarios/view/header.h"

namespace ballpark::view {
namespace {

/// One column after the other.
class Columns {
 public:
  explicit Columns(const Recording& recording) : shown_(recording.shown), frames_(recording.times.size()) {}

  /// `quantised`: the value at an index of frame, body and component.
  template <class Quantised>
  void add(const HeaderColumn& column, const Quantised& quantised) {
    const std::size_t before = bytes_;
    const std::size_t width = shown_ * column.components;
    std::vector<unsigned> last(width), steps(width);
    std::vector<std::uint8_t> frame(width * column.bits / 8);
    for (std::size_t f = 0; f < frames_; ++f) {
      for (std::size_t body = 0; body < shown_; ++body) {
        for (std::size_t c = 0; c < column.components; ++c) {
          const std::size_t place = c * shown_ + body;
          const unsigned q = quantised((f * shown_ + body) * column.components + c);
          const unsigned step = q - last[place], change = column.differences == 2 ? step - steps[place] : step;
          last[place] = q;
          steps[place] = step;
          const std::size_t byte = c * shown_ * column.bits / 8 + body;
          frame[byte] = static_cast<std::uint8_t>(change);
          if (column.bits == 16) frame[byte + shown_] = static_cast<std::uint8_t>(change >> 8);
        }
      }
      deflater_.add(frame);
    }
    bytes_ = deflater_.flush();
    headers_.push_back(column);
    sizes_.push_back({column.name, (bytes_ - before + 2) / 3 * 4});
  }

  std::string data() { return base64(deflater_.finish()); }
  const std::vector<HeaderColumn>& headers() const { return headers_; }
  const std::vector<Encoded::Column>& sizes() const { return sizes_; }

 private:
  std::size_t shown_, frames_, bytes_ = 0;
  Deflater deflater_;
  std::vector<HeaderColumn> headers_;
  std::vector<Encoded::Column> sizes_;
};

/// Where `value` lies between `low` and `high`, in whole parts of 2^bits - 1.
unsigned part_of(double value, double low, double high, double parts) {
  return high > low ? static_cast<unsigned>(std::lround(std::clamp((value - low) / (high - low), 0.0, 1.0) * parts))
                    : 0;
}

/// Of positions. Three of them: nobody is there, see place() in page/shaders.js.
constexpr unsigned last_place = 65535;

template <class Number>
void add_amount(Columns& columns, const std::string& name, const std::string& unit, const std::vector<Number>& values) {
  if (values.empty()) return;
  const double most = *std::max_element(values.begin(), values.end());
  columns.add({name, 1, 8, 1, std::pair(0.0, most), unit},
              [&](std::size_t i) { return part_of(values[i], 0, most, 255); });
}

/// 0.05 mm
std::string length_text(double metres) {
  constexpr std::pair<double, const char*> units[] = {{1e3, "km"}, {1, "m"}, {1e-3, "mm"}, {1e-6, "um"}, {1e-9, "nm"}};
  for (const auto& [size, unit] : units) {
    if (metres >= 0.9995 * size) return fmt::format("{:.3g} {}", metres / size, unit);
  }
  return fmt::format("{:.3g} m", metres);
}

std::string grouped(std::size_t n) {
  std::string digits = std::to_string(n);
  for (std::size_t i = digits.size(); i > 3; i -= 3) digits.insert(i - 3, ",");
  return digits;
}

std::vector<std::string> notes_of(const Recording& recording, const Box& box) {
  std::vector<std::string> notes;
  const double widest = (box.high - box.low).maxCoeff();
  if (widest > 0) {
    notes.push_back(fmt::format("positions are rounded to {}, 1/65535 of the box", length_text(widest / 65535)));
  }
  if (recording.stride > 1) {
    notes.push_back(fmt::format("{} of {} bodies are shown: one in {} of each group", grouped(recording.shown),
                                grouped(recording.bodies), grouped(recording.stride)));
  }
  notes.insert(notes.end(), recording.notes.begin(), recording.notes.end());
  return notes;
}

/// With as few bodies left out as trying finds: how small they get is known only then.
std::optional<Encoded> encode_one(const Recording& recording, std::size_t limit) {
  constexpr std::size_t probe_bodies = 2048;
  const auto times_too_large = [&](double bytes) { return bytes / static_cast<double>(limit); };
  std::size_t most = 1, factor = 1;
  for (const ShownGroup& group : recording.groups) most = std::max(most, group.count);
  if (recording.shown > 2 * probe_bodies) {
    const std::size_t thinner = recording.shown / probe_bodies;
    const Encoded probe = encode(thinned(recording, thinner));
    factor = static_cast<std::size_t>(times_too_large(static_cast<double>(probe.bytes() * thinner)));
  }
  for (factor = std::clamp<std::size_t>(factor, 1, most);;) {
    Encoded encoded = factor == 1 ? encode(recording) : encode(thinned(recording, factor));
    if (encoded.bytes() <= limit) return encoded;
    if (factor == most) return std::nullopt;
    const double needed = static_cast<double>(factor) * times_too_large(static_cast<double>(encoded.bytes()));
    factor = std::min(most, std::max(factor + 1, static_cast<std::size_t>(needed)));
  }
}

}  // namespace

Encoded encode(const Recording& recording) {
  const Box box = box_of(recording);
  Columns columns(recording);
  const auto part = [&](std::size_t i) {
    const auto c = static_cast<Eigen::Index>(i % 3);
    return part_of(recording.position[i], box.low[c], box.high[c], last_place);
  };
  columns.add({"position", 3, 16, 2, {}, ""}, [&](std::size_t i) -> unsigned {
    if (std::isnan(recording.position[i])) return last_place;
    const bool corner = i % 3 == 2 && part(i) == last_place && part(i - 1) == last_place && part(i - 2) == last_place;
    return corner ? last_place - 1 : part(i);
  });
  if (!recording.orientation.empty()) {
    columns.add({"orientation", 3, 16, 2, {}, ""}, [&](std::size_t i) { return unsigned{recording.orientation[i]}; });
  }
  add_amount(columns, "speed", "m/s", recording.speed);
  add_amount(columns, "energy", "J", recording.energy);
  if (!recording.contacts.empty()) {
    columns.add({"contacts", 1, 8, 1, std::pair(0.0, 255.0), ""},
                [&](std::size_t i) { return unsigned{recording.contacts[i]}; });
  }
  Encoded encoded;
  encoded.data = columns.data();
  encoded.columns = columns.sizes();
  encoded.bodies = recording.bodies;
  encoded.shown = recording.shown;
  encoded.stride = recording.stride;
  encoded.frames = recording.times.size();
  encoded.notes = notes_of(recording, box);
  const Box placed{recording.origin + box.low, recording.origin + box.high};
  encoded.header = header(recording, placed, columns.headers(), encoded.notes);
  return encoded;
}

std::optional<std::vector<Encoded>> encode_within(const std::vector<const Recording*>& recordings, std::size_t limit) {
  std::vector<Encoded> all;
  for (const Recording* recording : recordings) {
    const std::size_t share = limit / recordings.size();
    std::optional<Encoded> encoded = share > 0 ? encode_one(*recording, share) : std::nullopt;
    if (!encoded) return std::nullopt;
    all.push_back(std::move(*encoded));
  }
  return all;
}

}  // namespace ballpark::view
