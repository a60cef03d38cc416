// SPDX-License-Identifier: GPL-3.0-or-later
#include "collection_items.h"

#include <QCoreApplication>
#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>

#include "file_names.h"
#include "line_drawing/make_sheet.h"
#include "line_drawing/whole_file.h"
#include "mesh_reading.h"

namespace {

QByteArray hashOfFile(const QString& name) {
    QFile file(name);
    QCryptographicHash hash(QCryptographicHash::Sha256);
    if (file.open(QIODevice::ReadOnly)) hash.addData(&file);
    return hash.result();
}

}  // namespace

std::vector<CollectionItem> itemsOf(const QStringList& named, const QStringList& options,
                                    const QStringList& taken_names) {
    const QStringList meshes = meshesOf(named);
    QMap<QString, int> counts;
    for (const QString& name : taken_names)
        ++counts[name];
    for (const QString& mesh : meshes)
        ++counts[QFileInfo(mesh).completeBaseName()];
    const QByteArray program = hashOfFile(QCoreApplication::applicationFilePath());
    std::vector<CollectionItem> items;
    QMap<QString, QString> names;
    for (const QString& mesh : meshes) {
        const QFileInfo info(mesh);
        const QString base = info.completeBaseName();
        const QString name = counts[base] > 1 ? info.fileName() : base;
        if (names.contains(name))
            refuse(QString("\"%1\" and \"%2\" have the same name, and so would their drawings.")
                       .arg(names[name], mesh));
        names[name] = mesh;
        QCryptographicHash key(QCryptographicHash::Sha256);
        key.addData(program);
        const QByteArray hash = hashOfFile(mesh);
        key.addData(hash);
        key.addData((options + QStringList{info.fileName()}).join('\n').toUtf8());
        items.push_back({mesh, name, hash, key.result().toHex()});
    }
    return items;
}

QString CollectionFolder::recordFolder() const {
    return QDir(path).filePath(".laplacian_lines");
}
QString CollectionFolder::drawingOf(const CollectionItem& item) const {
    return QDir(path).filePath(item.name + '.' + format);
}
QString CollectionFolder::viewOf(const CollectionItem& item) const {
    return QDir(recordFolder()).filePath(item.name + '.' + format + ".view");
}
QString CollectionFolder::recordOf(const CollectionItem& item) const {
    return QDir(recordFolder()).filePath(item.name + '.' + format + ".json");
}

bool CollectionFolder::isUpToDate(const CollectionItem& item) const {
    QFile record(recordOf(item));
    return QFileInfo::exists(drawingOf(item)) && QFileInfo::exists(viewOf(item)) &&
           record.open(QIODevice::ReadOnly) &&
           QJsonDocument::fromJson(record.readAll()).object()["key"].toString().toLatin1() ==
               item.key;
}

void CollectionFolder::remember(const CollectionItem& item) const {
    const QJsonObject record{{"mesh", QFileInfo(item.mesh).fileName()},
                             {"key", QString::fromLatin1(item.key)}};
    try {
        line_drawing::writeWhole(fileName(recordOf(item)),
                                 QJsonDocument(record).toJson().toStdString());
    } catch (const laplacian_lines::Error& error) {  // the drawing is there
        say(stderr, QString::fromUtf8(error.what()) + " It will be drawn again next time.");
    }
}

void CollectionFolder::forget(const CollectionItem& item) const {
    QFile::remove(recordOf(item));
}

line_drawing::Sheet CollectionFolder::readView(const CollectionItem& item) const {
    QFile file(viewOf(item));
    if (!file.open(QIODevice::ReadOnly)) refuse(file.fileName() + " cannot be read.");
    return line_drawing::unpackSheet(file.readAll().toStdString());
}
