// Private to geometry/*.cpp: CGAL's failures become one std::runtime_error and nothing is printed.
#pragma once

#include <functional>

namespace oxturn {

/// Runs `work`; `what` names it for the message.
void cgal_guarded(const char* what, const std::function<void()>& work);

}  // namespace oxturn
