#!/usr/bin/env bash
# docs/make_case_file_page.sh PLENUM-IC > docs/case_file.md
set -euo pipefail
cat <<'TXT'
# The case file

A case is a TOML file in SI units; in d dimensions density is in kg/m^d and pressure in Pa m^(3-d).
Unknown keys are errors. This page is what `plenum-ic help-case --markdown` prints.

TXT
"$1" help-case --markdown
