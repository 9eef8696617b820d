#include "bench/plugin.hpp"

#include <dlfcn.h>

#include <exception>
#include <filesystem>

#include "base/files.hpp"
#include "base/sha256.hpp"
#include "base/throw_invalid.hpp"

namespace oxturn {
namespace {

template <class Function>
Function* symbol(void* library, const char* name, const std::string& file) {
  void* found = ::dlsym(library, name);
  if (found == nullptr)
    throw_invalid("'{}' is no plug-in of oxturn: it has no symbol '{}'; docs/plugin-template/ shows how to make one",
                  file, name);
  return reinterpret_cast<Function*>(found);
}

/// What the plug-in brings, alone.
Registry brought_by(const std::string& file) {
  // With a slash in its name the file itself is meant, not one of that name in the system's folders.
  void* library = ::dlopen(std::filesystem::absolute(file).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    const char* why = ::dlerror();
    throw_invalid("plug-in '{}' cannot be loaded: {}", file, why != nullptr ? why : "unknown error");
  }
  const std::string abi = symbol<const char*()>(library, "oxturn_plugin_abi", file)();
  if (abi != plugin_abi())
    throw_invalid(
        "plug-in '{}' was built for [{}], and this program is [{}]; build it again with this oxturn's headers", file,
        abi, plugin_abi());
  Registry brought;
  try {
    symbol<void(Registry&)>(library, "oxturn_plugin_register", file)(brought);
  } catch (const std::exception& error) { throw_invalid("plug-in '{}': {}", file, error.what()); }
  return brought;
}

template <class T>
void add_all(NamedList<T>& list, const NamedList<T>& more) {
  for (const T& item : more) list.add(item);
}
template <class T>
void add_all(NamedList<T>& list, const NamedList<T>& more, const std::string& origin, const std::string& identity) {
  for (T item : more) {
    item.origin = origin;
    item.identity = identity;
    list.add(std::move(item));
  }
}

}  // namespace

std::string plugin_abi() { return OXTURN_ABI; }

void load_plugin(Registry& registry, const std::string& file) {
  const std::string identity = sha256(read_file(file));
  const Registry brought = brought_by(file);
  try {
    add_all(registry.planners, brought.planners, file, identity);
    add_all(registry.metrics, brought.metrics, file, identity);
    add_all(registry.generators, brought.generators);
    add_all(registry.formats, brought.formats);
    add_all(registry.tables, brought.tables);
  } catch (const std::invalid_argument& error) { throw_invalid("plug-in '{}': {}", file, error.what()); }
}

}  // namespace oxturn
