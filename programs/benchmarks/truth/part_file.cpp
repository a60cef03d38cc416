// SPDX-License-Identifier: GPL-3.0-or-later
#include "truth_measures.h"

#include <zlib.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>

namespace benchmarks {
namespace {

/// Packed bytes begin with the length of what they hold, its highest byte first.
std::string unpacked(const std::string& packed) {
    constexpr std::size_t head = 4, most_growth = 1032;  // zlib's
    uLongf size = 0;
    for (const char c : packed.substr(0, head))
        size = size << 8 | static_cast<unsigned char>(c);
    if (packed.size() < head || size > most_growth * packed.size()) return {};
    std::string bytes(size, '\0');
    const int code = uncompress(reinterpret_cast<Bytef*>(bytes.data()), &size,
                                reinterpret_cast<const Bytef*>(packed.data() + head),
                                uLong(packed.size() - head));
    return code == Z_OK ? bytes : std::string();
}

/// For processors that store numbers as the file does, with the lowest byte first.
class PartReader {
public:
    explicit PartReader(std::string bytes) : bytes_(std::move(bytes)) {}

    CadPart read() {
        if (text(8) != "LLTRUTH1") throw std::runtime_error("it is no file of a part");
        CadPart part;
        read_list(part.meshes, [&](PartMesh& mesh) { read(mesh); });
        read_list(part.views, [&](ExactView& view) { read(view); });
        return part;
    }

private:
    std::string text(std::size_t size) {
        if (size > bytes_.size() - place_) throw std::runtime_error("it ends too early");
        place_ += size;
        return bytes_.substr(place_ - size, size);
    }
    template <class Number>
    Number number() {
        Number value;
        std::memcpy(&value, text(sizeof value).data(), sizeof value);
        return value;
    }
    /// Grows as it reads, so that a wrong count ends at the file's end.
    template <class List, class ReadOne>
    void read_list(List& list, ReadOne read_one) {
        for (auto left = number<std::uint32_t>(); left > 0; --left)
            read_one(list.emplace_back());
    }
    void read(PartMesh& mesh) {
        mesh.linear = number<double>();
        mesh.angular = number<double>();
        read_list(mesh.mesh.positions, [&](Eigen::Vector3d& p) {
            for (double& x : p)
                x = double(number<float>());
        });
        read_list(mesh.mesh.triangles, [&](laplacian_lines::Triangle& triangle) {
            for (std::uint32_t& v : triangle)
                if ((v = number<std::uint32_t>()) >= mesh.mesh.positions.size())
                    throw std::runtime_error("a triangle has a vertex that is not there");
        });
    }
    void read(ExactView& view) {
        view.frame.side = line_drawing::Side::Other;
        view.frame.name = text(number<std::uint32_t>());
        number<std::uint32_t>();
        for (auto* axis : {&view.frame.right, &view.frame.up, &view.frame.towards_viewer})
            for (double& x : *axis)
                x = number<double>();
        read(view.required);
        read(view.allowed);
    }
    void read(PlaneLines& lines) {
        read_list(lines, [&](PlaneLine& line) {
            Eigen::Vector2i place(0, 0);
            read_list(line, [&](PlanePoint& p) {
                for (int& x : place)
                    x += number<std::int32_t>();
                p = place.cast<double>() / 1000;
            });
        });
    }

    const std::string bytes_;
    std::size_t place_ = 0;
};

}  // namespace

CadPart read_part(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    const std::string packed{std::istreambuf_iterator<char>(file), {}};
    try {
        CadPart part = PartReader(unpacked(packed)).read();
        part.name = std::filesystem::path(name).stem().string();
        return part;
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(name + " cannot be read: " + error.what());
    }
}

}  // namespace benchmarks
