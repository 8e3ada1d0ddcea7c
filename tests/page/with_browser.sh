#!/bin/sh
# Runs a script that drives a browser. What drives it and what looks for barriers come from npm, into FOLDER.
# usage: with_browser.sh FOLDER SCRIPT [WORDS]
set -eu

folder=$1
shift
mkdir -p "$folder"
( # tests that run at the same time have the same folder
    flock 9
    if [ ! -d "$folder/node_modules/playwright-core" ] || [ ! -d "$folder/node_modules/axe-core" ]; then
        npm install --prefix "$folder" --no-audit --no-fund --silent playwright-core@1.49.1 axe-core@4.10.2
    fi
) 9>"$folder/lock"
NODE_PATH="$folder/node_modules" exec node "$@"
