// SPDX-License-Identifier: GPL-3.0-or-later
#include <QDataStream>

#include "line_drawing/contact_sheet.h"
#include "line_drawing/words.h"

namespace line_drawing {
namespace {

constexpr quint32 magic = 0x4c4c5333;  // "LLS3"

template <class Item, class Read>
std::vector<Item> readAll(QDataStream& stream, const Read& read) {
    quint32 count = 0;
    stream >> count;
    std::vector<Item> items;
    for (quint32 i = 0; i < count && stream.status() == QDataStream::Ok; ++i)
        items.push_back(read());
    return items;
}

}  // namespace

QByteArray packSheet(const Sheet& sheet) {
    QByteArray bytes;
    QDataStream stream(&bytes, QIODevice::WriteOnly);
    stream.setVersion(QDataStream::Qt_5_6);
    stream << magic << sheet.size << sheet.title << sheet.scale << quint32(sheet.groups.size());
    for (const SheetGroup& group : sheet.groups) {
        stream << group.key << group.name << quint32(group.layers.size());
        for (const SheetLayer& layer : group.layers) {
            stream << layer.key << layer.name << quint32(layer.paths.size());
            for (const SheetPath& path : layer.paths)
                stream << path.path << path.pen_width << path.dash << path.tone;
        }
    }
    return bytes;
}

Sheet unpackSheet(const QByteArray& bytes) {
    QDataStream stream(bytes);
    stream.setVersion(QDataStream::Qt_5_6);
    quint32 begin = 0;
    Sheet sheet;
    stream >> begin;
    if (begin != magic) refuse("This is not a packed sheet.");
    stream >> sheet.size >> sheet.title >> sheet.scale;
    sheet.groups = readAll<SheetGroup>(stream, [&] {
        SheetGroup group;
        stream >> group.key >> group.name;
        group.layers = readAll<SheetLayer>(stream, [&] {
            SheetLayer layer;
            stream >> layer.key >> layer.name;
            layer.paths = readAll<SheetPath>(stream, [&] {
                SheetPath path;
                stream >> path.path >> path.pen_width >> path.dash >> path.tone;
                return path;
            });
            return layer;
        });
        return group;
    });
    if (stream.status() != QDataStream::Ok) refuse("This packed sheet is not whole.");
    return sheet;
}

}  // namespace line_drawing
