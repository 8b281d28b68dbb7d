#!/usr/bin/env bash
# Runs clang-tidy 14 on the .cpp files that have changed since RELIEF_TEST_SINCE [the commit before the last], on six of
# them at most, in an order that the commit decides. With RELIEF_TEST_ALL set, runs it on all files, in half an hour.
set -euo pipefail
cd "$(dirname "$0")/.."
database=build/clangd
cmake --preset clangd >/dev/null
compiled() { grep -oE '"file": "[^"]*"' $database/compile_commands.json | cut -d'"' -f4 | sed "s#^$PWD/##" | sort -u; }
if [[ -n ${RELIEF_TEST_ALL:-} ]]; then
  files=$(compiled | grep -E '^(framework|labs|tests)/')
else
  commit=$(git rev-parse HEAD 2>/dev/null) || commit=none
  changed=$({ git diff --name-only --diff-filter=d "${RELIEF_TEST_SINCE:-HEAD~1}" -- '*.cpp'
    git ls-files --others --exclude-standard '*.cpp'; } 2>/dev/null | sort -u) || true
  files=$(comm -12 <(compiled) - <<<"$changed" | while IFS= read -r file; do
    [[ -z $file ]] || echo "$(sha1sum <<<"$commit $file") $file"
  done | sort | awk 'NR <= 6 { print $NF }')
fi
[[ -n $files ]] || { echo "no file that is compiled here has changed"; exit 0; }
echo "$files"
xargs -P 2 -n 1 clang-tidy-14 -p $database --quiet <<<"$files"
