// SPDX-License-Identifier: MIT
#include "language.h"

#include "named_value.h"

#include <algorithm>
#include <array>
#include <atomic>

namespace rastertrace {

namespace {

constexpr std::array<std::string_view, language_count> codes{"en", "pt"};

std::atomic<Language> language_in_use{Language::english};

/// A word of traces, and how it is told: in English as it stands, where nothing else is said.
struct TraceWord {
    std::string_view word;
    Words told;

    constexpr TraceWord(std::string_view english, std::string_view portuguese)
        : word(english), told(english, portuguese) {}
    constexpr TraceWord(std::string_view word_of_traces, Words told_as)
        : word(word_of_traces), told(told_as) {}
};

/// The words that traces have for kinds of primitives, matrices, spaces, planes, halves and reasons, and those of
/// explain.h for what kept a primitive from a pixel.
constexpr TraceWord words_of_traces[] = {
    {"point", "ponto"},
    {"line", "segmento"},
    {"outline", "contorno"},
    {"circle", "circunferência"},
    {"polygon", "polígono"},
    {"triangle", "triângulo"},
    {"primitive", "elemento"},

    {"model", "modelo"},
    {"view", "visão"},
    {"projection", "projeção"},
    {"viewport", "viewport"},

    {"object", "do objeto"},
    {"world", "do mundo"},
    {"camera", "da câmera"},
    {"clip", "de recorte"},
    {"canonical", "canônico"},
    {"screen", "da tela"},

    {"near", "próximo"},
    {"far", "distante"},
    {"left", "esquerdo"},
    {"right", "direito"},
    {"bottom", "inferior"},
    {"top", "superior"},

    {"lower", "inferior"},
    {"upper", "superior"},

    {"off-canvas", "fora da tela"},
    {"off canvas", "fora da tela"},
    {"zero area", "área zero"},
    {"culled", "eliminado pela orientação"},
    // Or beside it: w = 0.
    {"behind the eye", Words("not in front of the eye", "não está à frente do olho")},
    {"too near", "perto demais"},
    {"too far", "longe demais"},
    {"outside the view", "fora da vista"},
    {"its only pixel is its last, which is left out",
     "seu único pixel é o último, que não é desenhado"},
    {"between rows", "entre as linhas"},
    {"it leaves no diamond", "não sai de nenhum losango"},

    {"outside", "fora"},
    {"elsewhere", "em outro lugar"},
    {"hidden", "escondido"},
    {"clipped", "recortado"},
    {"skipped", "omitido"},
    {"unpainted", "não pintado"},
    {"rejected", "descartado"},
    {"unknown", "desconhecido"},
};

} // namespace

std::vector<std::string_view> language_codes() {
    return {codes.begin(), codes.end()};
}

std::string_view code_of(Language language) {
    return codes[static_cast<std::size_t>(language)];
}

std::optional<Language> language_with_code(std::string_view code) {
    return value_named<Language>(codes, code);
}

Language language_of_steps() {
    return language_in_use;
}

void tell_steps_in(Language language) {
    language_in_use = language;
}

std::string_view in_language_of_steps(std::string_view word) {
    const auto* const found =
        std::find_if(std::begin(words_of_traces), std::end(words_of_traces),
                     [word](const TraceWord& known) { return known.word == word; });
    return found == std::end(words_of_traces) ? word : found->told.in(language_of_steps());
}

} // namespace rastertrace
