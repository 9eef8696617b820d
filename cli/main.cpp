#include "cli/program.hpp"
#include "reports/built_in_registry.hpp"

int main(int argc, char** argv) { return oxturn::cli::run_program(argc, argv, oxturn::built_in_registry()); }
