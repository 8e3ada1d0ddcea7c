// SPDX-License-Identifier: MIT
// The player goes to the next step of a kind: by a key, by what was typed, and stops at breakpoints. Long searches are
// done in pieces.

#include "frames/terminal_text.h"
#include "player/player.h"

#include <rastertrace/trace/record/traced_steps.h>
#include <rastertrace/trace/tell/step_text.h>
#include <rastertrace/trace/text/text.h>

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace rastertrace {

namespace {

/// A trace of more steps is not searched once more for what is near to what was not found.
constexpr std::size_t most_steps_for_hints = 200'000;

/// True where a row begins: a scanline, what a line does on its way, a sample in another row than the one before.
bool begins_row(const Trace& trace, std::size_t n) {
    const auto kind = trace.kind_of(n);
    if (kind == StepKind::scanline || kind == StepKind::along || kind == StepKind::decide ||
        kind == StepKind::ray)
        return true;
    if (kind != StepKind::sample)
        return false;
    for (std::size_t before = n - 1; before > 0; --before) {
        const auto kind_before = trace.kind_of(before);
        if (kind_before == StepKind::sample)
            return y_in(trace.step(before)) != y_in(trace.step(n));
        if (kind_before == StepKind::primitive)
            break;
    }
    return true;
}

/// True if a step decides something about a pixel.
bool touches(const Trace& trace, std::size_t n, Pixel pixel) {
    switch (trace.kind_of(n).value_or(StepKind::primitive)) {
    case StepKind::pixel:
    case StepKind::depth:
    case StepKind::sample:
    case StepKind::decide:
        break;
    default:
        return false;
    }
    const StepView step = trace.step(n);
    return x_in(step) == pixel.x && y_in(step) == pixel.y;
}

} // namespace

/// Begins to search, as often as a number in front of the key says.
void Player::find(Direction direction, std::function<bool(std::size_t)> is_meant,
                  std::string missing, std::size_t at_once) {
    looks_at_cursor_ = false;
    search_ = Search{.is_meant = std::move(is_meant),
                     .direction = direction,
                     .begin = step(),
                     .place = step(),
                     .remaining = take_times(),
                     .missing = std::move(missing),
                     .at_once = at_once};
    search_on();
}

/// Looks at some steps more; goes to the one that was searched for.
bool Player::search_on() {
    if (!search_)
        return false;
    Search& search = *search_;
    const bool is_forward = search.direction == Direction::forward;
    for (std::size_t looked_at = 0; looked_at < search.at_once; ++looked_at) {
        const bool is_behind = is_forward ? search.place >= trace().size() : search.place <= 1;
        if (is_behind) {
            message_ = search.missing;
            if (search.found != 0)
                show_step(search.found);
            search_.reset();
            return true;
        }
        search.place += is_forward ? 1 : std::size_t(-1);
        if (!search.is_meant(search.place))
            continue;
        search.found = search.place;
        if (--search.remaining == 0) {
            show_step(search.found);
            search_.reset();
            return true;
        }
    }
    return true;
}

std::optional<double> Player::searched() const {
    if (!search_)
        return std::nullopt;
    const bool is_forward = search_->direction == Direction::forward;
    const auto done = static_cast<double>(is_forward ? search_->place - search_->begin
                                                     : search_->begin - search_->place);
    const auto all =
        static_cast<double>(is_forward ? trace().size() - search_->begin : search_->begin);
    return all == 0 ? 1 : done / all;
}

void Player::find_kind(Direction direction) {
    if (step() == 0)
        return move_by(1, direction);
    const auto kind = trace().kind_of(step());
    const std::string name = trace().step(step()).kind_name();
    find(
        direction,
        [this, kind, name](std::size_t n) {
            return trace().kind_of(n) == kind && (kind || trace().step(n).kind_name() == name);
        },
        said("there is no other {} step that way", printable(name)));
}

void Player::find_row(Direction direction) {
    find(
        direction, [this](std::size_t n) { return begins_row(trace(), n); },
        said("no row begins that way"));
}

void Player::find_primitive(Direction direction) {
    find(
        direction, [this](std::size_t n) { return trace().kind_of(n) == StepKind::primitive; },
        said("no primitive begins that way"));
}

/// Steps that belong to the current step's primitive, or that name it.
void Player::find_of_primitive(Direction direction) {
    if (step() == 0)
        return move_by(1, direction);
    const std::size_t primitive = playback_->replay().primitive_of(step());
    const std::string own = name_in(trace().step(step())).text();
    const std::string name = !own.empty()     ? own
                             : primitive == 0 ? std::string()
                                              : name_in(trace().step(primitive)).text();
    if (name.empty()) {
        message_ = said("the step is about no primitive");
        return;
    }
    find(
        direction,
        [this, name](std::size_t n) {
            const std::size_t of = playback_->replay().primitive_of(n);
            return (of != 0 && name_in(trace().step(of)) == name) ||
                   name_in(trace().step(n)) == name;
        },
        said("no other step is about {} that way", printable(name)));
}

void Player::find_at_cursor(Direction direction) {
    if (!cursor_) {
        message_ = said("there is no cursor: c sets it, or a click");
        return;
    }
    const Pixel pixel = *cursor_;
    find(
        direction, [this, pixel](std::size_t n) { return touches(trace(), n, pixel); },
        said("no step touches pixel ({}, {}) that way", pixel.x, pixel.y));
    looks_at_cursor_ = true;
}

void Player::find_match(Direction direction) {
    if (!searched_for_) {
        message_ = said("nothing was searched for: / does");
        return;
    }
    if (!searched_for_->selector)
        return find_words(direction, searched_for_->text);
    const Selector selector = *searched_for_->selector;
    std::string missing = said("no other step that way is {}", printable(selector.source.text));
    find(
        direction,
        [this, selector](std::size_t n) {
            return matches(selector, trace(), n, playback_->replay().primitive_of(n));
        },
        std::move(missing));
}

/// Sentences take longer to make than steps to look at.
void Player::find_words(Direction direction, const std::string& words) {
    const std::size_t sentences_at_once =
        direction == Direction::forward ? 500 : 20; // back, each is far
    find(
        direction,
        [this, wanted = in_lower_case(words)](std::size_t n) {
            return in_lower_case(playback_->sentence_of(n)).find(wanted) != std::string::npos;
        },
        said("no other step that way says \"{}\"", printable(words)), sentences_at_once);
}

void Player::type(const std::string& key) {
    if (key == "Enter")
        return finish_typing();
    if (key == "Escape") {
        asked_ = Asked::nothing;
        return;
    }
    if (key == "Backspace") {
        if (typed_.empty())
            asked_ = Asked::nothing;
        else
            typed_ = first_characters(typed_, characters_in(typed_) - 1);
        return;
    }
    if (key == "Ctrl+u")
        typed_.clear();
    else if (key == "Space")
        typed_ += ' ';
    else if (characters_in(key) == 1)
        typed_ += printable(key);
}

void Player::finish_typing() {
    if (std::exchange(asked_, Asked::nothing) == Asked::search)
        start_search(typed_);
    else
        add_breakpoint(typed_);
}

/// What a text means; nothing, and a message, if it means no step.
std::optional<Selector> Player::selector_of(const std::string& text) {
    auto parsed = parse_selector({"", text, {}}, trace());
    if (parsed)
        return std::move(parsed.value());
    const Problem& problem = parsed.problem();
    message_ = problem.message + (problem.hint.empty() ? "" : "; " + problem.hint);
    return std::nullopt;
}

/// An empty text searches for the same again.
void Player::start_search(const std::string& text) {
    if (!text.empty()) {
        auto selector = selector_of(text);
        if (selector && selector->number)
            return move_to(*selector->number);
        searched_for_ = {text, std::move(selector)};
        message_.clear(); // what is no step may be said by one
    }
    find_match(Direction::forward);
    if (search_ || message_.empty() || !searched_for_ || trace().size() > most_steps_for_hints)
        return;
    if (!searched_for_->selector) {
        const std::string missing = message_;
        selector_of(searched_for_->text); // what is wrong with it
        message_ = missing + "; " + message_;
        return;
    }
    // Perhaps it is behind us, or there is none at all.
    const auto all = matching_steps(*searched_for_->selector, trace());
    if (!all)
        message_ =
            all.problem().message + (all.problem().hint.empty() ? "" : "; " + all.problem().hint);
    else
        message_ = said("none of the {} such steps is ahead; N goes to the one before",
                        all.value().size());
}

void Player::add_breakpoint(const std::string& text) {
    if (text.empty())
        return;
    if (auto selector = selector_of(text)) {
        breakpoints_.push_back(std::move(*selector));
        message_ =
            said("playing stops at {}; B removes all {}", printable(text), breakpoints_.size());
    }
}

bool Player::is_at_breakpoint() const {
    return step() != 0 &&
           std::any_of(breakpoints_.begin(), breakpoints_.end(), [this](const Selector& selector) {
               return matches(selector, trace(), step(), playback_->replay().primitive());
           });
}

} // namespace rastertrace
