// Series of frames as NumPy's .npz, an archive of arrays that are not compressed.
#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>

#include "scenarios/command/frame_source.h"
#include "scenarios/files/npy.h"

namespace ballpark::command {
namespace {

using U64 = std::uint64_t;

/// Little-endian.
U64 number_at(std::string_view bytes, std::size_t at, std::size_t size) {
  if (at > bytes.size() || bytes.size() - at < size) throw std::runtime_error("its list of arrays is damaged");
  U64 number = 0;
  for (std::size_t i = size; i-- > 0;) number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
  return number;
}

/// Arrays of an archive by name: where their data lies in the file.
struct Array {
  scenes::NpyLayout layout;
  U64 data = 0;
};

class Archive {
 public:
  explicit Archive(const std::string& path) : stream_(path, std::ios::binary), size_(std::filesystem::file_size(path)) {
    read_list();
  }

  const Array* find(const std::string& name) const {
    const auto found = arrays_.find(name);
    return found == arrays_.end() ? nullptr : &found->second;
  }

  std::string bytes(U64 at, U64 size) {
    if (at > size_ || size_ - at < size) throw std::runtime_error("it ends too early");
    std::string text(size, '\0');
    stream_.seekg(static_cast<std::streamoff>(at));
    if (!stream_.read(text.data(), static_cast<std::streamsize>(size))) throw std::runtime_error("it cannot be read");
    return text;
  }

  /// `count` items from the `first` on.
  void numbers(const Array& array, U64 first, std::size_t count, std::vector<double>& to) {
    const std::size_t size = array.layout.item_size();
    const std::string raw = bytes(array.data + first * size, count * size);
    for (std::size_t i = 0; i < count; ++i) {
      if (size == sizeof(double)) {
        double item = 0;
        std::memcpy(&item, raw.data() + i * size, size);
        to.push_back(item);
      } else {
        float item = 0;
        std::memcpy(&item, raw.data() + i * size, size);
        to.push_back(item);
      }
    }
  }

 private:
  struct End {
    U64 entries, size, offset;
  };

  // The records of ZIP: APPNOTE.TXT 6.3, sections 4.3.6 to 4.3.16.
  End find_end() {
    constexpr U64 longest = 22 + 0xffff + 20 + 56;
    const U64 from = size_ > longest ? size_ - longest : 0;
    const std::string tail = bytes(from, size_ - from);
    const std::size_t end = tail.rfind("PK\5\6");
    if (end == std::string::npos) throw std::runtime_error("it is no whole .npz file");
    const std::size_t locator = end >= 20 ? end - 20 : 0;
    if (tail.compare(locator, 4, "PK\6\7") != 0) {
      return {number_at(tail, end + 10, 2), number_at(tail, end + 12, 4), number_at(tail, end + 16, 4)};
    }
    const std::string record = bytes(number_at(tail, locator + 8, 8), 56);
    return {number_at(record, 32, 8), number_at(record, 40, 8), number_at(record, 48, 8)};
  }

  void read_list() {
    const End end = find_end();
    const std::string list = bytes(end.offset, end.size);
    std::size_t at = 0;
    for (U64 entry = 0; entry < end.entries; ++entry) {
      const std::size_t name = number_at(list, at + 28, 2), extra = number_at(list, at + 30, 2);
      const std::size_t fields = at + 46 + name, next = fields + extra + number_at(list, at + 32, 2);
      if (next > list.size()) throw std::runtime_error("its list of arrays is damaged");
      add(list.substr(at + 46, name), number_at(list, at + 10, 2) == 0, number_at(list, at + 24, 4),
          number_at(list, at + 20, 4), number_at(list, at + 42, 4), std::string_view(list).substr(fields, extra));
      at = next;
    }
  }

