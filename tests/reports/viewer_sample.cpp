// Writes the viewer's page of the sample drawing, with edits if given, and then a remark, or of its path on a map
// without a drawing:
// viewer_sample PAGE.html [EDITS.json | plain]
#include <exception>
#include <iostream>

#include "base/files.hpp"
#include "reports/viewer/viewer.hpp"
#include "tests/reports/sample_drawing.hpp"

int main(int argc, char** argv) try {
  using namespace oxturn;
  if (argc < 2) throw std::invalid_argument("viewer_sample PAGE.html [EDITS.json | plain]");
  const std::string how = argc > 2 ? argv[2] : "";
  const bool plain = how == "plain";
  std::vector<std::string> remarks;
  if (!plain && !how.empty()) remarks.push_back("area 'crown' is half filled");
  const Problem drawn = sample::problem();
  const Problem problem =
      plain ? Problem({"plain", drawn.map().free, "file", "plain"}, drawn.robot(), drawn.start()) : drawn;
  const Path path = sample::path(problem.start());
  write_file(argv[1], viewer_page({.problem = problem,
                                   .path = &path,
                                   .traces = sample::traces(),
                                   .score = score(problem, path),
                                   .drawing_file = plain ? "" : "sample.svg",
                                   .edits = plain || how.empty() ? "" : read_file(how),
                                   .remarks = remarks}));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
