// SPDX-License-Identifier: MIT
#pragma once

// JSON with a memory of where everything stood, so that a wrong value can be pointed at.
// nlohmann-json reads the grammar and checks the UTF-8; this adds the places, keeps numbers as
// typed, and refuses what it would let pass in silence: repeated keys, and nesting without end.
//
//     const auto document = parse_json(source);
//     for (const auto& [key, value] : document.value().root().members())
//
// A document remembers 8 bytes for each value: where it begins, and which value comes behind it.
// Everything else is read from the source again when someone asks, so both must outlive the values.

#include "problem.h"

#include <cstddef>
#include <cstdint>
#include <deque>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace rastertrace {

class JsonDocument;
class JsonElements;
class JsonMembers;

/// A JSON value.
struct JsonValue {
    enum class Kind { null, boolean, number, string, array, object };

    JsonValue(const JsonDocument& document, std::uint32_t node);

    /// The offset behind its last byte in the source.
    std::size_t end() const;

    /// The value under a key of an object, if it has the key.
    std::optional<JsonValue> find(std::string_view key) const;

    /// The elements of an array; none of anything else.
    JsonElements elements() const;

    /// The keys and values of an object, in order; none of anything else.
    JsonMembers members() const;

    /// Which value of its document it is: the same each time that the source is parsed.
    std::uint32_t node() const { return node_; }

    Kind kind = Kind::null;
    std::size_t begin = 0; ///< offset of its first byte in the source
    std::string text; ///< of a string: decoded; of a number: as typed; of a boolean: true, false

private:
    friend class JsonElements;
    friend class JsonMembers;
    const JsonDocument* document_;
    std::uint32_t node_;
};

/// What one source says.
class JsonDocument {
public:
    /// The outermost value.
    JsonValue root() const { return {*this, 0}; }

    /// Lets a number or a string be read as if `token` stood in its place. Its offset stays.
    void replace(std::uint32_t node, std::string token) { replaced_[node] = std::move(token); }

private:
    friend struct JsonValue;
    friend class JsonElements;
    friend class JsonMembers;
    friend class DocumentBuilder;

    /// A value or a key. Those inside of it follow it, up to `next`.
    struct Node {
        std::uint32_t begin; ///< offset in the source
        std::uint32_t next;  ///< the first node that is not inside of this one
    };

    JsonDocument(const Source& source, std::size_t end) : source_(&source), end_(end) {}
    std::string_view text() const { return source_->view().substr(0, end_); }

    /// What is read as this value: it stands in front.
    std::string_view text_from(std::uint32_t node) const {
        const auto replaced = replaced_.find(node);
        return replaced == replaced_.end() ? text().substr(nodes_[node].begin) : replaced->second;
    }

    const Source* source_;
    std::size_t end_; ///< of what was read of the source
    std::deque<Node> nodes_;
    std::unordered_map<std::uint32_t, std::string> replaced_; ///< tokens, by node
};

/// What is inside of a value, in order.
template <typename Range, typename Item> class JsonRange {
public:
    class Iterator {
    public:
        using iterator_category = std::input_iterator_tag;
        using value_type = Item;
        using difference_type = std::ptrdiff_t;
        using pointer = void;
        using reference = Item;

        Iterator(const JsonDocument* document, std::uint32_t node)
            : document_(document), node_(node) {}
        Item operator*() const { return Range::item(*document_, node_); }
        Iterator& operator++() {
            node_ = Range::behind(*document_, node_);
            return *this;
        }
        bool operator==(const Iterator& other) const { return node_ == other.node_; }

    private:
        const JsonDocument* document_;
        std::uint32_t node_;
    };

    JsonRange(const JsonDocument& document, std::uint32_t first, std::uint32_t end)
        : document_(&document), first_(first), end_(end) {}

    Iterator begin() const { return {document_, first_}; }
    Iterator end() const { return {document_, end_}; }
    bool empty() const { return first_ == end_; }

    /// Counts them.
    std::size_t size() const {
        std::size_t count = 0;
        for (std::uint32_t node = first_; node != end_; node = Range::behind(*document_, node))
            ++count;
        return count;
    }

    /// Goes there from the first one: meant for the first few.
    Item operator[](std::size_t i) const {
        std::uint32_t node = first_;
        for (; i > 0; --i)
            node = Range::behind(*document_, node);
        return Range::item(*document_, node);
    }

private:
    const JsonDocument* document_;
    std::uint32_t first_;
    std::uint32_t end_;
};

class JsonElements : public JsonRange<JsonElements, JsonValue> {
public:
    using JsonRange::JsonRange;
    static JsonValue item(const JsonDocument& document, std::uint32_t node) {
        return {document, node};
    }
    static std::uint32_t behind(const JsonDocument& document, std::uint32_t node) {
        return document.nodes_[node].next;
    }
};

/// A key of an object, which is a string, and its value.
struct JsonMember {
    JsonValue key;
    JsonValue value;
};

class JsonMembers : public JsonRange<JsonMembers, JsonMember> {
public:
    using JsonRange::JsonRange;
    static JsonMember item(const JsonDocument& document, std::uint32_t node) {
        return {{document, node}, {document, node + 1}};
    }
    static std::uint32_t behind(const JsonDocument& document, std::uint32_t node) {
        return document.nodes_[node + 1].next;
    }
};

/// How deep arrays and objects may be nested.
inline constexpr std::size_t deepest_json = 64;

/// Reads the whole of a source as one JSON value. `begin` and `size` choose a part of it instead;
/// places are still those of the whole source.
Result<JsonDocument> parse_json(const Source& source, std::size_t begin = 0,
                                std::size_t size = std::string_view::npos);

/// What a value is, in words: `number 5`, `"five"`, `an array`.
std::string described(const JsonValue& value);

} // namespace rastertrace
