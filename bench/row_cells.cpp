#include "bench/row_cells.hpp"

#include <cstring>
#include <limits>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <vector>

namespace oxturn {
namespace {

/// The names of columns that rows of this process have had. Each stands here once, and rows have its number.
class ColumnNames {
 public:
  std::optional<std::uint16_t> known(const std::string& name) {
    const std::lock_guard lock(mutex_);
    const auto at = numbers_.find(name);
    return at == numbers_.end() ? std::nullopt : std::optional(at->second);
  }
  std::uint16_t number(const std::string& name) {
    const std::lock_guard lock(mutex_);
    const auto [at, fresh] = numbers_.try_emplace(name, static_cast<std::uint16_t>(names_.size()));
    if (!fresh) return at->second;
    if (names_.size() > std::numeric_limits<std::uint16_t>::max()) {
      numbers_.erase(at);
      throw std::invalid_argument("more than 65536 different columns");
    }
    names_.push_back(&at->first);
    return at->second;
  }
  const std::string& name(std::uint16_t number) {
    const std::lock_guard lock(mutex_);
    return *names_[number];
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::uint16_t> numbers_;
  std::vector<const std::string*> names_;  // owned by the map
};

ColumnNames& column_names() {
  static ColumnNames names;
  return names;
}

constexpr std::size_t kHead = sizeof(std::uint16_t) + sizeof(std::uint32_t);

}  // namespace

RowCells::RowCells(std::initializer_list<std::pair<std::string, std::string>> cells) {
  for (const auto& [column, cell] : cells) set(column, cell);
}

RowCells::Entry RowCells::entry_at(std::size_t at) const {
  Entry entry{};
  std::memcpy(&entry.column, bytes_.data() + at, sizeof entry.column);
  std::memcpy(&entry.size, bytes_.data() + at + sizeof entry.column, sizeof entry.size);
  return entry;
}

std::size_t RowCells::find(std::uint16_t column) const {
  std::size_t at = 0;
  while (at < bytes_.size()) {
    const Entry entry = entry_at(at);
    if (entry.column == column) break;
    at += kHead + entry.size;
  }
  return at;
}

std::string RowCells::get(const std::string& column) const {
  const auto number = column_names().known(column);
  const std::size_t at = number ? find(*number) : bytes_.size();
  return at == bytes_.size() ? std::string() : bytes_.substr(at + kHead, entry_at(at).size);
}

void RowCells::set(const std::string& column, std::string_view cell) {
  erase(column);
  const std::uint16_t number = column_names().number(column);
  const auto size = static_cast<std::uint32_t>(cell.size());
  bytes_.append(reinterpret_cast<const char*>(&number), sizeof number);
  bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
  bytes_.append(cell);
}

void RowCells::erase(const std::string& column) {
  const auto number = column_names().known(column);
  const std::size_t at = number ? find(*number) : bytes_.size();
  if (at < bytes_.size()) bytes_.erase(at, kHead + entry_at(at).size);
}

std::map<std::string, std::string> RowCells::all() const {
  std::map<std::string, std::string> cells;
  for (std::size_t at = 0; at < bytes_.size(); at += kHead + entry_at(at).size)
    cells[column_names().name(entry_at(at).column)] = bytes_.substr(at + kHead, entry_at(at).size);
  return cells;
}

}  // namespace oxturn
