// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_line.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "file_names.h"
#include "laplacian_lines/version.h"

using line_drawing::SourceMesh;

namespace {

/// Files come from anywhere: they must not name other files.
bool isOption(const QString& word) {
    return word.startsWith("--") && word != "--" && word != "--like" && word != "--contact-view";
}

/// Parses the object that these bytes begin with.
QJsonObject objectIn(const QByteArray& bytes) {
    QJsonParseError error;
    QJsonDocument::fromJson(bytes, &error);  // tells where it ends
    return QJsonDocument::fromJson(bytes.left(error.offset)).object();
}

QJsonObject provenanceIn(const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly)) refuse(QString("\"%1\" cannot be read.").arg(name));
    const QByteArray bytes = file.readAll().replace("\n999\n", "");  // where DXF continues a line
    const int place = bytes.indexOf(line_drawing::provenance_begin);
    const QJsonObject object = place < 0 ? QJsonObject() : objectIn(bytes.mid(place));
    if (object.isEmpty())
        refuse(QString("\"%1\" does not say how it was drawn: only SVG, PDF and DXF files of "
                       "version 0.3 and later do.")
                   .arg(name));
    return object;
}

}  // namespace

Provenance likeOf(const QString& file) {
    const QJsonObject object = provenanceIn(file);
    Provenance like{object["laplacian_lines"].toString(), {}, {}};
    for (const QJsonValue mesh : object["meshes"].toArray())
        like.meshes.push_back(
            {mesh["name"].toString().toStdString(), mesh["sha256"].toString().toStdString()});
    for (const QJsonValue word : object["options"].toArray())
        like.options << word.toString();
    bool are_pairs = object.contains("options") && like.options.size() % 2 == 0;
    for (int i = 0; are_pairs && i < like.options.size(); i += 2)
        are_pairs = isOption(like.options[i]);
    if (!are_pairs)
        refuse(QString("\"%1\" has no options of this command: it was drawn in another way.")
                   .arg(file));
    return like;
}

void sayWhatDiffers(const Provenance& like, const std::vector<SourceMesh>& meshes) {
    if (like.version != laplacian_lines::version())
        say(stderr, QString("the file was drawn by version %1; this is version %2")
                        .arg(like.version, laplacian_lines::version()));
    if (like.meshes.size() != meshes.size())
        say(stderr, QString("the file was drawn from %1 meshes; now there are %2")
                        .arg(like.meshes.size())
                        .arg(meshes.size()));
    for (const SourceMesh& mesh : meshes)
        if (std::none_of(like.meshes.begin(), like.meshes.end(),
                         [&](const SourceMesh& m) { return m.sha256 == mesh.sha256; }))
            say(stderr,
                QString("%1 is not the mesh that the file was drawn from: its contents differ")
                    .arg(inQt(mesh.name)));
}
