// SPDX-License-Identifier: MIT
#include "player/key_reader.h"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace rastertrace {
namespace {

using Names = std::vector<std::string>;

Names keys_of(KeyReader& reader) {
    Names names;
    while (const auto key = reader.next())
        names.push_back(key->key);
    return names;
}

Names keys_in(std::string_view bytes) {
    KeyReader reader;
    reader.take(bytes);
    return keys_of(reader);
}

TEST(KeyReader, TakesKeysThatComeAtOnceApart) {
    EXPECT_EQ(keys_in("l\x1b[C\x1bOC14G \r\x0c"),
              (Names{"l", "Right", "Right", "1", "4", "G", "Space", "Enter", "Ctrl+l"}));
}

TEST(KeyReader, KnowsTheNamedKeysOfXterm) {
    EXPECT_EQ(keys_in("\x1b[A\x1b[B\x1b[C\x1b[D\x1b[H\x1b[F\x1bOP\x1b[11~"),
              (Names{"Up", "Down", "Right", "Left", "Home", "End", "F1", "F1"}));
    EXPECT_EQ(keys_in("\x1b[1~\x1b[4~\x1b[5~\x1b[6~\x1b[3~"),
              (Names{"Home", "End", "PageUp", "PageDown", "Delete"}));
    EXPECT_EQ(keys_in("\x1b[1;2A\x1b[1;2D"), (Names{"Shift+Up", "Shift+Left"}));
    EXPECT_EQ(keys_in("\x7f\b\t"), (Names{"Backspace", "Backspace", "Tab"}));
    EXPECT_EQ(keys_in("ä€𝄞"), (Names{"ä", "€", "𝄞"}));
}

TEST(KeyReader, WaitsForTheRestOfAKeyHoweverItIsCut) {
    const std::string bytes = "\x1b[1;2C€\x1b[<0;12;7Mq";
    const Names all = keys_in(bytes);
    ASSERT_EQ(all, (Names{"Shift+Right", "€", "Click", "q"}));
    for (std::size_t cut = 0; cut <= bytes.size(); ++cut) {
        KeyReader reader;
        reader.take(std::string_view(bytes).substr(0, cut));
        Names keys = keys_of(reader);
        reader.take(std::string_view(bytes).substr(cut));
        for (std::string& key : keys_of(reader))
            keys.push_back(std::move(key));
        EXPECT_EQ(keys, all) << cut;
    }
}

TEST(KeyReader, TakesEscapeAloneWhereNothingFollows) {
    KeyReader reader;
    reader.take("\x1b");
    EXPECT_FALSE(reader.next());
    EXPECT_TRUE(reader.has_part());
    EXPECT_EQ(reader.next_of_rest()->key, "Escape");
    EXPECT_FALSE(reader.has_part());
}

TEST(KeyReader, TellsWhereTheMouseWasPressed) {
    KeyReader reader;
    reader.take("\x1b[<0;12;7M\x1b[<0;12;7m\x1b[<65;1;1M");
    const auto press = reader.next();
    EXPECT_EQ(press->key, "Click");
    EXPECT_EQ(press->column, 11U);
    EXPECT_EQ(press->line, 6U);
    EXPECT_EQ(reader.next()->key, "");      // let go
    EXPECT_EQ(reader.next()->key, "Right"); // the wheel
}

TEST(KeyReader, SurvivesAnything) {
    std::string bytes;
    for (int first = 0; first < 256; ++first)
        for (const char second : {'[', 'O', '\x1b', '<', '~', ';', '\x80'})
            bytes += {static_cast<char>(first), second};
    KeyReader reader;
    reader.take(bytes);
    while (reader.next() || reader.next_of_rest()) {
    }
    EXPECT_FALSE(reader.has_part());
}

} // namespace
} // namespace rastertrace
