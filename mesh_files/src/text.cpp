// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace mesh_files {
namespace {

constexpr std::size_t kMostShown = 20;

bool is_space(char c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

template <class Number>
Number parsed(std::string_view word, const char* what) {
    std::string_view digits = word;
    if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
    Number number{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
    const bool is_all = end == digits.data() + digits.size();
    if (error == std::errc::result_out_of_range && is_all) {
        if (digits.find_first_of("eE") + 1 == digits.find('-', 1)) return 0;  // 1e-999
        throw Defect{quoted(word) + " is out of range"};
    }
    if (error != std::errc() || !is_all) throw Defect{quoted(word) + " is not a " + what};
    return number;
}

}  // namespace

std::string_view take_word(std::string_view& text) {
    const auto begin = std::find_if_not(text.begin(), text.end(), is_space);
    const auto end = std::find_if(begin, text.end(), is_space);
    const std::string_view word =
        text.substr(std::size_t(begin - text.begin()), std::size_t(end - begin));
    text.remove_prefix(std::size_t(end - text.begin()));
    return word;
}

bool Text::next_line(std::string_view& line) {
    if (rest_.empty()) return false;
    const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
    line = rest_.substr(0, end);
    rest_.remove_prefix(end);
    if (rest_.size() > 1 && rest_[0] == '\r' && rest_[1] == '\n') rest_.remove_prefix(1);
    if (!rest_.empty()) rest_.remove_prefix(1);
    if (!is_in_line_) ++line_;
    is_in_line_ = false;
    return true;
}

std::string_view Text::next_word() {
    std::string_view line;
    while (!rest_.empty()) {
        if (rest_[0] == '\n' || rest_[0] == '\r') {
            next_line(line);
        } else if (is_space(rest_[0])) {
            rest_.remove_prefix(1);
        } else {
            if (!is_in_line_) ++line_;
            is_in_line_ = true;
            return take_word(rest_);
        }
    }
    return {};
}

void Text::skip_line() {
    std::string_view line;
    next_line(line);
}

void Text::put_back(std::string_view end) {
    rest_ = {end.data(), std::size_t(rest_.data() + rest_.size() - end.data())};
}

double number_in(std::string_view word) {
    if (word.find("1.#") < 2) return NAN;  // Microsoft's "-1.#IND"
    return parsed<double>(word, "number");
}

std::int64_t integer_in(std::string_view word) {
    return parsed<std::int64_t>(word, "whole number");
}

Eigen::Vector3d coordinates_in(std::string_view& line) {
    Eigen::Vector3d position;
    for (int k = 0; k < 3; ++k) {
        const std::string_view word = take_word(line);
        if (word.empty())
            throw Defect{"a vertex has " + std::to_string(k) + " of three coordinates"};
        position[k] = number_in(word);
    }
    return position;
}

std::size_t words_in(std::string_view line) {
    std::size_t count = 0;
    for (std::string_view word; !(word = take_word(line)).empty() && word[0] != '#';)
        ++count;
    return count;
}

std::string quoted(std::string_view word) {
    std::string shown;
    for (const char c : word.substr(0, kMostShown))
        shown += c > ' ' && c < '\x7f' && c != '"' ? c : '?';
    if (word.size() > kMostShown) shown += "...";
    return '"' + shown + '"';
}

std::string unread(std::string_view rest) {
    std::string_view behind = rest;
    const std::string_view word = take_word(behind);
    if (word.empty()) return {};
    return "its last " + std::to_string(word.size() + behind.size()) +
           " bytes, after what its header promises, are not read";
}

}  // namespace mesh_files
