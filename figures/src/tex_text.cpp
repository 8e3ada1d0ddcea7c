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
    return fmt::format("{{\\fontsize{{8}}{{8}}\\selectfont U+{:04X}\\,}}",
                       static_cast<unsigned>(character));
}

} // namespace

std::string tex_escaped(std::string_view text, TexFont font) {
    const std::string shown = printable(text);
    std::string tex;
    bool was_blank = true; // TeX passes over blanks at the beginning, and over the second of two
    for (std::string_view rest = shown; !rest.empty();) {
        const CodePoint character = first_code_point(rest);
        const std::string_view bytes = rest.substr(0, character.length);
        rest.remove_prefix(character.length);
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
