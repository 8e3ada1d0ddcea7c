#!/bin/sh
# throwaway_kind.sh COMPILER ROOT INCLUDE... OPTION... LIBRARY...: a kind of step that nobody knows is put into the list of
# kinds (core/raster/steps.h) and into the table of sentences (step_kind.cpp), and told by a drawing. Nothing else is
# changed, and yet it is told, held, written, read and described. Then it is gone again.
set -eu
compiler=$1 root=$2 record=$2/trace/record
shift 2
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

includes= libraries=
for word; do
    case $word in
    -* | *.a | *.so) libraries="$libraries $word" ;;
    *) includes="$includes -I$word" ;;
    esac
done

# 1. The struct with its table, and its place in the list. The changed header is found before the true one.
header=rastertrace/core/raster/steps.h
mkdir -p "$folder/${header%/*}" "$folder/record"
sed -e 's/^    undecided,$/&\n    throwaway,/' \
    -e 's/"undecided"}/"undecided", "throwaway"}/' -e 's/std::string_view, 21> step_names/std::string_view, 22> step_names/' \
    -e 's/BoundExceeded<Number>>;/BoundExceeded<Number>, ThrownAway<Number>>;/' \
    -e '/^\/\/\/ A step of any kind, in the order of StepKind/r /dev/stdin' "$root/core/include/$header" >"$folder/$header" <<'STRUCT'
template <typename Number = Quantity> struct ThrownAway {
    static constexpr StepKind step_kind = StepKind::throwaway;

    Index x = 0;
    held::Maybe<Number, held::Name<Number>> name = {};
    held::OrNull<Number, Number> none = {};
    held::List<Number, held::Vector<Number, 2>> at = {};

    using Fields = FieldTable<field::Key<"x", &ThrownAway::x, field::required>,
                              field::Told<"name", &ThrownAway::name>,
                              field::Reason<"none", &ThrownAway::none, field::or_null>,
                              field::Reason<"at", &ThrownAway::at>>;
};
STRUCT
[ "$(grep -ci 'throwaway\|thrownaway' "$folder/$header")" -ge 6 ] || { echo "steps.h has another form now"; exit 1; }

# 2. Its sentence.
cp "$record"/*.h "$record"/*.cpp "$folder/record"
sed -i 's/^}};$/    {StepKind::throwaway, "a test runs", "thrown away at {x}"},\n&/' "$folder/record/step_kind.cpp"
mkdir -p "$folder/rastertrace/trace"
ln -s "$folder/record" "$folder/rastertrace/trace/record"

# 3. What tells it.
cat >"$folder/main.cpp" <<'PROGRAM'
#include <rastertrace/core/draw/tell/listener.h>
#include <rastertrace/trace/record/step_decoder.h>
#include <rastertrace/trace/record/step_tracer.h>
#include <rastertrace/trace/record/steps.h>

#include <cstdlib>
#include <iostream>

using namespace rastertrace;

void expect(bool holds, const char* what) {
    if (!holds) {
        std::cout << "not so: " << what << "\n";
        std::exit(1);
    }
}

int main() {
    const Vec<Quantity, 2> corner{Quantity(0.25), Quantity(2.0)};
    Steps steps;
    StepTracer<Steps> tracer(steps, steps.arena(), true);
    const Listener listener(tracer);
    expect(listener.takes<ThrownAway<>>(), "a listener takes it");
    listener(ThrownAway<>{.x = 3, .name = "ABC", .at = {&corner, 1}});

    const std::string line = R"({"step":"throwaway","x":3,"name":"ABC","none":null,"at":[[0.25,2]]})";
    expect(steps.size() == 1 && steps.at(1).json() == line, "it is held and written");
    std::string_view text = line;
    AnyStep read;
    expect(take_step(text, read) && std::get<ThrownAway<TracedNumber>>(read).name == "ABC", "it is read");
    expect(fields_of(StepKind::throwaway).size() == 4, "its fields are known");
    expect(row_of(StepKind::throwaway).fires == "a test runs", "it is described");
}
PROGRAM
for source in field_type step_decoder step_kind step_tracer steps trace traced_steps traced_values; do
    echo "#include \"record/$source.cpp\"" >>"$folder/main.cpp"
done
"$compiler" -std=c++20 -O0 "-I$folder" $includes "$folder/main.cpp" $libraries -o "$folder/main"
"$folder/main"
