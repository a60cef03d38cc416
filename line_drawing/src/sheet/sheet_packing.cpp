// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>

#include "line_drawing/make_sheet.h"
#include "line_drawing/words.h"

namespace line_drawing {
namespace {

constexpr std::uint32_t magic = 0x4c4c5334;  // "LLS4"

/// Native numbers: packed sheets stay on this machine.
class Packing {
public:
    template <class Number>
    void operator()(const Number& number) {
        static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
        bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
    }
    void operator()(const std::string& text) {
        (*this)(std::uint32_t(text.size()));
        bytes += text;
    }
    void operator()(const Eigen::Vector2d& p) { (*this)(p.x()), (*this)(p.y()); }
    template <class Item, class Pack>
    void each(const std::vector<Item>& items, const Pack& pack) {
        (*this)(std::uint32_t(items.size()));
        for (const Item& item : items)
            pack(item);
    }

    std::string bytes;
};

class Unpacking {
public:
    explicit Unpacking(std::string_view bytes) : rest_(bytes) {}

    template <class Number>
    void operator()(Number& number) {
        static_assert(std::is_arithmetic_v<Number> || std::is_enum_v<Number>);
        std::memcpy(&number, take(sizeof number).data(), sizeof number);
    }
    void operator()(std::string& text) {
        std::uint32_t size = 0;
        (*this)(size);
        text = take(size);
    }
    void operator()(Eigen::Vector2d& p) { (*this)(p.x()), (*this)(p.y()); }
    template <class Item, class Unpack>
    void each(std::vector<Item>& items, const Unpack& unpack) {
        std::uint32_t count = 0;
        (*this)(count);
        for (std::uint32_t i = 0; i < count; ++i)
            unpack(items.emplace_back());
    }

private:
    std::string_view take(std::size_t size) {
        if (size > rest_.size()) refuse("This packed sheet is not whole.");
        const std::string_view taken = rest_.substr(0, size);
        rest_.remove_prefix(size);
        return taken;
    }

    std::string_view rest_;
};

/// Shared by packing and unpacking.
template <class Way, class Kept>
void pass(Way& way, Kept& sheet) {
    way(sheet.size), way(sheet.title), way(sheet.scale);
    way.each(sheet.groups, [&](auto& group) {
        way(group.key), way(group.name);
        way.each(group.layers, [&](auto& layer) {
            way(layer.key), way(layer.name);
            way.each(layer.paths, [&](auto& path) {
                way(path.pen_width), way(path.dash), way(path.tone), way(path.path.fill_rule);
                way.each(path.path.pieces, [&](auto& piece) {
                    way(piece.step), way(piece.end), way(piece.first), way(piece.second);
                });
            });
        });
    });
}

}  // namespace

std::string packSheet(const Sheet& sheet) {
    Packing packing;
    packing(magic);
    pass(packing, sheet);
    return packing.bytes;
}

Sheet unpackSheet(const std::string& bytes) {
    Unpacking unpacking(bytes);
    std::uint32_t begin = 0;
    if (bytes.size() >= sizeof begin) unpacking(begin);
    if (begin != magic) refuse("This is not a packed sheet.");
    Sheet sheet;
    pass(unpacking, sheet);
    return sheet;
}

}  // namespace line_drawing
