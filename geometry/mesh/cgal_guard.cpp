#include "geometry/mesh/cgal_guard.hpp"

// First: it says that CGAL is header-only.
#include <CGAL/config.h>
//
#include <CGAL/assertions.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/exceptions.h>

#include <stdexcept>
#include <string>

namespace oxturn {

void cgal_guarded(const char* what, const std::function<void()>& work) {
  static const bool quiet = [] {
    const auto silent = [](const char*, const char*, const char*, int, const char*) {};
    CGAL::set_error_handler(silent);
    CGAL::set_warning_handler(silent);
    CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION);
    return true;
  }();
  static_cast<void>(quiet);
  try {
    work();
  } catch (const CGAL::Failure_exception& e) {
    throw std::runtime_error(std::string(what) + " failed: " + e.what() + "; run repaired() on the region first");
  }
}

}  // namespace oxturn
