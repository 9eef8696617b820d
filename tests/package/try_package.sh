#!/usr/bin/env bash
# try_package.sh BUILD_DIR SOURCE_DIR WORK_DIR CXX_FLAGS: installs, then builds and runs the consumer.
set -euo pipefail
rm -rf "$3"
cmake --install "$1" --prefix "$3/prefix" >/dev/null
cmake -S "$2/tests/package" -B "$3/build" -G Ninja -DCMAKE_PREFIX_PATH="$3/prefix" -DCMAKE_CXX_FLAGS="$4" >/dev/null
cmake --build "$3/build"
"$3/build/consumer"
