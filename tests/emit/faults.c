// SPDX-License-Identifier: MIT
// What is called in a wrong way is told once, by its place. Nothing is written from there on, and no end record.
//
//     faults FOLDER

#define RT_FILE "where/it/lies/faults.c"
#include <rastertrace/emit.h>

static int failures = 0;
static char path[1000];
static struct rt_trace trace;
static struct rt_trace* const t = &trace;

static const char* place_of(int line) {
    static char place[40];
    snprintf(place, sizeof place, " in faults.c:%d", line);
    return place;
}

/// The trace must end with that fault, of a call in that line of this file, and have `lines` lines, none of them the
/// end record; four if it was ended before.
static void expect_fault(int line, const char* call, const char* fault, int lines) {
    char expected[300], text[2000];
    int found = 0, ends = 0;
    const int status = rt_end(t);
    FILE* const file = fopen(path, "r");
    // Of a macro over two lines, compilers take one or the other.
    const int is_line_before = strstr(rt_error(t), place_of(line)) == NULL;
    snprintf(expected, sizeof expected, "%s%s: expected %s", call, place_of(line - is_line_before),
             fault);
    for (; file != NULL && fgets(text, sizeof text, file) != NULL; ++found)
        ends += strncmp(text, "{\"end\"", 6) == 0;
    if (file != NULL)
        fclose(file);
    if (lines == 4)
        --ends; // it was ended before
    if (status == 0 || strcmp(rt_error(t), expected) != 0 || found != lines || ends != 0) {
        printf("expected: %s, %d lines\nfound:    %s, %d lines, %d ends, status %d\n", expected,
               lines, rt_error(t), found, ends, status);
        ++failures;
    }
}

/// A call, and what must come of it; the same in a trace that has begun.
#define FAULT_IN_TRACE(call, name, fault, lines)                                                   \
    do {                                                                                           \
        begin();                                                                                   \
        EXPECT_FAULT(call, name, fault, lines);                                                    \
    } while (0)
#define EXPECT_FAULT(call, name, fault, lines)                                                     \
    do {                                                                                           \
        call;                                                                                      \
        expect_fault(__LINE__, name, fault, lines);                                                \
    } while (0)

/// A trace with a header and two pixels, of which the second one is open.
static void begin(void) {
    rt_open(t, path);
    rt_header(t, 9, 9, "center");
    rt_pixel(t, 1, 2);
    rt_pixel(t, 2, 2);
}

static void too_early_or_too_late(void) {
    memset(t, 0, sizeof *t);
    remove(path);
    EXPECT_FAULT(rt_pixel(t, 1, 2), "rt_pixel", "rt_open before it", 0);
    rt_open(t, path);
    EXPECT_FAULT(rt_pixel(t, 1, 2), "rt_pixel", "rt_header before it", 0);
    rt_open(t, path);
    EXPECT_FAULT(rt_number(t, "left", 1), "rt_number \"left\"", "a step before it", 0);
    rt_open(t, path);
    EXPECT_FAULT(rt_end(t), "rt_end", "rt_header before it", 0);
    FAULT_IN_TRACE(rt_header(t, 9, 9, "center"), "rt_header", "it once, directly behind rt_open",
                   2);
    FAULT_IN_TRACE(rt_method(t, "fill", "fan"), "rt_method \"fill\"",
                   "it directly behind rt_header", 2);
    begin();
    rt_end(t);
    EXPECT_FAULT(rt_pixel(t, 1, 2), "rt_pixel", "it before the end", 4);
    begin();
    rt_end(t);
    EXPECT_FAULT(rt_text(t, "note", "late"), "rt_text \"note\"", "a step before it", 4);
    begin();
    rt_end(t);
    EXPECT_FAULT(rt_end(t), "rt_end", "it before the end", 4);
}

static void fields(void) {
    static const char* const texts[] = {"A", NULL};
    FAULT_IN_TRACE(rt_whole(t, "x", 1), "rt_whole \"x\"", "each field once", 2);
    begin();
    rt_text(t, "note", ",\"mine\":");
    rt_whole(t, "mine", 1); // what stands in a text is none
    EXPECT_FAULT(rt_flag(t, "mine", 1), "rt_flag \"mine\"", "each field once", 2);
    FAULT_IN_TRACE(rt_text(t, "step", "pixel"), "rt_text \"step\"", "each field once", 2);
    FAULT_IN_TRACE(rt_text(t, "", "A"), "rt_text", "a key that needs no escape", 2);
    FAULT_IN_TRACE(rt_text(t, "a\"b", "A"), "rt_text", "a key that needs no escape", 2);
    FAULT_IN_TRACE(rt_text(t, "edge", NULL), "rt_text \"edge\"", "a text, found NULL", 2);
    FAULT_IN_TRACE(rt_texts(t, "edges", texts, 2), "rt_texts \"edges\"", "texts, found NULL", 2);
    FAULT_IN_TRACE(rt_numbers(t, "at", NULL, 2), "rt_numbers \"at\"", "a list, found NULL", 2);
    FAULT_IN_TRACE(rt_whole(t, "n", 9007199254740992LL), "rt_whole",
                   "whole numbers within 9007199254740991", 2);
    FAULT_IN_TRACE(rt_pixel(t, 0, -9007199254740992LL), "rt_pixel",
                   "whole numbers within 9007199254740991", 3);
    FAULT_IN_TRACE(rt_color(t, 0, 256, 0, 255), "rt_color", "channels from 0 to 255", 2);
}

static void headers_and_names(void) {
    rt_open(t, path);
    EXPECT_FAULT(rt_header(t, 0, 9, "center"), "rt_header", "a canvas of 1 to 16384 pixels a side",
                 0);
    rt_open(t, path);
    EXPECT_FAULT(rt_header(t, 9, 9, "middle"), "rt_header",
                 "center, bottom-left or top-left as the origin", 0);
    rt_open(t, path);
    rt_header(t, 9, 9, "center");
    rt_method(t, "fill", "scanline");
    EXPECT_FAULT(rt_method(t, "fill", "fan"), "rt_method \"fill\"", "each field once", 0);
    rt_open(t, path);
    rt_header(t, 9, 9, "center");
    EXPECT_FAULT(rt_text(t, "canvas", "fan"), "rt_text \"canvas\"", "each field once", 0);
    FAULT_IN_TRACE(rt_primitive(t, "triangle", ""), "rt_primitive \"name\"", "a name", 3);
    FAULT_IN_TRACE(rt_skip(t, NULL, "culled"), "rt_skip \"name\"", "a name", 3);
    FAULT_IN_TRACE(rt_step(t, "scanline"), "rt_step \"scanline\"",
                   "the call of this kind, which has its fields", 2);
    FAULT_IN_TRACE(rt_step(t, NULL), "rt_step", "the name of a kind", 2);
}

/// Only the first fault is told, and what comes after it is not written, however much it is.
static void the_first_one_stays(void) {
    begin();
    const int line = __LINE__ + 1;
    rt_number(t, "x", 1);
    for (int i = 0; i < 100000; ++i) {
        rt_primitive(t, "triangle", "ABC");
        rt_number(t, "x", 1);
    }
    rt_header(t, 0, 0, "");
    expect_fault(line, "rt_number \"x\"", "each field once", 2);
}

int main(int count, char** arguments) {
    if (count < 2)
        return 2;
    snprintf(path, sizeof path, "%s/faults.jsonl", arguments[1]);
    too_early_or_too_late();
    fields();
    headers_and_names();
    the_first_one_stays();
    return failures;
}
