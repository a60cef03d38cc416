// SPDX-License-Identifier: GPL-3.0-or-later
#include "earlier_drawing.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <algorithm>

#include "command_line.h"
#include "laplacian_lines/version.h"
#include "mesh_reading.h"

using line_drawing::refuse;
using line_drawing::SourceMesh;

namespace {

/// The object that the file's line of provenance begins with.
QJsonObject provenanceIn(const std::string& name) {
    const std::optional<std::string> read = contentsOf(name);
    if (!read) refuse("\"" + name + "\" cannot be read.");
    const QByteArray bytes = QByteArray::fromStdString(line_drawing::provenanceIn(*read));
    QJsonParseError error;
    QJsonDocument::fromJson(bytes, &error);  // tells where it ends
    const QJsonObject object = QJsonDocument::fromJson(bytes.left(error.offset)).object();
    if (object.isEmpty())
        refuse("\"" + name +
               "\" does not say how it was drawn: only SVG, PDF and DXF files of version 0.3 and "
               "later do.");
    return object;
}

/// Files come from anywhere: they must not name other files.
bool isOption(const std::string& word) {
    return word.substr(0, 2) == "--" && word != "--" && word != "--like";
}

}  // namespace

EarlierDrawing earlierDrawing(const std::string& file) {
    const QJsonObject object = provenanceIn(file);
    const auto text = [](const QJsonValue& value) { return value.toString().toStdString(); };
    EarlierDrawing earlier{text(object["laplacian_lines"]), {}, {}};
    for (const QJsonValue mesh : object["meshes"].toArray())
        earlier.meshes.push_back({text(mesh["name"]), text(mesh["sha256"])});
    for (const QJsonValue word : object["options"].toArray())
        earlier.options.push_back(text(word));
    bool are_pairs = object.contains("options") && earlier.options.size() % 2 == 0;
    for (std::size_t i = 0; are_pairs && i < earlier.options.size(); i += 2)
        are_pairs = isOption(earlier.options[i]);
    if (!are_pairs)
        refuse("\"" + file + "\" has no options of this command: it was drawn in another way.");
    return earlier;
}

void sayWhatDiffers(const EarlierDrawing& earlier, const std::vector<SourceMesh>& meshes) {
    if (earlier.version != laplacian_lines::version())
        say(stderr, "the file was drawn by version " + earlier.version + "; this is version " +
                        laplacian_lines::version());
    if (earlier.meshes.size() != meshes.size())
        say(stderr, "the file was drawn from " + std::to_string(earlier.meshes.size()) +
                        " meshes; now there are " + std::to_string(meshes.size()));
    for (const SourceMesh& mesh : meshes)
        if (std::none_of(earlier.meshes.begin(), earlier.meshes.end(),
                         [&](const SourceMesh& m) { return m.sha256 == mesh.sha256; }))
            say(stderr,
                mesh.name + " is not the mesh that the file was drawn from: its contents differ");
}
