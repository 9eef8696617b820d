/// What a planner's description promises to cover. Results are compared among planners that promise the same.
#pragma once

namespace oxturn {

enum class Promise {
  target,   // the whole target
  cells,    // the cells that it hands out as a region (Context::promise)
  nothing,  // as much as it happens to reach
};
constexpr const char* to_text(Promise promise) {
  return promise == Promise::target ? "target" : promise == Promise::cells ? "cells" : "nothing";
}

}  // namespace oxturn
