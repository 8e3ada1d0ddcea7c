// SPDX-License-Identifier: MIT
#pragma once

// Writes the trace of a rasterizer of your own (docs/trace-format.md), in C99 or C++, with the standard C library alone:
//
//     struct rt_trace trace;
//     rt_open(&trace, "mine.jsonl");
//     rt_header(&trace, 17, 14, "center");     // or "bottom-left"; "top-left" if y points down
//     rt_method(&trace, "fill", "scanline");   // the rules that are known, or "convention", "opengl"
//     rt_primitive(&trace, "triangle", "ABC"); // a step
//     rt_texts(&trace, "vertices", names, 3);  // fields of the step before it: known ones, and your own
//     rt_rows(&trace, "at", corners, 3, 2);
//     rt_scanline(&trace, 2, -0.25, 3.125, -1, 3);
//     rt_pixel(&trace, -1, 2);
//     if (rt_end(&trace) != 0)
//         fprintf(stderr, "%s\n", rt_error(&trace));
//
// A step tells where in the code it was called: "code":"raster.cpp:120". Define RT_FILE before the include for another
// literal than __FILE__ there, RT_NO_CODE for none.
//
// The first fault (a wrong order, a field twice, a full disk) is kept for rt_error. Nothing more is written then, and no
// end record: readers take the steps before it, and see that the trace has broken off.
//
// NaN and infinities are recorded as "NaN", "inf" and "-inf", RT_NONE, where there is no number, as null. One thread
// writes a trace.

#include <errno.h>
#include <stdio.h>
#include <string.h>

// --- to call: t points to a struct rt_trace; texts are UTF-8 -------------------------------------

/// Begins a trace, in a file of that name or in one that is open, and stays so.
#define rt_open(t, name) rt_open_(RT_IN_(t, "rt_open"), name)
#define rt_open_file(t, file) rt_open_file_(RT_IN_(t, "rt_open_file"), file, 0)
/// The canvas. What else is told of the whole trace may follow: rt_text(t, "title", "Mine").
#define rt_header(t, width, height, origin)                                                        \
    rt_header_(RT_IN_(t, "rt_header"), width, height, origin)
/// A rule, one of `method` in the header. All of them stand side by side.
#define rt_method(t, key, value) rt_method_(RT_IN_(t, "rt_method"), RT_KEY_(key), value)
/// Ends a trace; 0 if all of it is in the file.
#define rt_end(t) rt_end_(RT_IN_(t, "rt_end"))

/// The steps of the format, each with the fields that it must have; and a step of a kind of your own.
#define rt_triangulate(t, name) RT_NAME_(RT_STEP_(t, triangulate), "name", name)
#define rt_matrix(t, name) RT_NAME_(RT_STEP_(t, matrix), "name", name)
#define rt_vertex(t, name, in) RT_NAME_(RT_NAME_(RT_STEP_(t, vertex), "name", name), "space", in)
#define rt_order(t) RT_STEP_(t, order)
#define rt_primitive(t, kind, name)                                                                \
    RT_NAME_(RT_NAME_(RT_STEP_(t, primitive), "kind", kind), "name", name)
#define rt_face(t, name, dot, culled)                                                              \
    RT_FLAG_(RT_NUMBER_(RT_NAME_(RT_STEP_(t, face), "name", name), "dot", dot), "culled", culled)
#define rt_light(t, name, intensity)                                                               \
    RT_NUMBER_(RT_NAME_(RT_STEP_(t, light), "name", name), "intensity", intensity)
#define rt_clip(t, name, plane) RT_NAME_(RT_NAME_(RT_STEP_(t, clip), "name", name), "plane", plane)
#define rt_edge(t, name) RT_NAME_(RT_STEP_(t, edge), "edge", name)
#define rt_half(t, which, from_y, to_y)                                                            \
    RT_WHOLE_(RT_WHOLE_(RT_NAME_(RT_STEP_(t, half), "half", which), "from_y", from_y), "to_y", to_y)
#define rt_ray(t, x, y) RT_XY_(RT_STEP_(t, ray), x, y)
#define rt_crossings(t, y) RT_WHOLE_(RT_STEP_(t, crossings), "y", y)
#define rt_scanline(t, y, left, right, from, to)                                                   \
    RT_WHOLE_(                                                                                     \
        RT_WHOLE_(RT_NUMBER_(RT_NUMBER_(RT_WHOLE_(RT_STEP_(t, scanline), "y", y), "left", left),   \
                             "right", right),                                                      \
                  "from", from),                                                                   \
        "to", to)
