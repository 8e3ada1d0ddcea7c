#!/bin/sh
# installed.sh PREFIX COMPILER: what is installed beside the libraries is there and works from there.
set -eu
prefix=$1
compiler=$2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() {
    echo "installed.sh: $1" >&2
    exit 1
}

# A page of the manual for every command, which man can read.
share=$prefix/share
commands=$("$prefix/bin/rastertrace" help -- '')
case $commands in *show*) ;; *) fail "no commands" ;; esac
for command in $commands; do
    man -l "$share/man/man1/rastertrace-$command.1.gz" 2>&1 | col -b | grep -q "rastertrace $command" || fail "no page of the manual: $command"
done
for file in bash-completion/completions/rastertrace zsh/site-functions/_rastertrace \
    fish/vendor_completions.d/rastertrace.fish; do
    grep -q 'help --' "$share/$file" || fail "no completion: $file"
done

# The program finds the examples of its own prefix, wherever that is moved to.
cp -R "$prefix/bin" "$folder/bin"
mkdir "$folder/share"
cp -R "$share/rastertrace" "$folder/share/rastertrace"
"$folder/bin/rastertrace" --version --verbose | grep -qF "$folder/share/rastertrace/examples" || fail "examples not found"
(cd "$folder" && bin/rastertrace examples -o examples && bin/rastertrace check examples/claims/t0-rows.claims) >/dev/null ||
    fail "an example that was copied does not run"
for schema in scene trace claims; do
    "$folder/bin/rastertrace" validate --schema $schema | cmp - "$share/rastertrace/schemas/$schema.schema.json"
done
[ -f "$share/rastertrace/styles/rastertrace.sty" ] && [ -f "$share/rastertrace/rastertrace.py" ] ||
    fail "expected styles and the module for Python"
[ -f "$share/doc/rastertrace/copyright" ] && [ -f "$share/doc/rastertrace/docs/commands.md" ] || fail "expected the docs"

# Without CMake, by pkg-config.
pc=$(dirname "$(find "$prefix" -name rastertrace.pc)")
export PKG_CONFIG_PATH="$pc"
# shellcheck disable=SC2046  # a list of words
$compiler -std=c++20 "$(dirname "$0")/project/main.cpp" $(pkg-config --cflags --libs rastertrace) \
    -Wl,-rpath,"$(dirname "$pc")" -o "$folder/consumer"
"$folder/consumer" | grep -qx "the consumer's picture has 49 pixels"
