// SPDX-License-Identifier: GPL-3.0-or-later
// 3D Systems' STL: text, or 50 bytes per triangle after a header of 84.
#include <algorithm>

#include "mesh_builder.h"
#include "text.h"

namespace mesh_files {
namespace {

constexpr std::size_t kHeadSize = 84, kCountAt = 80, kTriangleSize = 50, kCornersAt = 12;

bool equals(std::string_view word, std::string_view small_letters) {
    return std::equal(word.begin(), word.end(), small_letters.begin(), small_letters.end(),
                      [](char a, char b) { return (a >= 'A' && a <= 'Z' ? a + 32 : a) == b; });
}

/// Names may run into the word.
bool is_solid(std::string_view word) {
    return equals(word.substr(0, 5), "solid");
}

/// Binary headers may begin with "solid" as well.
bool is_text(std::string_view bytes) {
    std::string_view rest = bytes;
    if (!is_solid(take_word(rest))) return false;
    if (bytes.size() < kHeadSize) return true;
    const auto count = little_endian<std::uint32_t>(bytes.data() + kCountAt);
    if (bytes.size() == kHeadSize + kTriangleSize * std::size_t(count)) return false;
    return bytes.substr(0, kHeadSize + kTriangleSize).find('\0') == std::string_view::npos;
}

class TextReader {
public:
    TextReader(Text& text, MeshBuilder& mesh) : text_(text), mesh_(mesh) {}

    std::string read() {
        std::size_t skipped = 0;
        for (std::string_view word; !(word = text_.next_word()).empty();) {
            if (equals(word, "facet")) throw Defect{"expected \"solid\", not " + quoted(word)};
            text_.skip_line();
            if (is_solid(word))
                read_solid();
            else
                ++skipped;
        }
        if (skipped == 0) return {};
        return "lines skipped after \"endsolid\": " + std::to_string(skipped);
    }

private:
    void read_solid() {
        for (std::string_view word; !equals(word = next(), "endsolid");) {
            if (equals(word, "endfacet")) continue;  // optional: some programs leave it out
            if (!equals(word, "facet"))
                throw Defect{"expected \"facet\" or \"endsolid\", not " + quoted(word)};
            read_facet();
        }
        text_.skip_line();
    }

    void read_facet() {
        demand("normal");
        for (int k = 0; k < 3; ++k)
            next();  // not used, whatever it is
        demand("outer");
        demand("loop");
        corners_.clear();
        std::string_view word;
        while (equals(word = next(), "vertex")) {
            corners_.push_back(std::int64_t(mesh_.vertex_count()));
            Eigen::Vector3d p;
            for (int k = 0; k < 3; ++k)
                p[k] = number_in(next());
            mesh_.add(p);
        }
        if (!equals(word, "endloop"))
            throw Defect{"expected \"vertex\" or \"endloop\", not " + quoted(word)};
        mesh_.add(corners_);
    }

    std::string_view next() {
        const std::string_view word = text_.next_word();
        if (word.empty()) throw Defect{"it ends without \"endsolid\""};
        return word;
    }

    void demand(std::string_view expected) {
        const std::string_view word = next();
        if (!equals(word, expected))
            throw Defect{"expected \"" + std::string(expected) + "\", not " + quoted(word)};
    }

    Text& text_;
    MeshBuilder& mesh_;
    std::vector<std::int64_t> corners_;
};

std::string read_binary(std::string_view bytes, MeshBuilder& mesh) {
    if (bytes.size() < kHeadSize) throw Defect{"it ends within its header"};
    const std::size_t said = little_endian<std::uint32_t>(bytes.data() + kCountAt);
    const std::size_t held = (bytes.size() - kHeadSize) / kTriangleSize;
    mesh.reserve_vertices(3 * std::min(said, held));
    mesh.reserve_triangles(std::min(said, held));
    for (std::size_t i = 0; i < std::min(said, held); ++i) {
        const char* at = bytes.data() + kHeadSize + kTriangleSize * i + kCornersAt;
        const auto first = std::int64_t(mesh.vertex_count());
        for (int corner = 0; corner < 3; ++corner, at += 12)
            mesh.add(Eigen::Vector3d(little_endian<float>(at), little_endian<float>(at + 4),
                                     little_endian<float>(at + 8)));
        mesh.add_triangle(first, first + 1, first + 2);
    }
    if (said > held)
        throw Defect{"it has " + std::to_string(bytes.size()) + " bytes, but " +
                     std::to_string(said) + " triangles take " +
                     std::to_string(kHeadSize + kTriangleSize * said)};
    return unread(bytes.substr(kHeadSize + kTriangleSize * said));
}

}  // namespace

std::string read_stl(std::string_view bytes, MeshBuilder& mesh) {
    if (!is_text(bytes)) return read_binary(bytes, mesh);
    Text text(bytes);
    return read_lines(text, [&] { return TextReader(text, mesh).read(); });
}

}  // namespace mesh_files
