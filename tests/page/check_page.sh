#!/bin/sh
# Pages in a browser, see check_page.cjs.
# usage: check_page.sh PROGRAM SOURCE_FOLDER FOLDER [PART OF THE NAME OF A CHECK]
set -eu

program=$1
source=$2
folder=$3
exec "$source/tests/page/with_browser.sh" "$folder" "$source/tests/page/check_page.cjs" "$program" "$source" ${4:+"$4"}
