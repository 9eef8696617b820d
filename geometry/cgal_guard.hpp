// Private to geometry/*.cpp: CGAL's failures become one std::runtime_error and nothing is printed.
#pragma once

#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <stdexcept>
#include <string>

namespace oxturn {

/// Runs f; `what` names the work for the message.
template <class F>
auto cgal_guarded(const char* what, F f) {
  static const bool quiet = [] {
    const auto silent = [](const char*, const char*, const char*, int, const char*) {};
    CGAL::set_error_handler(silent);
    CGAL::set_warning_handler(silent);
    CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
    return true;
  }();
  static_cast<void>(quiet);
  try {
    return f();
  } catch (const CGAL::Failure_exception& e) {
    throw std::runtime_error(std::string(what) + " failed: " + e.what() + "; run repaired() on the region first");
  }
}

}  // namespace oxturn