#define rt_along_x(t, x, value, pixel)                                                             \
    RT_WHOLE_(RT_NUMBER_(RT_WHOLE_(RT_STEP_(t, along), "x", x), "value", value), "pixel", pixel)
#define rt_along_y(t, y, value, pixel)                                                             \
    RT_WHOLE_(RT_NUMBER_(RT_WHOLE_(RT_STEP_(t, along), "y", y), "value", value), "pixel", pixel)
#define rt_decide(t, x, y, d, move)                                                                \
    RT_NAME_(RT_NUMBER_(RT_XY_(RT_STEP_(t, decide), x, y), "d", d), "move", move)
#define rt_sample(t, x, y, inside) RT_FLAG_(RT_XY_(RT_STEP_(t, sample), x, y), "inside", inside)
#define rt_depth(t, x, y, z, stored, pass)                                                         \
    RT_FLAG_(                                                                                      \
        RT_NUMBER_(RT_NUMBER_(RT_XY_(RT_STEP_(t, depth), x, y), "depth", z), "stored", stored),    \
        "pass", pass)
#define rt_pixel(t, x, y) RT_XY_(RT_STEP_(t, pixel), x, y)
#define rt_reject(t, why) RT_NAME_(RT_STEP_(t, reject), "why", why)
#define rt_skip(t, name, why) RT_NAME_(RT_NAME_(RT_STEP_(t, skip), "name", name), "why", why)
#define rt_undecided(t) RT_STEP_(t, undecided)
#define rt_step(t, kind) rt_own_step_(RT_IN_(t, "rt_step"), kind)

/// A field of the line before it: a whole number within 2^53 - 1, a number, a text, true or false; its `color`, channels
/// from 0 to 255. Keys are literals that need no escape.
#define rt_whole(t, key, value) rt_whole_(RT_IN_(t, "rt_whole"), RT_KEY_(key), value)
#define rt_number(t, key, value) rt_number_(RT_IN_(t, "rt_number"), RT_KEY_(key), value)
#define rt_text(t, key, value) rt_text_(RT_IN_(t, "rt_text"), RT_KEY_(key), value)
#define rt_flag(t, key, value) rt_flag_(RT_IN_(t, "rt_flag"), RT_KEY_(key), value)
#define rt_color(t, red, green, blue, alpha)                                                       \
    rt_color_(RT_IN_(t, "rt_color"), red, green, blue, alpha)
/// A list: of double[count], const char*[count] or int[count]; of rows, double[rows * columns].
#define rt_numbers(t, key, values, count)                                                          \
    rt_numbers_(RT_IN_(t, "rt_numbers"), RT_KEY_(key), values, count)
#define rt_texts(t, key, values, count)                                                            \
    rt_texts_(RT_IN_(t, "rt_texts"), RT_KEY_(key), values, count)
#define rt_flags(t, key, values, count)                                                            \
    rt_flags_(RT_IN_(t, "rt_flags"), RT_KEY_(key), values, count)
#define rt_rows(t, key, values, rows, columns)                                                     \
    rt_rows_(RT_IN_(t, "rt_rows"), RT_KEY_(key), values, rows, columns)
/// No number: `stored` where nothing was, `dx_dy` of a horizontal edge.
#define RT_NONE rt_none_()

// --- how it is done ------------------------------------------------------------------------------

#ifndef RT_FILE
#define RT_FILE __FILE__
#endif
#define RT_ZEROS_ "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"
#define RT_LITERAL_(tokens) #tokens
#define RT_LITERAL_OF_(macro) RT_LITERAL_(macro)
#ifdef RT_NO_CODE
#define RT_IN_(t, call) rt_in_(t, call, RT_ZEROS_)
#else
#define RT_IN_(t, call) rt_in_(t, call, RT_FILE ":" RT_LITERAL_OF_(__LINE__) RT_ZEROS_)
#endif
/// A function that is out of the way of what is called often; and one that is, where the sizes of literals are known only
/// if it is inlined, which clang does by half.
#ifdef __GNUC__
#define RT_SELDOM_ static __attribute__((noinline, cold, unused))
#define RT_OFTEN_ static inline __attribute__((always_inline))
#else
#define RT_SELDOM_ static inline
#define RT_OFTEN_ static inline
#endif
#ifdef __cplusplus
#define RT_NULL_ nullptr
#define RT_CAST_(type, value) static_cast<type>(value)
#else
#define RT_NULL_ NULL
#define RT_CAST_(type, value) ((type)(value))
#endif

