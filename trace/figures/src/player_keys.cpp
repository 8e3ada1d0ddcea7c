// SPDX-License-Identifier: MIT
#include <rastertrace/figures/player_keys.h>

#include <algorithm>
#include <array>

namespace rastertrace {

namespace {

using enum PlayerAction;

// clang-format off
const std::array table = std::to_array<PlayerKey>({
    {next, "next", {"Right", "l"}, {"the next step", "o próximo passo"}, true},
    {previous, "previous", {"Left", "h"}, {"the previous step", "o passo anterior"}, true},
    {next_row, "next-row", {"Down", "j"}, {"the next row that begins: a scanline, an along, decide or ray step",
     "a próxima linha que começa: um passo scanline, along, decide ou ray"}, true},
    {previous_row, "previous-row", {"Up", "k"}, {"the previous row", "a linha anterior"}, true},
    {next_of_kind, "next-of-kind", {"]"}, {"the next step of the same kind", "o próximo passo do mesmo tipo"}, true},
    {previous_of_kind, "previous-of-kind", {"["}, {"the previous step of the same kind", "o passo anterior do mesmo tipo"}, true},
    {next_of_primitive, "next-of-primitive", {")"}, {"the next step about the same primitive", "o próximo passo sobre a mesma primitiva"}, true},
    {previous_of_primitive, "previous-of-primitive", {"("}, {"the previous step about the same primitive", "o passo anterior sobre a mesma primitiva"}, true},
    {next_primitive, "next-primitive", {"}", "PageDown"}, {"the next primitive that begins", "a próxima primitiva que começa"}, true},
    {previous_primitive, "previous-primitive", {"{", "PageUp"}, {"the previous primitive", "a primitiva anterior"}, true},
    {next_at_cursor, "next-at-cursor", {"."}, {"the next step that touches the cursor's pixel", "o próximo passo que toca o pixel do cursor"}, true},
    {previous_at_cursor, "previous-at-cursor", {","}, {"the previous step that touches it", "o passo anterior que o toca"}, true},
    {first, "first", {"g", "Home"}, {"before the first step", "antes do primeiro passo"}, true},
    {last, "last", {"G", "End"}, {"the last step; after a number, as in 14G, the step of that number, as 14 Enter",
     "o último passo; depois de um número, como em 14G, o passo desse número, como 14 Enter"}, true},
    {play, "play", {"Space", "p"}, {"play, pause", "rodar, pausar"}, true},
    {faster, "faster", {"+", "="}, {"play twice as fast", "rodar duas vezes mais rápido"}, true},
    {slower, "slower", {"-"}, {"play half as fast", "rodar com metade da velocidade"}, true},
    {search, "search", {"/"}, {"search for steps, as in scanline y=2, depth fail, pixel in=ABC, or for words of their sentences",
     "buscar passos, como em scanline y=2, depth fail, pixel in=ABC, ou palavras das suas frases"}, false},
    {next_match, "next-match", {"n"}, {"the next step that was searched for", "o próximo passo que foi buscado"}, false},
    {previous_match, "previous-match", {"N"}, {"the previous step that was searched for", "o passo anterior que foi buscado"}, false},
    {breakpoint, "breakpoint", {"b"}, {"a breakpoint: playing stops at such steps", "um ponto de parada: a reprodução para nesses passos"}, false},
    {no_breakpoints, "no-breakpoints", {"B"}, {"no breakpoints", "nenhum ponto de parada"}, false},
    {cursor_left, "cursor-left", {"Shift+Left", "H"}, {"the cursor to the left", "o cursor para a esquerda"}, true},
    {cursor_down, "cursor-down", {"Shift+Down", "J"}, {"the cursor down", "o cursor para baixo"}, true},
    {cursor_up, "cursor-up", {"Shift+Up", "K"}, {"the cursor up", "o cursor para cima"}, true},
    {cursor_right, "cursor-right", {"Shift+Right", "L"}, {"the cursor to the right", "o cursor para a direita"}, true},
    {cursor_to_step, "cursor-to-step", {"c"}, {"the cursor to the step's pixel; no cursor, if it is there",
     "o cursor para o pixel do passo; nenhum cursor, se já está lá"}, true},
    {next_view, "next-view", {"v"}, {"the next view: plotted, faces, shade, ...", "a próxima vista: plotted, faces, shade, ..."}, true},
    {previous_view, "previous-view", {"V"}, {"the previous view", "a vista anterior"}, true},
    {overview, "overview", {"o"}, {"all of the canvas, many pixels to a cell, or a part of it",
     "a tela inteira, muitos pixels por célula, ou uma parte dela"}, false},
    {larger_cells, "larger-cells", {"z"}, {"larger cells, for a projector", "células maiores, para um projetor"}, true},
    {smaller_cells, "smaller-cells", {"Z"}, {"smaller cells", "células menores"}, true},
    {working, "working", {"w"}, {"how the numbers come of one another, or only the sentence", "como os números resultam uns dos outros, ou só a frase"}, true},
    {working_down, "working-down", {"Ctrl+d"}, {"the working further down, where it has no room", "as contas mais abaixo, onde não cabem"}, false},
    {working_up, "working-up", {"Ctrl+u"}, {"the same, back up", "as mesmas, de volta para cima"}, false},
    {next_frame, "next-frame", {"f"}, {"the next frame of a scene whose numbers vary", "o próximo quadro de uma cena cujos números variam"}, true},
    {previous_frame, "previous-frame", {"F"}, {"the previous frame", "o quadro anterior"}, true},
    {read_again, "read-again", {"r"}, {"read the file again", "ler o arquivo de novo"}, false},
    {redraw, "redraw", {"Ctrl+l"}, {"draw the screen again", "desenhar o terminal de novo"}, false},
    {help, "help", {"?", "F1"}, {"these keys; again for the next page", "estas teclas; outra vez para a próxima página"}, true},
    {quit, "quit", {"q"}, {"leave; in the help, close it", "sair; na ajuda, fechá-la"}, false},
});
// clang-format on

/// Keys that are called otherwise in another language; `Shift`, `Home` and `Enter` are on its keyboards, too.
constexpr std::array words_of_keys{Words{"Right", "Direita"}, Words{"Left", "Esquerda"},
                                   Words{"Up", "Cima"}, Words{"Down", "Baixo"},
                                   Words{"Space", "Espaço"}};

} // namespace

std::span<const PlayerKey> player_keys() {
    return table;
}

const PlayerKey& key_of(PlayerAction action) {
    return *std::find_if(table.begin(), table.end(),
                         [action](const PlayerKey& row) { return row.action == action; });
}

std::optional<PlayerAction> player_action_of(std::string_view key) {
    for (const PlayerKey& row : table)
        if (std::find(row.keys.begin(), row.keys.end(), key) != row.keys.end())
            return row.action;
    return std::nullopt;
}

std::string told_key(std::string_view key) {
    const std::size_t end =
        key.size() > 1 ? key.rfind('+') + 1 : 0; // of `Shift+`; 0 = npos + 1 without it
    for (const Words& word : words_of_keys)
        if (key.substr(end) == word.in(Language::english))
            return std::string(key.substr(0, end)) + std::string(word.in(language_of_steps()));
    return std::string(key);
}

} // namespace rastertrace