  /// `extra` has those numbers that do not fit their fields, in this order.
  void add(const std::string& name, bool stored, U64 size, U64 packed, U64 offset, std::string_view extra) {
    constexpr U64 see_extra = 0xffffffff, zip64 = 1;
    for (std::size_t at = 0; at + 4 <= extra.size(); at += 4 + number_at(extra, at + 2, 2)) {
      std::size_t field = at + 4;
      for (U64* number : {&size, &packed, &offset}) {
        if (number_at(extra, at, 2) != zip64 || *number != see_extra) continue;
        *number = number_at(extra, field, 8);
        field += 8;
      }
    }
    if (!name.ends_with(".npy")) return;
    if (!stored) throw std::runtime_error(fmt::format("{} is compressed: numpy.savez stores arrays as they are", name));
    const std::string local = bytes(offset, 30);
    const U64 start = offset + 30 + number_at(local, 26, 2) + number_at(local, 28, 2);
    constexpr U64 longest_head = 1 << 16;
    const std::string head = bytes(start, std::min({size, longest_head, size_ - std::min(start, size_)}));
    std::string_view rest = head;
    Array array{scenes::take_npy_header(rest), 0};
    array.data = start + head.size() - rest.size();
    const U64 room = size - (head.size() - rest.size());
    U64 items = 1;
    for (const std::size_t length : array.layout.shape) {
      if (length > 0 && items > room / length) throw std::runtime_error(fmt::format("{} ends too early", name));
      items *= length;
    }
    const std::size_t item = array.layout.item_size();
    if (item > 0 && items > room / item) throw std::runtime_error(fmt::format("{} ends too early", name));
    bytes(array.data + items * item, 0);
    arrays_.emplace(name.substr(0, name.size() - 4), array);
  }

  std::ifstream stream_;
  U64 size_;
  std::map<std::string, Array> arrays_;
};

class NpzSource : public FrameSource {
 public:
  explicit NpzSource(const std::string& path) : path_(path) {
    guarded([&] {
      archive_.emplace(path);
      const Array& time = array("time", {});
      if (time.layout.shape.size() != 1) {
        throw std::runtime_error(
            fmt::format("the shape of 'time' is {}, expected (frames,)", time.layout.shape_text()));
      }
      archive_->numbers(time, 0, time.layout.shape[0], times_);
      if (times_.empty()) throw std::runtime_error("it has no frame");
      const bool ascend = std::adjacent_find(times_.begin(), times_.end(), std::greater_equal<>()) == times_.end();
      if (!ascend) throw std::runtime_error("its times do not ascend");
      const std::vector<std::size_t>& shape = array("position", {}).layout.shape;
      if (shape.size() != 3 || shape[1] == 0) throw std::runtime_error("'position' is not (frames, bodies, 3)");
      layout_.bodies = shape[1];
      for (const FrameColumn& column : known_columns()) {
        if (!archive_->find(column.name)) continue;
        std::vector<std::size_t> expected{times_.size(), layout_.bodies};
        if (column.components() > 1) expected.push_back(column.components());
        columns_.push_back(array(column.name, expected));
        layout_.columns.push_back(column);
      }
      if (!archive_->find("radius")) return;
      archive_->numbers(array("radius", {layout_.bodies}), 0, layout_.bodies, layout_.radius);
    });
  }

  std::size_t frames() const override { return times_.size(); }

  bool next(Frames& frame) override {
    if (at_ == times_.size()) return false;
    frame.columns.resize(columns_.size());
    frame.clear();
    frame.times.push_back(times_[at_]);
    guarded([&] {
      for (std::size_t c = 0; c < columns_.size(); ++c) {
        const std::size_t items = layout_.bodies * layout_.columns[c].components();
        archive_->numbers(columns_[c], at_ * items, items, frame.columns[c]);
      }
    });
    ++at_;
    return true;
  }

 private:
  template <class Action>
  void guarded(const Action& action) const {
    try {
      action();
    } catch (const std::runtime_error& error) {
      refuse_frames(path_, error.what());
    }
  }

  /// Of this shape, if one is given.
  const Array& array(const std::string& name, const std::vector<std::size_t>& shape) const {
    const Array* found = archive_->find(name);
    if (!found)
      throw std::runtime_error(fmt::format("it has no array '{}' as series of `ballpark run --out` do", name));
    const scenes::NpyLayout& layout = found->layout;
    if (layout.item_size() == 0) {
      throw std::runtime_error(fmt::format("'{}' is of type {}, expected <f8 or <f4", name, layout.type));
    }
    if (!shape.empty() && layout.shape != shape) {
      throw std::runtime_error(
          fmt::format("the shape of '{}' is {}, expected ({})", name, layout.shape_text(), fmt::join(shape, ", ")));
    }
    return *found;
  }

  std::string path_;
  std::optional<Archive> archive_;
  std::vector<double> times_;
  std::vector<Array> columns_;
  std::size_t at_ = 0;  ///< the next frame
};

}  // namespace

std::unique_ptr<FrameSource> open_npz(const std::string& path) {
  return std::make_unique<NpzSource>(path);
}

}  // namespace ballpark::command
