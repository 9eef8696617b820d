/// Plug-ins: shared objects that bring planners, metrics, map generators, map formats or report tables.
///
///   #include <oxturn/bench/plugin.hpp>                                  // wavy.cpp, compiled to wavy.so
///   OXTURN_PLUGIN(registry) { registry.planners.add(wavy()); }
///
///   oxturn plan wavy rooms:7 --plugin ./wavy.so
///
/// docs/plugin-template/ is a project to start from. A plug-in and the program share C++ types, so both must be built
/// from the same headers, by the same compiler and with the same settings of libraries; what is not is refused.
#pragma once

#include <Eigen/Core>
#include <string>

#include "bench/plugin_headers.hpp"
#include "bench/registry.hpp"

namespace oxturn {

/// Loads a plug-in and adds what it brings to the registry. Its planners get the file's name as `origin` and its
/// SHA-256 as `identity`, so that it is part of the identity of their runs; so do its metrics, and a results folder
/// takes no rows that another version has scored. The plug-in stays loaded until the
/// program ends. Throws std::invalid_argument with a sentence that names the file and what is wrong: it cannot be
/// loaded, is no plug-in, was built otherwise, or brings a name that is taken.
void load_plugin(Registry& registry, const std::string& file);

/// What must be equal for a plug-in to be loaded, as text.
std::string plugin_abi();

}  // namespace oxturn

#define OXTURN_TEXT_OF(value) #value
#define OXTURN_TEXT(value) OXTURN_TEXT_OF(value)
#ifdef __clang__
#define OXTURN_COMPILER "Clang " OXTURN_TEXT(__clang_major__)
#else
#define OXTURN_COMPILER "GCC " OXTURN_TEXT(__GNUC__)
#endif
#ifdef NDEBUG
#define OXTURN_ASSERTIONS "off"
#else
#define OXTURN_ASSERTIONS "on"
#endif
/// Of the code that includes this header.
#define OXTURN_ABI \
  "oxturn " OXTURN_VERSION_TEXT ", headers " OXTURN_HEADERS ", " OXTURN_COMPILER ", libstdc++ " OXTURN_TEXT( \
      __GLIBCXX__) " with C++11 strings " OXTURN_TEXT(_GLIBCXX_USE_CXX11_ABI) ", Eigen " OXTURN_TEXT(        \
      EIGEN_WORLD_VERSION) "." OXTURN_TEXT(EIGEN_MAJOR_VERSION) "." OXTURN_TEXT(EIGEN_MINOR_VERSION) " aligned to " \
      OXTURN_TEXT(EIGEN_MAX_ALIGN_BYTES) ", assertions " OXTURN_ASSERTIONS

/// Defines a plug-in: followed by the body of a function that adds to the registry of the given name.
#define OXTURN_PLUGIN(registry)                                                                            \
  extern "C" __attribute__((visibility("default"))) const char* oxturn_plugin_abi() { return OXTURN_ABI; } \
  extern "C" __attribute__((visibility("default"))) void oxturn_plugin_register(::oxturn::Registry& registry)
