// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_dialog.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace {

const char* const group = "LaplacianLinesDrawing";
const QString mesh_key = "mesh";
const QStringList keys_of_mesh = {"file", "title", "unit"};

/// `file` with the extension of `other`.
QString withEndingOf(const QString& other, const QString& file) {
    const QFileInfo info(file);
    const QString ending = QFileInfo(other).suffix();
    return ending.isEmpty() ? file : info.dir().filePath(info.completeBaseName() + "." + ending);
}

}  // namespace

void keepSettings(const DrawingParameters& applied, const QString& mesh) {
    QSettings settings;
    settings.beginGroup(group);
    settings.setValue(mesh_key, mesh);
    for (const DrawingField& field : fieldsOf(applied))
        settings.setValue(field.key, field.text);
}

std::vector<DrawingField> keptSettings(const DrawingParameters& fresh, const QString& mesh) {
    QSettings settings;
    settings.beginGroup(group);
    const bool is_same = !mesh.isEmpty() && settings.value(mesh_key).toString() == mesh;
    std::vector<DrawingField> kept;
    for (DrawingField field : fieldsOf(fresh)) {
        if (!settings.contains(field.key)) continue;
        const QString text = settings.value(field.key).toString();
        if (is_same || !keys_of_mesh.contains(field.key))
            field.text = text;
        else if (field.key == keys_of_mesh.first())
            field.text = withEndingOf(text, field.text);
        kept.push_back(field);
    }
    return kept;
}
