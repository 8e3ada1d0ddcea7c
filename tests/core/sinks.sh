#!/bin/sh
# sinks.sh COMPILER INCLUDE...: a sink with an overload that would never be called does not compile, and is told why; what
# a sink does wrong itself is told first; and so is a compiler that is not asked for C++20.
set -eu
compiler=$1
shift
for include; do
    set -- "$@" "-I$include"
    shift
done
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

says() { # says STANDARD MOST_LINES TEXT: source on standard input; MOST_LINES: 0 for any
    standard=$1 most=$2 text=$3
    shift 3
    cat >"$folder/sink.cpp"
    if "$compiler" "-std=$standard" -fsyntax-only $includes "$folder/sink.cpp" 2>"$folder/errors"; then
        echo "expected an error: $text"
        cat "$folder/sink.cpp"
        exit 1
    fi
    grep -qF "$text" "$folder/errors" || { echo "expected: $text, found:"; cat "$folder/errors"; exit 1; }
    lines=$(wc -l <"$folder/errors")
    [ "$most" = 0 ] || [ "$lines" -le "$most" ] || { echo "expected $most lines at most, found $lines"; head -n 40 "$folder/errors"; exit 1; }
}
includes=$*
# Another compiler than g++ says the same of each kind of step.
most=20
"$compiler" --version | grep -qi clang && most=0

sink() { # sink OVERLOAD...
    echo '#include <rastertrace/core.h>'
    echo 'using namespace rastertrace;'
    echo 'struct Sink { void operator()(const PixelPlotted<>&) {}' "$@" '};'
    echo 'void f(const Scene& scene, const Plan& plan) { Sink sink; draw(scene, plan, sink); }'
}
sink 'void operator()(const ScanlineSpanned<double>&) {}' |
    says c++20 $most 'a sink takes a step over another scalar than Quantity'
sink 'void operator()(EdgeSetUp<>&) {}' |
    says c++20 $most 'a sink takes a step by a reference that is not const'
{
    echo '#include <rastertrace/core.h>'
    echo 'using namespace rastertrace;'
    echo 'void f(const Scene& scene, const Plan& plan, int& n) { draw(scene, plan, [&](const auto& step) { n += step.nothing; }); }'
} | says c++20 $most nothing
sink | says c++17 0 'rastertrace needs C++20: -std=c++20'

sink 'void operator()(const ScanlineSpanned<>&) {}' 'void operator()(LineDecided<>) {}' >"$folder/sink.cpp"
"$compiler" -std=c++20 -fsyntax-only $includes "$folder/sink.cpp"
