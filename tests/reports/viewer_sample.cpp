// Writes the viewer's page of the sample drawing: viewer_sample PAGE.html [EDITS.json]
#include <exception>
#include <iostream>

#include "base/files.hpp"
#include "reports/viewer/viewer.hpp"
#include "tests/reports/sample_drawing.hpp"

int main(int argc, char** argv) try {
  using namespace oxturn;
  if (argc < 2) throw std::invalid_argument("viewer_sample PAGE.html [EDITS.json]");
  const Problem problem = sample::problem();
  const Path path = sample::path(problem.start());
  write_file(argv[1], viewer_page({.problem = problem,
                                   .path = &path,
                                   .traces = sample::traces(),
                                   .score = score(problem, path),
                                   .drawing_file = "sample.svg",
                                   .edits = argc > 2 ? read_file(argv[2]) : ""}));
  return 0;
} catch (const std::exception& error) {
  std::cerr << error.what() << '\n';
  return 2;
}
