#!/usr/bin/env bash
# The numerical stress suite (tests/stress): a table of cases tried and failed for each family. All of it is 10 million
# polynomials, 108 million rays through closed shapes and more: hours. RB_STRESS_SHARE is the part that is run,
# RB_STRESS_FROM what an earlier run has done of it.
# usage: [RB_STRESS_SHARE=0.01] [RB_STRESS_FROM=0] scripts/stress.sh [solvers|leaks|placement|hard_cases|specks ...]
set -euo pipefail
cd "$(dirname "$0")/.."
scripts/install_packages.sh test
cmake --preset test > /dev/null
cmake --build --preset test --target stress > /dev/null
exec build/test/stress --share "${RB_STRESS_SHARE:-1}" --from "${RB_STRESS_FROM:-0}" "$@"
