// SPDX-License-Identifier: GPL-3.0-or-later
// Wavefront's OBJ: vertices and faces; statements that are not the format's are counted.
#include <algorithm>
#include <iterator>

#include "mesh_builder.h"
#include "text.h"

namespace mesh_files {
namespace {

// Wavefront, Advanced Visualizer manual, appendix B.
constexpr std::string_view kOtherStatements[] = {
    "bevel", "bmat",   "bsp",    "bzp",        "call",  "c_interp", "cdc",  "cdp",  "con",
    "csh",   "cstype", "ctech",  "curv",       "curv2", "d_interp", "deg",  "end",  "g",
    "hole",  "l",      "lod",    "maplib",     "mg",    "mtllib",   "o",    "p",    "parm",
    "res",   "s",      "scrv",   "shadow_obj", "sp",    "stech",    "step", "surf", "trace_obj",
    "trim",  "usemap", "usemtl", "vn",         "vp",    "vt"};

class ObjReader {
public:
    /// `ends_in_line`: the last line has no ending.
    ObjReader(Text& text, bool ends_in_line, MeshBuilder& mesh)
        : text_(text), ends_in_line_(ends_in_line), mesh_(mesh) {}

    std::string read() {
        for (std::string_view line; next(line);) {
            const std::string_view statement = take_word(line);
            if (statement == "v")
                read_vertex(line);
            else if (statement == "f" || statement == "fo")
                read_face(line);
            else if (!is_other(statement) && !are_zeros_at_end(statement))
                skip(statement);
        }
        for (const Ahead& face : ahead_)
            if (face.vertex >= std::int64_t(mesh_.vertex_count()))
                throw Defect{"a face names vertex " + std::to_string(face.vertex + 1) + " of " +
                                 std::to_string(mesh_.vertex_count()),
                             face.line};
        if (skipped_ == 0) return {};
        return "lines skipped that are no statements of OBJ files: " + std::to_string(skipped_) +
               ", the first is " + first_skipped_;
    }

private:
    /// A backslash at the end continues the line; that of a comment may end a folder's name.
    bool next(std::string_view& line) {
        if (!text_.next_line(line)) return false;
        if (!goes_on(line) || line[0] == '#') return true;
        joined_.clear();
        do {
            joined_.append(line.substr(0, line.size() - 1));
            joined_ += ' ';
            if (!text_.next_line(line)) throw_cut_off();
        } while (goes_on(line));
        joined_.append(line);
        line = joined_;
        return true;
    }
    static bool goes_on(std::string_view line) { return !line.empty() && line.back() == '\\'; }

    [[noreturn]] static void throw_cut_off() { throw Defect{"it ends in the middle of a line"}; }

    static bool is_other(std::string_view statement) {
        if (statement.empty() || statement[0] == '#') return true;
        return std::find(std::begin(kOtherStatements), std::end(kOtherStatements), statement) !=
               std::end(kOtherStatements);
    }

    bool are_zeros_at_end(std::string_view statement) const {
        constexpr std::string_view zero("\0", 1);
        return statement.find_first_not_of(zero) == statement.npos &&
               text_.rest().find_first_not_of(zero) == text_.rest().npos;
    }

    /// Skips statements of other programs. A number is no statement, but a damaged line.
    void skip(std::string_view statement) {
        if (statement.find_first_of("0123456789") < 2)
            throw Defect{quoted(statement) + " is not a statement of OBJ files"};
        if (++skipped_ == 1)
            first_skipped_ = "line " + std::to_string(text_.line()) + ", " + quoted(statement);
    }

    /// A weight, or a colour of three or four numbers, may follow.
    void read_vertex(std::string_view line) {
        mesh_.add(coordinates_in(line));
        const std::size_t more = words_in(line);
        if (more == 2 || more > 4)
            throw Defect{"a vertex has " + std::to_string(3 + more) + " numbers"};
    }

    void read_face(std::string_view line) {
        corners_.clear();
        for (std::string_view word; !(word = take_word(line)).empty() && word[0] != '#';) {
            const std::int64_t number = integer_in(word.substr(0, word.find('/')));
            // From 1, or back from the last vertex.
            const std::int64_t vertex =
                number < 0 ? std::int64_t(mesh_.vertex_count()) + number : number - 1;
            if (number == 0 || vertex < 0 || vertex >= std::numeric_limits<std::uint32_t>::max())
                throw Defect{"a face names vertex " + quoted(word) + " of " +
                             std::to_string(mesh_.vertex_count())};
            corners_.push_back(vertex);
        }
        // cut off; a face that has three corners left looks whole
        if (corners_.size() < 3 && ends_in_line_ && text_.rest().empty()) throw_cut_off();
        const auto last = std::max_element(corners_.begin(), corners_.end());
        if (corners_.size() >= 3 && *last >= std::int64_t(mesh_.vertex_count()))
            ahead_.push_back({*last, text_.line()});
        mesh_.add(corners_);
    }

    /// A face that comes before one of its vertices.
    struct Ahead {
        std::int64_t vertex;
        std::size_t line;
    };

    Text& text_;
    const bool ends_in_line_;
    MeshBuilder& mesh_;
    std::string joined_;
    std::vector<std::int64_t> corners_;
    std::vector<Ahead> ahead_;
    std::size_t skipped_ = 0;
    std::string first_skipped_;
};

}  // namespace

std::string read_obj(std::string_view bytes, MeshBuilder& mesh) {
    Text text(bytes);
    const bool ends_in_line = !bytes.empty() && bytes.back() != '\n' && bytes.back() != '\r';
    return read_lines(text, [&] { return ObjReader(text, ends_in_line, mesh).read(); });
}

}  // namespace mesh_files
