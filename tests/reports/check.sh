#!/bin/sh
# Wrong rasterization as it was reported: NN-NAME.json is a scene, NN-NAME.txt what was drawn, and `diagnose` has to name
# the mistake NAME; as-asked is none. The pictures come of plain loops, as the reports have the code.
#
#     check.sh RASTERTRACE FOLDER
wrong=0
for scene in "$2"/*.json; do
  name=$(basename "$scene" .json)
  name=${name#*-}
  told=$("$1" diagnose "$scene" "${scene%.json}.txt" | head -n 1)
  case "$name: $told" in
    "as-asked: drawn as the scene asks" | "$name: makes the mistake $name:"*) ;;
    *)
      echo "$scene: expected $name, found: $told"
      wrong=1
      ;;
  esac
done
exit $wrong
