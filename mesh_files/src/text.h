// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace mesh_files {

/// A reader has come to something that its format does not have. what: a part of a sentence.
struct Defect {
    std::string what;
};

/// Takes the next word off the front of a text; empty where there is none.
std::string_view take_word(std::string_view& text);

/// The lines and words of a text. Lines end with LF, CR LF or CR.
class Text {
public:
    explicit Text(std::string_view bytes) : rest_(bytes) {}

    /// Whether there is another line; it is then in `line`, without its end.
    bool next_line(std::string_view& line);
    /// The next word, on whichever line; empty at the end.
    std::string_view next_word();
    /// What is left of this line is not read.
    void skip_line();

    std::string_view rest() const { return rest_; }
    /// The number of the line that the last word or line was on, from 1.
    std::size_t line() const { return line_; }

private:
    std::string_view rest_;
    std::size_t line_ = 0;     // as many lines were begun
    bool is_in_line_ = false;  // words of it have been read
};

/// Reads; a defect that is found says on which line.
template <class Read>
void read_lines(const Text& text, Read read) {
    try {
        read();
    } catch (const Defect& defect) {
        throw Defect{"line " + std::to_string(text.line()) + ": " + defect.what};
    }
}

/// @throws Defect if a word is not a number. Any locale; "nan" and "inf" are numbers.
double number_in(std::string_view word);
std::int64_t integer_in(std::string_view word);
/// Takes x, y and z off the front of a line. @throws Defect
Eigen::Vector3d coordinates_in(std::string_view& line);
/// As many words are before the end or a comment.
std::size_t words_in(std::string_view line);
/// As a message can show it: short, printable.
std::string quoted(std::string_view word);

}  // namespace mesh_files
