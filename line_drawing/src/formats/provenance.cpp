// SPDX-License-Identifier: GPL-3.0-or-later
#include "line_drawing/provenance.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

#include "laplacian_lines/version.h"
#include "line_drawing/words.h"

namespace line_drawing {
namespace {

const char* const begin = "{\"laplacian_lines\":";  // the first key, as keys are sorted

/// JSON has numbers for all characters.
QString inPlainCharacters(const QString& json) {
    QString plain;
    for (const QChar c : json)
        if (c.unicode() < 127 && !QString("<>&").contains(c))
            plain += c;
        else
            plain += QString("\\u%1").arg(c.unicode(), 4, 16, QChar('0'));
    return plain;
}

/// The object at the beginning of these bytes.
QJsonObject objectIn(const QByteArray& bytes) {
    QJsonParseError error;
    QJsonDocument::fromJson(bytes, &error);  // tells where it ends
    return QJsonDocument::fromJson(bytes.left(error.offset)).object();
}

}  // namespace

QString provenanceText(const std::vector<Provenance::Mesh>& meshes,
                       const std::optional<QStringList>& options) {
    QJsonArray list;
    for (const Provenance::Mesh& mesh : meshes) {
        QJsonObject entry{{"name", mesh.name}};
        if (!mesh.sha256.isEmpty()) entry["sha256"] = QString::fromLatin1(mesh.sha256);
        list << entry;
    }
    QJsonObject object{{"laplacian_lines", laplacian_lines::version()}, {"meshes", list}};
    if (options) object["options"] = QJsonArray::fromStringList(*options);
    return inPlainCharacters(QJsonDocument(object).toJson(QJsonDocument::Compact));
}

Provenance provenanceOf(const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly)) refuse(QString("\"%1\" cannot be read.").arg(name));
    const QByteArray bytes = file.readAll().replace("\n999\n", "");  // where DXF continues a line
    const int place = bytes.indexOf(begin);
    const QJsonObject object = place < 0 ? QJsonObject() : objectIn(bytes.mid(place));
    if (object.isEmpty())
        refuse(QString("\"%1\" does not say how it was drawn: only SVG, PDF and DXF files of "
                       "version 0.3 and later do.")
                   .arg(name));
    Provenance result;
    result.version = object["laplacian_lines"].toString();
    for (const QJsonValue mesh : object["meshes"].toArray())
        result.meshes.push_back({mesh["name"].toString(), mesh["sha256"].toString().toLatin1()});
    if (object.contains("options")) {
        result.options.emplace();
        for (const QJsonValue word : object["options"].toArray())
            *result.options << word.toString();
    }
    return result;
}

}  // namespace line_drawing
