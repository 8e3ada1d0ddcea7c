#!/bin/sh
# Pages in a browser, see check_page.cjs. What drives the browser and what looks for barriers come from npm, into FOLDER.
# usage: check_page.sh PROGRAM SOURCE_FOLDER FOLDER [PART OF THE NAME OF A CHECK]
set -eu

program=$1
source=$2
folder=$3
mkdir -p "$folder"
if [ ! -d "$folder/node_modules/playwright-core" ] || [ ! -d "$folder/node_modules/axe-core" ]; then
    npm install --prefix "$folder" --no-audit --no-fund --silent playwright-core@1.49.1 axe-core@4.10.2
fi
NODE_PATH="$folder/node_modules" exec node "$source/tests/page/check_page.cjs" "$program" "$source" ${4:+"$4"}
