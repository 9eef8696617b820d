/// A list of things that have a name (planners, metrics, generators, ...).
///
///   NamedList<GeneratorInfo> generators("generator", {rooms(), maze()});
///   generators.add(mine);                       // from outside the library
///   generators.find("room");                    // throws: no generator 'room'; did you mean 'rooms'? ...
#pragma once

#include <deque>
#include <initializer_list>
#include <stdexcept>
#include <utility>

#include "base/text.hpp"

namespace oxturn {

/// Keeps the order in which items were added. References to items stay valid as long as the list exists. T has a member
/// `name`.
template <class T>
class NamedList {
 public:
  explicit NamedList(std::string kind, std::initializer_list<T> items = {}) : kind_(std::move(kind)) {
    for (const T& item : items) add(item);
  }

  /// Throws std::invalid_argument if the name is empty or taken.
  void add(T item) {
    if (item.name.empty()) throw std::invalid_argument("a " + kind_ + " without a name cannot be added");
    if (get(item.name) != nullptr)
      throw std::invalid_argument("there is a " + kind_ + " '" + item.name + "' already; choose another name");
    items_.push_back(std::move(item));
  }

  /// The item of this name, or nullptr. O(n): the lists are short.
  const T* get(const std::string& name) const {
    for (const T& item : items_)
      if (item.name == name) return &item;
    return nullptr;
  }
  /// The item of this name. Throws std::invalid_argument with the most similar name and all names.
  const T& find(const std::string& name) const {
    if (const T* item = get(name)) return *item;
    throw std::invalid_argument(unknown_name(kind_, name, names()));
  }
  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const T& item : items_) all.push_back(item.name);
    return all;
  }

  auto begin() const { return items_.begin(); }
  auto end() const { return items_.end(); }
  std::size_t size() const { return items_.size(); }
  const T& operator[](std::size_t i) const { return items_[i]; }

 private:
  std::string kind_;
  std::deque<T> items_;
};

}  // namespace oxturn
