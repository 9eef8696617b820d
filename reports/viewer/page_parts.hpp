// The sources of the page in page/, as CMake embeds them (cmake/embed_text.cmake). Private to reports/viewer.
#pragma once

#include <string_view>

namespace oxturn::viewer {

extern const std::string_view kTemplate;  // page.html
extern const std::string_view kStyle;     // style.css
extern const std::string_view kScript;    // the scripts, one after the other

}  // namespace oxturn::viewer
