// SPDX-License-Identifier: GPL-3.0-or-later
#include "json.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

#include "line_drawing/words.h"

namespace {

using line_drawing::kReplacement;

constexpr int kMostLevels = 8;

class Reader {
public:
    explicit Reader(std::string_view text) : rest_(text) {}

    Json value(int levels = kMostLevels) {
        Json value;
        if (levels == 0) throw std::invalid_argument("too many levels");
        if (take('{'))
            list('}', [&] {
                std::string name = string();
                need(':');
                value.members[std::move(name)] = this->value(levels - 1);
            });
        else if (take('['))
            list(']', [&] { value.items.push_back(this->value(levels - 1)); });
        else if (next() == '"')
            value.text = string();
        else
            value.text = word();
        return value;
    }

private:
    char next() {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(" \t\n\r"), rest_.size()));
        return rest_.empty() ? '\0' : rest_[0];
    }
    bool take(char c) {
        const bool is_there = next() == c;
        if (is_there) rest_.remove_prefix(1);
        return is_there;
    }
    void need(char c) {
        if (!take(c)) throw std::invalid_argument("something else");
    }
    std::string_view take_bytes(std::size_t count) {
        if (count > rest_.size()) throw std::invalid_argument("it ends");
        const std::string_view bytes = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return bytes;
    }

    template <class Item>
    void list(char end, Item item) {
        if (take(end)) return;
        do
            item();
        while (take(','));
        need(end);
    }

    std::string word() {
        const std::size_t size = std::min(
            rest_.find_first_not_of("+-.0123456789Eabcdefghijklmnopqrstuvwxyz"), rest_.size());
        if (size == 0) throw std::invalid_argument("no value");
        return std::string(take_bytes(size));
    }

    std::string string() {
        need('"');
        std::string text;
        for (char c; (c = take_bytes(1)[0]) != '"';)
            text += c == '\\' ? escaped() : std::string(1, c);
        return text;
    }

    std::string escaped() {
        const char c = take_bytes(1)[0];
        if (c == 'u') return line_drawing::in_utf8(std::u32string(1, letter()));
        constexpr std::string_view letters = "\"\\/bfnrt", meant = "\"\\/\b\f\n\r\t";
        if (letters.find(c) == letters.npos) throw std::invalid_argument("no escape");
        return {meant[letters.find(c)]};
    }

    /// Of one number, or of two of UTF-16.
    char32_t letter() {
        const char32_t first = number();
        if (first < 0xd800 || first >= 0xe000) return first;
        if (first >= 0xdc00 || rest_.substr(0, 2) != "\\u") return kReplacement;
        take_bytes(2);
        const char32_t second = number();
        if (second < 0xdc00 || second >= 0xe000) return kReplacement;
        return 0x10000 + ((first & 0x3ff) << 10 | (second & 0x3ff));
    }
    char32_t number() {
        const std::string_view digits = take_bytes(4);
        unsigned number = 0;
        const auto [end, error] = std::from_chars(digits.data(), digits.data() + 4, number, 16);
        if (error != std::errc() || end != digits.data() + 4)
            throw std::invalid_argument("no number");
        return number;
    }

    std::string_view rest_;
};

}  // namespace

std::optional<Json> json_in(std::string_view text) {
    try {
        return Reader(text).value();
    } catch (const std::invalid_argument&) {
        return {};
    }
}
