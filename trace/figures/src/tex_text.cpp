// SPDX-License-Identifier: MIT
#include <rastertrace/figures/tikz.h>

#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <optional>

namespace rastertrace {

namespace {

/// A character and how LaTeX writes it, with fonts of the oldest encoding (OT1) and no package.
struct Spelling {
    char32_t character;
    std::string_view tex;
};

constexpr std::array spellings{
    Spelling{U'\\', "$\\backslash$"},
    Spelling{U'{', "$\\{$"},
    Spelling{U'}', "$\\}$"},
    Spelling{U'$', "$\\$$"},
    Spelling{U'&', "\\&"},
    Spelling{U'#', "\\#"},
    Spelling{U'^', "\\textasciicircum{}"},
    Spelling{U'_', "\\_"},
    Spelling{U'~', "\\textasciitilde{}"},
    Spelling{U'%', "\\%"},
    Spelling{U'<', "$<$"},
    Spelling{U'>', "$>$"},
    Spelling{U'|', "$|$"},
    // Only the font of fixed width has straight ones.
    Spelling{U'"', "{\\ttfamily\\char34}"},
    // Two of them, or one before another sign, would become one sign.
    Spelling{U'\'', "'{}"},
    Spelling{U'`', "`{}"},
    Spelling{U'-', "-{}"},
    Spelling{U',', ",{}"},
    Spelling{U'?', "?{}"},
    Spelling{U'!', "!{}"},
    Spelling{U'\u00A0', "\\nobreakspace{}"},
    Spelling{U'¡', "\\textexclamdown{}"},
    Spelling{U'¿', "\\textquestiondown{}"},
    Spelling{U'§', "$\\S$"},
    Spelling{U'ª', "\\textsuperscript{a}"},
    Spelling{U'º', "\\textsuperscript{o}"},
    Spelling{U'°', "$^\\circ$"},
    Spelling{U'¹', "$^1$"},
    Spelling{U'²', "$^2$"},
    Spelling{U'³', "$^3$"},
    Spelling{U'±', "$\\pm$"},
    Spelling{U'µ', "$\\mu$"},
    Spelling{U'·', "$\\cdot$"},
    Spelling{U'×', "$\\times$"},
    Spelling{U'÷', "$\\div$"},
    Spelling{U'½', "$\\frac12$"},
    Spelling{U'¼', "$\\frac14$"},
    Spelling{U'¾', "$\\frac34$"},
    Spelling{U'«', "$\\ll$"},
    Spelling{U'»', "$\\gg$"},
    Spelling{U'–', "\\textendash{}"},
    Spelling{U'—', "\\textemdash{}"},
    Spelling{U'‘', "\\textquoteleft{}"},
    Spelling{U'’', "\\textquoteright{}"},
    Spelling{U'“', "\\textquotedblleft{}"},
    Spelling{U'”', "\\textquotedblright{}"},
    Spelling{U'„', ",{},{}"},
    Spelling{U'•', "$\\bullet$"},
    Spelling{U'…', "\\dots{}"},
    Spelling{U'′', "$'$"},
    Spelling{U'π', "$\\pi$"},
    Spelling{U'Δ', "$\\Delta$"},
    Spelling{U'−', "$-$"},
    Spelling{U'→', "$\\rightarrow$"},
    Spelling{U'←', "$\\leftarrow$"},
    Spelling{U'↑', "$\\uparrow$"},
    Spelling{U'↓', "$\\downarrow$"},
    Spelling{U'≤', "$\\leq$"},
    Spelling{U'≥', "$\\geq$"},
    Spelling{U'≠', "$\\neq$"},
    Spelling{U'≈', "$\\approx$"},
    Spelling{U'√', "$\\surd$"},
    Spelling{U'∞', "$\\infty$"},
};

/// True for letters that every LaTeX since 2018 reads as UTF-8 and makes of letter and accent.
bool is_known_letter(char32_t c) {
    constexpr std::u32string_view not_in_ot1 = U"ÐÞðþ×÷";
    constexpr std::u32string_view others = U"ŒœŸı";
    return (U'À' <= c && c <= U'ÿ' && not_in_ot1.find(c) == std::u32string_view::npos) ||
           others.find(c) != std::u32string_view::npos;
}

std::optional<std::string_view> spelling_of(char32_t character) {
    const auto found =
        std::find_if(spellings.begin(), spellings.end(),
                     [character](const Spelling& one) { return one.character == character; });
    if (found == spellings.end())
        return std::nullopt;
    return found->tex;
}

/// As wide as the other letters of the font of fixed width: half of its em.
std::string in_one_column(std::string_view tex) {
    return fmt::format("\\makebox[0.5em]{{{}}}", tex);
}

std::string written(char32_t character, std::string_view bytes, TexFont font) {
    constexpr char32_t end_of_ascii = 0x80;
    const bool is_ascii = character < end_of_ascii;
    const auto spelling = spelling_of(character);
    if (font == TexFont::fixed_width && spelling) {
        // This font has all of ASCII, with the numbers of ASCII; but 39 and 96 are curved.
        if (is_ascii && character != U'\'' && character != U'`')
            return fmt::format("\\char{}{{}}", static_cast<unsigned>(character));
        return in_one_column(*spelling);
    }
    if (spelling)
        return std::string(*spelling);
    if (is_ascii || is_known_letter(character))
        return std::string(bytes);
    return fmt::format("{{\\scriptsize U+{:04X}\\,}}", static_cast<unsigned>(character));
}

bool is_digit(char c) {
    return '0' <= c && c <= '9';
}
bool is_capital(char c) {
    return 'A' <= c && c <= 'Z';
}
bool is_letter(char c) {
    return is_capital(c) || ('a' <= c && c <= 'z') || static_cast<unsigned char>(c) >= 0x80;
}

/// How many characters a text begins with that are all of a kind.
std::size_t length_of(std::string_view text, bool (*is_of_kind)(char)) {
    return static_cast<std::size_t>(std::find_if_not(text.begin(), text.end(), is_of_kind) -
                                    text.begin());
}

/// What a text begins with that is mathematics, and how it is set.
struct Mathematics {
    std::size_t length = 0; ///< 0: it begins with none
    std::string tex = {};
};

/// "25/8", but not "1/2/3"; and of a text with names "A", "ABC", "P1", "x".
Mathematics mathematics_in(std::string_view text, char before, TexFont font) {
    const std::size_t above = length_of(text, is_digit);
    if (above > 0 && above < text.size() && text[above] == '/' && !is_digit(before) &&
        !is_letter(before) && before != '/' && before != '.') {
        const std::size_t below = length_of(text.substr(above + 1), is_digit);
        const std::size_t length = above + 1 + below;
        const char after = length < text.size() ? text[length] : ' ';
        if (below > 0 && !is_letter(after) && after != '/' &&
            !(after == '.' && length + 1 < text.size() && is_digit(text[length + 1])))
            return {length, fmt::format("$\\frac{{{}}}{{{}}}$", text.substr(0, above),
                                        text.substr(above + 1, below))};
    }
    if (font != TexFont::with_names || is_letter(before) || is_digit(before))
        return {};
    constexpr std::size_t longest_name = 4;
    constexpr std::string_view coordinates = "xyzwdt";
    const std::size_t letters =
        coordinates.find(text.front()) != std::string_view::npos ? 1 : length_of(text, is_capital);
    const std::size_t digits = length_of(text.substr(letters), is_digit);
    const std::size_t length = letters + digits;
    if (letters == 0 || letters > longest_name || (length < text.size() && is_letter(text[length])))
        return {};
    return {length, digits == 0 ? fmt::format("${}$", text.substr(0, letters))
                                : fmt::format("${}_{{{}}}$", text.substr(0, letters),
                                              text.substr(letters, digits))};
}

} // namespace

std::string tex_escaped(std::string_view text, TexFont font) {
    const std::string shown = printable(text);
    std::string tex;
    bool was_blank = true; // TeX passes over blanks at the beginning, and over the second of two
    char before = ' ';
    for (std::string_view rest = shown; !rest.empty();) {
        if (const auto set = font == TexFont::fixed_width || font == TexFont::in_cell
                                 ? Mathematics()
                                 : mathematics_in(rest, before, font);
            set.length > 0) {
            tex += set.tex;
            before = rest[set.length - 1];
            rest.remove_prefix(set.length);
            was_blank = false;
            continue;
        }
        const CodePoint character = first_code_point(rest);
        const std::string_view bytes = rest.substr(0, character.length);
        rest.remove_prefix(character.length);
        const bool is_sign = bytes.size() > 1 && spelling_of(character.value);
        before = is_sign ? ' ' : bytes.front();
        const bool is_blank = character.value == U' ';
        if (is_blank)
            tex += was_blank || rest.empty() ? "\\ " : " ";
        else
            tex += written(character.value, bytes, font);
        was_blank = is_blank;
    }
    return tex;
}

} // namespace rastertrace
