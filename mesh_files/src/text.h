// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace mesh_files {

/// The file is malformed. `what` is a part of a sentence.
struct Defect {
    std::string what;
    std::size_t line = 0;  ///< 0: the one that is being read
};

/// Removes the first word; empty if there is none.
std::string_view take_word(std::string_view& text);

/// Lines end with LF, CR LF or CR.
class Text {
public:
    explicit Text(std::string_view bytes) : rest_(bytes) {}

    /// False at the end; `line` comes without its ending.
    bool next_line(std::string_view& line);
    /// On any line; empty at the end.
    std::string_view next_word();
    void skip_line();
    /// The end of the last word is read again as the next one.
    void put_back(std::string_view end);

    std::string_view rest() const { return rest_; }
    /// Of the last word or line, from 1.
    std::size_t line() const { return line_; }

private:
    std::string_view rest_;
    std::size_t line_ = 0;     // as many lines were begun
    bool is_in_line_ = false;  // words of it have been read
};

/// Prefixes defects with the line.
template <class Read>
auto read_lines(const Text& text, Read read) {
    try {
        return read();
    } catch (const Defect& defect) {
        throw Defect{"line " + std::to_string(defect.line ? defect.line : text.line()) + ": " +
                     defect.what};
    }
}

/// @throws Defect if it is not a number. "nan" and "inf" are numbers. Any locale.
double number_in(std::string_view word);
std::int64_t integer_in(std::string_view word);
/// Removes x, y and z from the front. @throws Defect
Eigen::Vector3d coordinates_in(std::string_view& line);
/// How many, up to the end or a comment.
std::size_t words_in(std::string_view line);
/// Short and printable, for messages.
std::string quoted(std::string_view word);
/// A remark on bytes after those that the header promises; "" if they are blank.
std::string unread(std::string_view rest);

/// A number at any address. MeshLab's machines all are little-endian.
template <class Number>
Number little_endian(const char* bytes) {
    Number number;
    std::memcpy(&number, bytes, sizeof number);
    return number;
}

}  // namespace mesh_files
