/// The cells of a row by the names of their columns, in one block of memory: a report of 100,000 runs holds as many
/// rows of some 80 cells, which took four times as much in maps of strings (32,400 rows: 513 MB, now 122 MB).
///
///   RowCells cells{{"planner", "stc"}};
///   cells.set("turns", "12");
///   cells.get("turns");                            // "12"; "" where there is none
///
/// Finding a cell takes time linear in the number of cells.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <utility>

namespace oxturn {

class RowCells {
 public:
  RowCells() = default;
  RowCells(std::initializer_list<std::pair<std::string, std::string>> cells);

  std::string get(const std::string& column) const;
  void set(const std::string& column, std::string_view cell);  // adds it or replaces it
  void erase(const std::string& column);
  std::map<std::string, std::string> all() const;

 private:
  struct Entry {
    std::uint16_t column;  // number of the name
    std::uint32_t size;    // of the cell, which follows
  };
  Entry entry_at(std::size_t at) const;
  /// Where the entry of this column is, or the end.
  std::size_t find(std::uint16_t column) const;

  std::string bytes_;  // entries one after another, each followed by its cell
};

}  // namespace oxturn