#define RT_BYTES_(literal) literal, sizeof(literal) - 1
/// What stands in front of a value, ,"left": and its size; no size where the key would need an escape.
#define RT_KEY_(key)                                                                               \
    ",\"" key "\":", *key == '\0' || strpbrk(key, "\"\\") != RT_NULL_ ? 0 : sizeof(key) + 3
/// A step, with its first fields one around the other.
#define RT_STEP_(t, kind)                                                                          \
    rt_step_(RT_IN_(t, "rt_" #kind), rt_kind_##kind##_, RT_BYTES_("{\"step\":\"" #kind "\""))
#define RT_WHOLE_(t, key, value) rt_whole_(t, RT_BYTES_(",\"" key "\":"), value)
#define RT_NUMBER_(t, key, value) rt_number_(t, RT_BYTES_(",\"" key "\":"), value)
#define RT_FLAG_(t, key, value) rt_flag_(t, RT_BYTES_(",\"" key "\":"), value)
#define RT_NAME_(t, key, name) rt_name_(t, RT_BYTES_(",\"" key "\":"), name)
#define RT_XY_(t, x, y) RT_WHOLE_(RT_WHOLE_(t, "x", x), "y", y)

enum {
    RT_BUFFER_ = 65536, ///< bytes that are written at once
    RT_ROOM_ = 512,     ///< for what is appended at once: the first fields of a step, a key
    RT_CODE_ = 32       ///< zeros behind a place in the code
};

// clang-format off
#define RT_EACH_KIND_(X)                                                                           \
    X(triangulate) X(matrix) X(vertex) X(order) X(primitive) X(face) X(light) X(clip) X(edge)      \
    X(half) X(ray) X(crossings) X(scanline) X(along) X(decide) X(sample) X(depth) X(pixel)         \
    X(reject) X(skip) X(undecided)
#define RT_KIND_(kind) rt_kind_##kind##_,
enum { RT_EACH_KIND_(RT_KIND_) rt_kind_own_, rt_kinds_ };
// clang-format on

enum rt_state_ {
    RT_NEW_,    ///< a struct of zeros
    RT_FILE_,   ///< a trace without its header yet
    RT_HEADER_, ///< the header's line is open
    RT_METHOD_, ///< the same, in its `method`
    RT_OPEN_,   ///< a step's line is open
    RT_LINES_,  ///< no line is open
    RT_ENDED_,
    RT_FAILED_
};

struct rt_trace {
    FILE* file;
    int owns_file;
    enum rt_state_ state;
    const char *call, *code; ///< the last call, and its place in the code
    const char* step_code;   ///< that of the open step
    size_t code_size, step_code_size;
    size_t start, used; ///< of the buffer: where the open line begins, where the next byte goes
    unsigned long long keys; ///< of the open line: a bit for each of its fields, see rt_bit_
    long long counts[rt_kinds_];
    char error[256];
    char buffer[RT_BUFFER_ + 2 * RT_ROOM_]; ///< behind a fault, what is told goes to its end
};

/// Notes a call. Compilers know the result of strrchr and strlen for a literal.
RT_OFTEN_ struct rt_trace* rt_in_(struct rt_trace* t, const char* call, const char* code) {
    const char* base = strrchr(code, '/');
    code = base != RT_NULL_ ? base + 1 : code;
    base = strrchr(code, '\\');
    t->call = call;
    t->code = base != RT_NULL_ ? base + 1 : code;
    t->code_size =
        strlen(t->code) > RT_ROOM_ / 2 || strchr(t->code, '"') != RT_NULL_ ? 0 : strlen(t->code);
    return t;
}

/// Keeps the first fault: rt_number "left" in raster.cpp:120: expected a step before it
RT_SELDOM_ int rt_fail_(struct rt_trace* t, const char* name, const char* what) {
    const char* const quote = name != RT_NULL_ ? "\"" : "";
    if (t->state != RT_FAILED_)
        snprintf(t->error, sizeof t->error, "%s%s%s%.40s%s%s%.60s: %.100s", t->call,
                 name != RT_NULL_ ? " " : "", quote, name != RT_NULL_ ? name : "", quote,
                 t->code_size > 0 ? " in " : "", t->code, what);
    t->state = RT_FAILED_;
    return 0;
}

RT_SELDOM_ int rt_fail_by_system_(struct rt_trace* t, const char* what) {
    char text[100];
    snprintf(text, sizeof text, "%.40s: %.50s", what, strerror(errno));
    return rt_fail_(t, RT_NULL_, text);
}

/// The first fault, "" if there was none.
static inline const char* rt_error(const struct rt_trace* t) {
    return t->error;
}

/// Writes the whole lines, or what there is of a line that is longer than the buffer.
RT_SELDOM_ void rt_flush_(struct rt_trace* t) {
    const size_t size = t->start > 0 ? t->start : t->used;
    if (t->state == RT_FAILED_ || size == 0)
        return;
    if (fwrite(t->buffer, 1, size, t->file) != size)
        rt_fail_by_system_(t, "the file cannot be written");
    memmove(t->buffer, t->buffer + size, t->used - size);
    t->used -= size;
    t->start = 0;
}

RT_OFTEN_ char* rt_put_(char* out, const char* bytes, size_t size) {
    memcpy(out, bytes, size);
    return out + size;
}

RT_OFTEN_ void rt_set_end_(struct rt_trace* t, const char* end) {
    t->used = RT_CAST_(size_t, end - t->buffer);
}

RT_OFTEN_ void rt_append_(struct rt_trace* t, const char* bytes, size_t size) {
    rt_set_end_(t, rt_put_(t->buffer + t->used, bytes, size));
}

/// Makes room for RT_ROOM_ bytes. Behind a fault, the open line is given up.
RT_OFTEN_ void rt_room_(struct rt_trace* t) {
    while (t->used > RT_BUFFER_ - RT_ROOM_ && t->state != RT_FAILED_)
        rt_flush_(t);
    if (t->used > RT_BUFFER_ - RT_ROOM_)
        t->used = t->start;
}

static inline void rt_append_literal_(struct rt_trace* t, const char* literal) {
    rt_append_(t, literal, strlen(literal));
}

static inline char* rt_put_pair_(char* out, unsigned pair) {
    out[0] = RT_CAST_(char, '0' + pair / 10);
    out[1] = RT_CAST_(char, '0' + pair % 10);
    return out + 2;
}

/// All digits, two at a time.
RT_SELDOM_ char* rt_put_long_(char* out, unsigned long long value) {
    if (value < 10) {
        *out++ = RT_CAST_(char, '0' + value);
        return out;
    }
    return rt_put_pair_(value < 100 ? out : rt_put_long_(out, value / 100),
                        RT_CAST_(unsigned, value % 100));
}

/// The same, of nearly all indices four at most.
RT_OFTEN_ char* rt_put_digits_(char* out, unsigned long long value) {
    const unsigned number = RT_CAST_(unsigned, value);
    if (value >= 10000)
        return rt_put_long_(out, value);
    if (number >= 1000)
        out = rt_put_pair_(out, number / 100);
    else if (number >= 100)
        *out++ = RT_CAST_(char, '0' + number / 100);
    else if (number < 10) {
        *out++ = RT_CAST_(char, '0' + number);
        return out;
    }
    return rt_put_pair_(out, number % 100);
}

RT_OFTEN_ void rt_append_whole_(struct rt_trace* t, long long value) {
    const unsigned long long magnitude =
        RT_CAST_(unsigned long long, value < 0 ? -(value + 1) : value) + (value < 0);
    char* out = t->buffer + t->used;
    if (magnitude > 9007199254740991ULL)
        rt_fail_(t, RT_NULL_, "expected whole numbers within 9007199254740991");
    if (value < 0)
        *out++ = '-';
    rt_set_end_(t, rt_put_digits_(out, magnitude));
}

#define RT_NONE_BITS_ 0x7ff8000072746e6fULL ///< a NaN that no arithmetic gives

static inline double rt_none_(void) {
    const unsigned long long bits = RT_NONE_BITS_;
    double value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

/// By the C library, whose decimal point may be a comma, or several bytes.
RT_SELDOM_ char* rt_put_printed_(char* out, double value) {
    char text[40];
    const char* c = text;
    snprintf(text, sizeof text, "%.17g", value);
    for (; *c != '\0'; ++c)
        if ((*c >= '0' && *c <= '9') || *c == '-' || *c == '+' || *c == 'e')
            *out++ = *c;
        else if (out[-1] != '.')
            *out++ = '.';
    return out;
}

/// A finite number that reads back to the same bits: all digits of one that is whole or k/1024, else 17.
static inline char* rt_put_finite_(char* out, double value, unsigned long long bits) {
    // It is mantissa / 2^places. Ten times what is behind the point must fit into 64 bits.
    unsigned long long mantissa = (bits & 0xfffffffffffffULL) | 0x10000000000000ULL;
    int places = 1075 - RT_CAST_(int, bits >> 52 & 0x7ff);
    for (; places > 60 && mantissa % 2 == 0; --places)
        mantissa /= 2;
    if (places < 0 || places > 60)
        return rt_put_printed_(out, value);
    if (bits >> 63)
        *out++ = '-';
    const char* const first = out;
    out = rt_put_digits_(out, mantissa >> places);
    const unsigned long long below_point = (1ULL << places) - 1;
    unsigned long long rest = mantissa & below_point;
    if (rest == 0)
        return out;

    // Of k/1024 ten digits at once. Else digit by digit, until nothing is left or there are 17, from the first that is
    // not 0.
    *out++ = '.';
    if (places >= 10 && (rest << 10 & below_point) == 0) {
        unsigned k = RT_CAST_(unsigned, rest >> (places - 10));
        for (int i = 0; i < 10; i += 2, k = k * 100 % 1024)
            rt_put_pair_(out + i, k * 100 / 1024);
        out += 10;
        rest = 0;
    } else {
        int digits = *first == '0' ? 0 : RT_CAST_(int, out - 1 - first);
        do {
            rest *= 10;
            *out = RT_CAST_(char, '0' + RT_CAST_(int, rest >> places));
            rest &= below_point;
            digits += digits > 0 || *out != '0';
            ++out;
        } while (rest != 0 && digits < 17);
    }

    // The last digit is rounded, a half to even. It never comes to a whole number: that is another double.
    if (rest * 2 > below_point + (out[-1] % 2 == 0)) {
        while (out[-1] == '9')
            --out;
        ++out[-1];
    }
    while (out[-1] == '0')
        --out;
    return out;
}

/// What a number is, its bits tell, whatever a compiler takes for granted about NaN.
static inline void rt_append_number_(struct rt_trace* t, double value) {
    unsigned long long bits;
    memcpy(&bits, &value, sizeof bits);
    if (bits << 1 == 0)
        rt_append_literal_(t, "0"); // -0, too
    else if ((bits >> 52 & 0x7ff) != 0x7ff)
        rt_set_end_(t, rt_put_finite_(t->buffer + t->used, value, bits));
    else if (bits == RT_NONE_BITS_)
        rt_append_literal_(t, "null");
    else if (bits << 12 != 0)
        rt_append_literal_(t, "\"NaN\"");
    else
        rt_append_literal_(t, bits >> 63 ? "\"-inf\"" : "\"inf\"");
}

/// How many bytes a character of UTF-8 has, 0 if it is none.
static inline size_t rt_utf8_size_(const char* text) {
    const unsigned char lead = RT_CAST_(unsigned char, text[0]);
    const size_t size = lead < 0x80   ? 1
                        : lead < 0xc2 ? 0
                        : lead < 0xe0 ? 2
                        : lead < 0xf0 ? 3
                        : lead < 0xf5 ? 4
                                      : 0;
    // The second byte: nothing that has a shorter form, no surrogate, nothing beyond U+10FFFF.
    const unsigned char least = lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80;
    const unsigned char most = lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
    for (size_t i = 1; i < size; ++i) {
        const unsigned char next = RT_CAST_(unsigned char, text[i]);
        if (next < (i == 1 ? least : 0x80) || next > (i == 1 ? most : 0xbf))
            return 0;
    }
    return size;
}

/// A text in quotation marks. What is no UTF-8 becomes U+FFFD.
static inline void rt_append_text_(struct rt_trace* t, const char* text) {
    const char* const end = t->buffer + RT_BUFFER_ - 8;
    rt_append_(t, "\"", 1);
    while (*text != '\0') {
        char* out = t->buffer + t->used;
        while (out < end && *text >= 0x20 && *text < 0x7f && *text != '"' && *text != '\\')
            *out++ = *text++;
        if (*text != '\0' && out < end) {
            const unsigned code = RT_CAST_(unsigned char, *text);
            const size_t size = rt_utf8_size_(text);
            if (code == '"' || code == '\\')
                *out++ = '\\';
            if (size == 0 || code < 0x20 || code == 0x7f)
                out += snprintf(out, 8, "\\u%04x", size == 0 ? 0xfffdu : code);
            else
                out = rt_put_(out, text, size);
            text += size == 0 ? 1 : size;
        }
        rt_set_end_(t, out);
        if (out >= end)
            rt_room_(t);
    }
    rt_append_(t, "\"", 1);
}

/// Ends the line of a step.
RT_OFTEN_ void rt_end_step_(struct rt_trace* t) {
    rt_room_(t);
    char* out = t->buffer + t->used;
    if (t->step_code_size > 0) {
        out = rt_put_(out, RT_BYTES_(",\"code\":\""));
        memcpy(out, t->step_code, RT_CODE_); // at once, with zeros behind it
        if (t->step_code_size > RT_CODE_)
            memcpy(out, t->step_code, t->step_code_size);
        out += t->step_code_size;
        *out++ = '"';
    }
    rt_set_end_(t, rt_put_(out, RT_BYTES_("}\n")));
    t->start = t->used;
}

/// Ends the line that is open, whatever it is. False, with a fault, where no line may follow.
RT_SELDOM_ int rt_end_line_(struct rt_trace* t) {
    rt_room_(t);
    if (t->state == RT_NEW_)
        rt_fail_(t, RT_NULL_, "expected rt_open before it");
    else if (t->state == RT_FILE_)
        rt_fail_(t, RT_NULL_, "expected rt_header before it");
    else if (t->state == RT_ENDED_)
        rt_fail_(t, RT_NULL_, "expected it before the end");
    else if (t->state == RT_OPEN_)
        rt_end_step_(t);
    else if (t->state == RT_HEADER_ || t->state == RT_METHOD_)
        rt_append_literal_(t, t->state == RT_METHOD_ ? "}}\n" : "}\n");
    if (t->state == RT_FAILED_)
        return 0;
    t->start = t->used;
    t->state = RT_LINES_;
    return 1;
}

/// One of 64 bits for a field. Two of a kind in the format have none in common: nothing has to be looked for.
RT_OFTEN_ unsigned long long rt_bit_(const char* front, size_t size) {
    return 1ULL << (RT_CAST_(unsigned, front[2] + 9 * front[size - 3] + 5 * RT_CAST_(int, size)) %
                    64);
}

/// Begins a step. Behind a fault, it is told to a place that nobody reads.
RT_OFTEN_ struct rt_trace* rt_step_(struct rt_trace* t, int kind, const char* front, size_t size) {
    if (t->state == RT_OPEN_)
        rt_end_step_(t);
    else
        rt_end_line_(t);
    rt_room_(t);
    if (t->state == RT_FAILED_)
        t->used = t->start;
    else
        t->state = RT_OPEN_;
    t->step_code = t->code;
    t->step_code_size = t->code_size;
    t->keys = rt_bit_(RT_BYTES_(",\"step\":"));
    ++t->counts[kind];
    rt_append_(t, front, size);
    return t;
}

/// True if the open line has that field.
RT_SELDOM_ int rt_has_field_(const struct rt_trace* t, const char* key, size_t size) {
    // A key stands behind a brace or a comma; within a text, a quotation mark stands behind a backslash.
    const char* at = t->buffer + t->start;
    for (; at + size < t->buffer + t->used; ++at)
        if ((*at == ',' || *at == '{') && memcmp(at + 1, key, size) == 0)
            return 1;
    return 0;
}

/// Keeps a fault of a field, by what stands in front of its value.
RT_SELDOM_ int rt_fail_at_(struct rt_trace* t, const char* front, size_t size, const char* what) {
    char key[64];
    if (t->state == RT_FAILED_)
        return 0;
    snprintf(key, sizeof key, "%.*s", size < 64 ? RT_CAST_(int, size) - 4 : 60, front + 2);
    return rt_fail_(t, size > 4 ? key : RT_NULL_, what);
}

/// Begins a field.
RT_OFTEN_ int rt_key_(struct rt_trace* t, const char* front, size_t size) {
    unsigned long long bit;
    if (t->state != RT_OPEN_ && t->state != RT_HEADER_) {
        if (t->state != RT_METHOD_)
            return rt_fail_at_(t, front, size, "expected a step before it");
        rt_append_(t, "}", 1);
        t->state = RT_HEADER_;
    }
    if (size < 5 || size > RT_ROOM_ / 2)
        return rt_fail_at_(t, front, size, "expected a key that needs no escape");
    rt_room_(t);
    bit = rt_bit_(front, size);
    if ((t->keys & bit) != 0 && rt_has_field_(t, front + 1, size - 1))
        return rt_fail_at_(t, front, size, "expected each field once");
    t->keys |= bit;
    rt_append_(t, front, size);
    return 1;
}

RT_OFTEN_ struct rt_trace* rt_whole_(struct rt_trace* t, const char* front, size_t size,
                                     long long value) {
    if (rt_key_(t, front, size))
        rt_append_whole_(t, value);
    return t;
}

RT_OFTEN_ struct rt_trace* rt_number_(struct rt_trace* t, const char* front, size_t size,
                                      double value) {
    if (rt_key_(t, front, size))
        rt_append_number_(t, value);
    return t;
}

RT_OFTEN_ struct rt_trace* rt_flag_(struct rt_trace* t, const char* front, size_t size, int value) {
    if (rt_key_(t, front, size))
        rt_append_literal_(t, value ? "true" : "false");
    return t;
}

static inline void rt_text_(struct rt_trace* t, const char* front, size_t size, const char* value) {
    if (value == RT_NULL_)
        rt_fail_at_(t, front, size, "expected a text, found NULL");
    else if (rt_key_(t, front, size)) {
        if (size == 8 && memcmp(front, ",\"code\":", 8) == 0)
            t->step_code_size = 0; // it is the step's
        rt_append_text_(t, value);
    }
}

static inline struct rt_trace* rt_name_(struct rt_trace* t, const char* front, size_t size,
                                        const char* name) {
    if (name == RT_NULL_ || *name == '\0')
        rt_fail_at_(t, front, size, "expected a name");
    rt_text_(t, front, size, name);
    return t;
}

static inline void rt_color_(struct rt_trace* t, int red, int green, int blue, int alpha) {
    char text[12];
    if (((red | green | blue | alpha) & ~255) != 0)
        rt_fail_(t, RT_NULL_, "expected channels from 0 to 255");
    snprintf(text, sizeof text, "#%02x%02x%02x%02x", red & 255, green & 255, blue & 255,
             alpha & 255);
    text[alpha == 255 ? 7 : 9] = '\0';
    rt_text_(t, RT_BYTES_(",\"color\":"), text);
}

static inline void rt_own_step_(struct rt_trace* t, const char* kind) {
#define RT_IS_(name) || strcmp(kind, #name) == 0
    if (kind == RT_NULL_ || *kind == '\0')
        rt_fail_(t, RT_NULL_, "expected the name of a kind");
    else if (0 RT_EACH_KIND_(RT_IS_))
        rt_fail_(t, kind, "expected the call of this kind, which has its fields");
    else
        rt_append_text_(rt_step_(t, rt_kind_own_, RT_BYTES_("{\"step\":")), kind);
}

/// A list of doubles ('d'), texts ('t') or truths ('i'); if columns > 0, of rows of so many.
static inline void rt_list_(struct rt_trace* t, const char* front, size_t size, char type,
                            const void* values, size_t count, size_t columns) {
    const int has_rows = columns > 0 && count > 0;
    if (values == RT_NULL_ && count > 0)
        rt_fail_at_(t, front, size, "expected a list, found NULL");
    if (!rt_key_(t, front, size))
        return;
    rt_append_literal_(t, has_rows ? "[[" : "[");
    for (size_t i = 0; i < count; ++i) {
        const char* const text = type == 't' ? RT_CAST_(const char* const*, values)[i] : "";
        rt_room_(t);
        if (i > 0)
            rt_append_literal_(t, has_rows && i % columns == 0 ? "],[" : ",");
        if (text == RT_NULL_)
            rt_fail_at_(t, front, size, "expected texts, found NULL");
        else if (type == 't')
            rt_append_text_(t, text);
        else if (type == 'd')
            rt_append_number_(t, RT_CAST_(const double*, values)[i]);
        else
            rt_append_literal_(t, RT_CAST_(const int*, values)[i] ? "true" : "false");
    }
    rt_append_literal_(t, has_rows ? "]]" : "]");
}

static inline void rt_numbers_(struct rt_trace* t, const char* front, size_t size,
                               const double* values, size_t count) {
    rt_list_(t, front, size, 'd', values, count, 0);
}

static inline void rt_texts_(struct rt_trace* t, const char* front, size_t size,
                             const char* const* values, size_t count) {
    rt_list_(t, front, size, 't', values, count, 0);
}

static inline void rt_flags_(struct rt_trace* t, const char* front, size_t size, const int* values,
                             size_t count) {
    rt_list_(t, front, size, 'i', values, count, 0);
}

static inline void rt_rows_(struct rt_trace* t, const char* front, size_t size,
                            const double* values, size_t rows, size_t columns) {
    rt_list_(t, front, size, 'd', values, rows * columns, columns);
}

static inline void rt_open_file_(struct rt_trace* t, FILE* file, int is_owned) {
    const char *const call = t->call, *const code = t->code;
    memset(t, 0, sizeof *t);
    rt_in_(t, call, code);
    t->file = file;
    t->owns_file = is_owned;
    t->state = RT_FILE_;
    if (file == RT_NULL_)
        rt_fail_by_system_(t, "expected a file");
}

static inline void rt_open_(struct rt_trace* t, const char* name) {
    rt_open_file_(t, name != RT_NULL_ ? fopen(name, "wb") : RT_NULL_, 1);
}

static inline void rt_header_(struct rt_trace* t, int width, int height, const char* origin) {
    char size[80];
    if (t->state != RT_FILE_)
        rt_fail_(t, RT_NULL_, "expected it once, directly behind rt_open");
    if (width < 1 || height < 1 || width > 16384 || height > 16384)
        rt_fail_(t, RT_NULL_, "expected a canvas of 1 to 16384 pixels a side");
    if (origin == RT_NULL_ ||
        (strcmp(origin, "center") != 0 && strcmp(origin, "bottom-left") != 0 &&
         strcmp(origin, "top-left") != 0))
        rt_fail_(t, RT_NULL_, "expected center, bottom-left or top-left as the origin");
    if (t->state == RT_FAILED_)
        return;
    snprintf(size, sizeof size,
             "{\"rastertrace\":1,\"canvas\":{\"width\":%d,\"height\":%d,\"origin\":", width,
             height);
    rt_append_literal_(t, size);
    rt_append_text_(t, origin);
    rt_append_(t, "}", 1);
    t->keys = ~0ULL;
    t->state = RT_HEADER_;
}

static inline void rt_method_(struct rt_trace* t, const char* front, size_t size,
                              const char* value) {
    const int is_first = t->state == RT_HEADER_;
    if (t->state != RT_HEADER_ && t->state != RT_METHOD_)
        rt_fail_at_(t, front, size, "expected it directly behind rt_header");
    else if (value == RT_NULL_)
        rt_fail_at_(t, front, size, "expected a text, found NULL");
    else
        t->state = RT_HEADER_;
    if (is_first && rt_key_(t, RT_BYTES_(",\"method\":")))
        rt_append_(t, "{", 1);
    if (!rt_key_(t, front, size))
        return;
    if (is_first) { // no comma
        memmove(t->buffer + t->used - size, t->buffer + t->used - size + 1, size - 1);
        --t->used;
    }
    rt_append_text_(t, value);
    t->state = RT_METHOD_;
}

static inline int rt_end_(struct rt_trace* t) {
#define RT_KIND_NAME_(kind) #kind,
    static const char* const names[] = {RT_EACH_KIND_(RT_KIND_NAME_) RT_NULL_};
    if (rt_end_line_(t)) {
        const char* separator = "{";
        long long steps = 0;
        for (int kind = 0; kind < rt_kinds_; ++kind)
            steps += t->counts[kind];
        rt_append_literal_(t, "{\"end\":{\"steps\":");
        rt_append_whole_(t, steps);
        rt_append_literal_(t, ",\"count\":");
        for (int kind = 0; kind < rt_kind_own_; ++kind)
            if (t->counts[kind] > 0) {
                rt_append_literal_(t, separator);
                rt_append_text_(t, names[kind]);
                rt_append_(t, ":", 1);
                rt_append_whole_(t, t->counts[kind]);
                separator = ",";
            }
        rt_append_literal_(t, *separator == '{' ? "{}}}\n" : "}}}\n");
        t->start = t->used;
        rt_flush_(t);
    } else if (t->file != RT_NULL_) {
        fwrite(t->buffer, 1, t->start, t->file); // the steps before the fault
    }
    if (t->file != RT_NULL_ && (t->owns_file ? fclose(t->file) : fflush(t->file)) != 0)
        rt_fail_by_system_(t, "the file cannot be written");
    t->file = RT_NULL_;
    if (t->state != RT_FAILED_)
        t->state = RT_ENDED_;
    return t->state == RT_FAILED_;
}
