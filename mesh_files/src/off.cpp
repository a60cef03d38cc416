// SPDX-License-Identifier: GPL-3.0-or-later
// Geomview's OFF: a vertex or a face per line, colours and normals behind.
#include "readers.h"
#include "text.h"

namespace mesh_files {
namespace {

class OffReader {
public:
    OffReader(Text& text, MeshBuilder& mesh) : text_(text), mesh_(mesh) {}

    void read() {
        read_head();
        for (std::uint64_t i = 0; i < vertices_; ++i)
            read_vertex(i);
        for (std::uint64_t i = 0; i < faces_; ++i)
            read_face(i);
        std::string_view line;
        if (next(line)) throw Defect{"it goes on after what its header promises"};
    }

private:
    /// The next line that is not blank or a comment.
    bool next(std::string_view& line) {
        while (text_.next_line(line)) {
            std::string_view rest = line;
            if (const std::string_view word = take_word(rest); !word.empty() && word[0] != '#')
                return true;
        }
        return false;
    }

    std::string_view demanded_line(const char* what, std::uint64_t i, std::uint64_t count) {
        std::string_view line;
        if (!next(line))
            throw Defect{std::string("it ends before ") + what + ' ' + std::to_string(i + 1) +
                         " of " + std::to_string(count)};
        return line;
    }

    /// The word OFF may lack, or share its line with the numbers.
    void read_head() {
        std::string_view line;
        if (!next(line)) throw Defect{"it holds nothing"};
        std::string_view rest = line;
        const std::string_view word = take_word(rest);
        if (word.size() >= 3 && word.substr(word.size() - 3) == "OFF") {
            const std::string_view prefix = word.substr(0, word.size() - 3);
            for (const char* known : {"", "C", "N", "CN", "ST", "STC", "STN", "STCN"})
                if (prefix == known) return read_counts(rest);
            throw Defect{"of OFF files, " + quoted(word) + " are not read"};
        }
        read_counts(line);
    }

    void read_counts(std::string_view rest) {
        std::string_view word = take_word(rest);
        if (word == "BINARY") throw Defect{"binary OFF files are not read"};
        if (word.empty()) {
            if (!next(rest)) throw Defect{"it ends after its header"};
            word = take_word(rest);
        }
        vertices_ = count_in(word);
        faces_ = count_in(take_word(rest));
    }

    static std::uint64_t count_in(std::string_view word) {
        const std::int64_t count = integer_in(word);
        if (count < 0) throw Defect{quoted(word) + " is not a number of vertices or faces"};
        return std::uint64_t(count);
    }

    void read_vertex(std::uint64_t i) {
        std::string_view line = demanded_line("vertex", i, vertices_);
        mesh_.add(coordinates_in(line));
        // A missing number would make one of the next line a coordinate.
        const std::size_t more = words_in(line);
        if (i > 0 && more != more_words_)
            throw Defect{"a vertex has " + std::to_string(3 + more) + " numbers, others have " +
                         std::to_string(3 + more_words_)};
        more_words_ = more;
    }

    void read_face(std::uint64_t i) {
        std::string_view line = demanded_line("face", i, faces_);
        const std::int64_t count = integer_in(take_word(line));
        corners_.clear();
        for (std::int64_t k = 0; k < count; ++k) {
            const std::string_view word = take_word(line);
            if (word.empty())
                throw Defect{"a face has " + std::to_string(k) + " of " + std::to_string(count) +
                             " corners"};
            corners_.push_back(integer_in(word));
        }
        mesh_.add(corners_);
    }

    Text& text_;
    MeshBuilder& mesh_;
    std::uint64_t vertices_ = 0, faces_ = 0;
    std::size_t more_words_ = 0;  // of a vertex, behind its coordinates
    std::vector<std::int64_t> corners_;
};

}  // namespace

void read_off(std::string_view bytes, MeshBuilder& mesh) {
    Text text(bytes);
    read_lines(text, [&] { OffReader(text, mesh).read(); });
}

}  // namespace mesh_files
