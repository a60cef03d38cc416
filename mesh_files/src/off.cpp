// SPDX-License-Identifier: GPL-3.0-or-later
// Geomview's OFF: words, usually a vertex or a face per line, followed by colors and normals.
#include <algorithm>

#include "mesh_builder.h"
#include "text.h"

namespace mesh_files {
namespace {

/// Where a vertex or a face ends. In the format, a vertex has a fixed number of words, and a face
/// ends with its line; many writers differ.
enum class Layout { Lines, Format, Words };

class OffReader {
public:
    OffReader(Text& text, MeshBuilder& mesh, Layout layout)
        : text_(text), mesh_(mesh), layout_(layout) {}

    void read() {
        read_head();
        for (std::uint64_t i = 0; i < vertices_; ++i)
            read_vertex(i);
        for (std::uint64_t i = 0; i < faces_; ++i)
            read_face(i);
    }
    /// Except for comments.
    bool is_at_end() { return next_word().empty(); }

private:
    std::string_view next_word() {
        std::string_view word;
        while (!(word = text_.next_word()).empty() && word[0] == '#')
            text_.skip_line();
        return word;
    }

    /// So many words, or, of Layout::Lines, the line that the next word begins.
    std::string_view required_line(std::size_t words, const char* what, std::uint64_t i,
                                   std::uint64_t count) {
        joined_.clear();
        for (std::size_t k = 0; k < words; ++k) {
            const std::string_view word = next_word();
            if (word.empty())
                throw Defect{std::string("it ends before ") + what + ' ' + std::to_string(i + 1) +
                             " of " + std::to_string(count)};
            if (layout_ == Layout::Lines) {
                std::string_view line;
                text_.put_back(word);
                text_.next_line(line);
                return line;
            }
            joined_.append(word) += ' ';
        }
        return joined_;
    }

    /// The word OFF may be missing, or run into the numbers.
    void read_head() {
        const std::string_view word = next_word();
        if (word.empty()) throw Defect{"it holds nothing"};
        const std::size_t at = word.find("OFF");
        if (at == word.npos) {
            text_.put_back(word);
        } else {
            read_prefix(word.substr(0, at));
            text_.put_back(word.substr(at + 3));
        }
        vertices_ = count_in(next_word());
        faces_ = count_in(next_word());
        if (layout_ == Layout::Lines)  // many lack the number of edges
            text_.skip_line();
        else
            next_word();
        mesh_.expect_vertices(vertices_);
    }

    /// In any order: Geomview has ST, C, N, and MeshLab writes N, C, ST.
    void read_prefix(std::string_view prefix) {
        while (!prefix.empty()) {
            const char first = prefix[0];
            prefix.remove_prefix(prefix.substr(0, 2) == "ST" ? 2 : 1);
            if (first == 'S')
                words_of_vertex_ += 2;
            else if (first == 'C')
                words_of_vertex_ += 4;
            else if (first == 'N')
                words_of_vertex_ += 3;
            else
                throw Defect{"of OFF files, those in 4 or n dimensions are not read"};
        }
    }

    static std::uint64_t count_in(std::string_view word) {
        if (word.empty()) throw Defect{"it ends within its header"};
        if (word == "BINARY")
            throw Defect{"binary OFF files are not read; save it as text, or as PLY"};
        const std::int64_t count = integer_in(word);
        if (count < 0) throw Defect{quoted(word) + " is not a number of vertices or faces"};
        return std::uint64_t(count);
    }

    void read_vertex(std::uint64_t i) {
        std::string_view line = required_line(words_of_vertex_, "vertex", i, vertices_);
        mesh_.add(coordinates_in(line));
        // Without one of its coordinates, a number of a colour would be taken for one.
        const std::size_t more = words_in(line);
        if (i > 0 && more != more_words_)
            throw Defect{"a vertex has " + std::to_string(3 + more) + " numbers, others have " +
                         std::to_string(3 + more_words_)};
        more_words_ = more;
    }

    void read_face(std::uint64_t i) {
        std::string_view line = required_line(1, "face", i, faces_);
        const std::int64_t count = integer_in(take_word(line));
        if (layout_ != Layout::Lines)
            line = required_line(std::size_t(std::max<std::int64_t>(count, 0)), "face", i, faces_);
        corners_.clear();
        for (std::int64_t k = 0; k < count; ++k) {
            const std::string_view word = take_word(line);
            if (word.empty())
                throw Defect{"a face has " + std::to_string(k) + " of " + std::to_string(count) +
                             " corners"};
            corners_.push_back(integer_in(word));
        }
        mesh_.add(corners_);
        if (layout_ == Layout::Format) text_.skip_line();
    }

    Text& text_;
    MeshBuilder& mesh_;
    const Layout layout_;
    std::uint64_t vertices_ = 0, faces_ = 0;
    std::size_t words_of_vertex_ = 3;
    std::size_t more_words_ = 0;  // after a vertex's coordinates
    std::string joined_;
    std::vector<std::int64_t> corners_;
};

/// Whether this layout uses all bytes. If so, gives the mesh.
bool is_all(std::string_view bytes, Layout layout, MeshBuilder& mesh) {
    Text text(bytes);
    MeshBuilder all;
    try {
        OffReader reader(text, all, layout);
        reader.read();
        // words out of step look like faces of 0 to 2 corners
        if (!reader.is_at_end() || (layout != Layout::Lines && all.skipped_faces() > 0))
            return false;
    } catch (const Defect&) {
        return false;
    }
    mesh = std::move(all);
    return true;
}

}  // namespace

std::string read_off(std::string_view bytes, MeshBuilder& mesh) {
    for (const Layout layout : {Layout::Lines, Layout::Format, Layout::Words})
        if (is_all(bytes, layout, mesh)) return {};
    Text text(bytes);
    read_lines(text, [&] { OffReader(text, mesh, Layout::Lines).read(); });
    return unread(text.rest());
}

}  // namespace mesh_files
