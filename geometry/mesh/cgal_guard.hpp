/// Runs code that calls CGAL: its failures become one std::runtime_error, and it prints nothing. Private to geometry,
/// not installed.
#pragma once

#include <functional>

namespace oxturn {

/// Runs `work`; `what` names it in the message.
void cgal_guarded(const char* what, const std::function<void()>& work);

}  // namespace oxturn
