// Temporary folders, and sentences of exceptions.
#pragma once

#include <exception>
#include <string>

#include "base/temporary_folder.hpp"

namespace oxturn {

/// What an action complains of: its exception's text, or "" if it does not.
template <class Action>
std::string complaint(Action action) {
  try {
    action();
  } catch (const std::exception& e) { return e.what(); }
  return "";
}

}  // namespace oxturn
