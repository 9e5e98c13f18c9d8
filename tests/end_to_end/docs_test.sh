#!/usr/bin/env bash
# The page of all case keys is made from the declarations; it must not lag behind them.
set -euo pipefail
ic=$1 root=$2
diff <("$root/docs/make_case_file_page.sh" "$ic") "$root/docs/case_file.md" ||
  { echo "run docs/make_case_file_page.sh PLENUM-IC > docs/case_file.md"; exit 1; }
