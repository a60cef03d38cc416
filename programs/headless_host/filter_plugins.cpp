// SPDX-License-Identifier: GPL-3.0-or-later
#include "filter_plugins.h"

#include <GL/glew.h>

#include <common/globals.h>
#include <common/ml_document/mesh_document.h>
#include <common/mlexception.h>
#include <common/plugins/plugin_manager.h>
#include <vcg/complex/algorithms/create/platonic.h>

#include <QDir>
#include <QFile>
#include <algorithm>

namespace server {

namespace {

QStringList filterNames() {
    QStringList names;
    for (FilterPlugin* plugin : meshlab::pluginManagerInstance().filterPluginIterator())
        for (QAction* action : plugin->actions())
            names << plugin->filterName(action);
    names.sort(Qt::CaseInsensitive);
    return names;
}

/// Words of four letters or more that `candidate` shares with `name`.
int wordsShared(const QString& name, const QString& candidate) {
    int shared = 0;
    for (const QString& word : name.split(' '))
        shared += word.size() >= 4 && candidate.contains(word, Qt::CaseInsensitive);
    return shared;
}

/// Nearest first.
QStringList namesLike(const QString& name) {
    QStringList found;
    for (const QString& candidate : filterNames())
        if (wordsShared(name, candidate)) found << candidate;
    std::stable_sort(found.begin(), found.end(), [&](const QString& a, const QString& b) {
        return wordsShared(name, a) > wordsShared(name, b);
    });
    return found.mid(0, 5);
}

/// Many filters rely on a mesh for their defaults.
void addTetrahedron(MeshDocument& document) {
    MeshModel* mesh = document.addNewMesh(QString(), "tetrahedron");
    vcg::tri::Tetrahedron(mesh->cm);
    mesh->updateBoxAndNormals();
}

QString describeParameters(const LoadedFilter& filter, MeshDocument& document) {
    QString text;
    try {
        document.mm()->updateDataMask(filter.plugin->getPreConditions(filter.action) |
                                      filter.plugin->getRequirements(filter.action));
        for (const RichParameter& parameter :
             filter.plugin->initParameterList(filter.action, document))
            text +=
                QString("    %1 (%2): %3\n")
                    .arg(parameter.name(), parameter.stringType(), parameter.fieldDescription());
    } catch (const std::exception&) {
        text = "    (parameters that depend on the mesh)\n";
    }
    return text;
}

}  // namespace

void loadPlugins(const QStringList& files, Report& report) {
    PluginManager& manager = meshlab::pluginManagerInstance();
    QStringList names;
    for (const QString& file : files) {
        manager.loadPlugin(file);
        names << QFileInfo(file).fileName();
    }
    const QDir folder(SERVER_PLUGIN_FOLDER);
    for (const QFileInfo& file : folder.entryInfoList({"libfilter_*.so", "libio_*.so"})) {
        if (names.contains(file.fileName())) continue;
        try {
            manager.loadPlugin(file.absoluteFilePath());
        } catch (const MLException& error) {
            report.error(QString("warning: %1").arg(error.what()));
        }
    }
}

LoadedFilter filterNamed(const QString& name) {
    for (FilterPlugin* plugin : meshlab::pluginManagerInstance().filterPluginIterator())
        for (QAction* action : plugin->actions())
            if (plugin->filterName(action) == name) return {plugin, action};
    QString message = QString("There is no filter \"%1\".").arg(name);
    const QStringList similar = namesLike(name);
    if (!similar.isEmpty()) message += " Similar ones: " + similar.join(", ");
    throw MLException(message);
}

void dumpFilters(const QString& file) {
    QFile output(file);
    if (!output.open(QIODevice::WriteOnly | QIODevice::Text))
        throw MLException("The list " + file + " cannot be written: " + output.errorString());
    MeshDocument document;
    addTetrahedron(document);
    for (const QString& name : filterNames())
        output.write((name + '\n' + describeParameters(filterNamed(name), document)).toUtf8());
}

}  // namespace server
