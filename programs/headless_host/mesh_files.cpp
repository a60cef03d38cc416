// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_files.h"

#include <GL/glew.h>

#include <common/globals.h>
#include <common/ml_document/mesh_document.h>
#include <common/mlexception.h>
#include <common/plugins/plugin_manager.h>
#include <common/utilities/load_save.h>

#include <QFile>
#include <QFileInfo>

namespace server {

namespace {

void checkReadable(const QString& file) {
    QFile input(file);
    if (!input.open(QIODevice::ReadOnly))
        throw MLException(file + " cannot be read: " + input.errorString());
}

/// Asked before computing. Leaves no empty file behind.
void checkWritable(const QString& file) {
    const bool existed = QFileInfo::exists(file);
    QFile output(file);
    if (!output.open(QIODevice::WriteOnly | QIODevice::Append))
        throw MLException(file + " cannot be written: " + output.errorString());
    if (!existed) output.remove();
}

MeshModel& layerOf(const OutputMesh& output, MeshDocument& document) {
    if (output.layer == Layer::Current) {
        if (document.mm()) return *document.mm();
        throw MLException("There is no mesh to save as " + output.file);
    }
    const int layers = int(document.meshNumber());
    const int wanted = output.layer == Layer::Last ? layers - 1 : output.layer_number;
    int number = 0;
    for (MeshModel& mesh : document.meshIterator())
        if (number++ == wanted) return mesh;
    throw MLException(QString("There is no layer %1 to save as %2; the last one is %3")
                          .arg(QString::number(wanted), output.file, QString::number(layers - 1)));
}

/// Vertex attributes are offered as boxes that begin with V(f) or V(3f).
void chooseParameters(const OutputMesh& output, RichParameterList& parameters) {
    for (RichParameter& parameter : parameters) {
        if (!parameter.value().isBool()) continue;
        if (parameter.name() == "Binary")
            parameter.setValue(BoolValue(output.binary));
        else if (parameter.fieldDescription().startsWith("V("))
            parameter.setValue(BoolValue(output.attributes));
    }
}

/// MeshLab's DXF writer returns an error's number on success.
bool isCompleteDxfOfEdges(const QString& type, const MeshModel& mesh, const QString& file) {
    if (type != "dxf" || mesh.cm.fn > 0 || mesh.cm.en == 0) return false;
    const QByteArray end = "ENDSEC\n0\nEOF\n";
    QFile written(file);
    return written.open(QIODevice::ReadOnly) && written.seek(written.size() - end.size()) &&
           written.readAll() == end;
}

void write(const OutputMesh& output, MeshModel& mesh, GLLogStream& log) {
    const QString type = QFileInfo(output.file).suffix().toLower();
    IOPlugin* plugin = meshlab::pluginManagerInstance().outputMeshPlugin(type);
    if (!plugin) throw MLException("MeshLab cannot write files of the type of " + output.file);
    checkWritable(output.file);
    int possible = 0, usual = 0;
    plugin->exportMaskCapability(type, possible, usual);
    RichParameterList parameters = plugin->initSaveParameter(type, mesh);
    chooseParameters(output, parameters);
    if (output.mask & possible & vcg::tri::io::Mask::IOM_BITPOLYGONAL)
        mesh.updateDataMask(MeshModel::MM_FACEFACETOPO);
    plugin->setLog(&log);
    try {
        plugin->save(type, output.file, mesh, output.mask & possible, parameters);
    } catch (const MLException&) {
        if (!isCompleteDxfOfEdges(type, mesh, output.file)) throw;
    }
    if (QFileInfo(output.file).size() == 0) throw MLException(output.file + " was not written");
}

}  // namespace

void open(const Input& input, MeshDocument& document) {
    checkReadable(input.file);
    const unsigned int before = document.meshNumber();
    if (input.is_project)
        meshlab::loadProject(input.file, document, &document.Log);
    else
        meshlab::loadMeshWithStandardParameters(input.file, document);
    if (document.meshNumber() == before) throw MLException(input.file + " holds no mesh");
    int last = -1;
    for (MeshModel& mesh : document.meshIterator())
        last = mesh.id();
    document.setCurrentMesh(last);
}

void save(const OutputMesh& output, MeshDocument& document) {
    write(output, layerOf(output, document), document.Log);
}

void save(const OutputProject& output, MeshDocument& document) {
    const QString folder = QFileInfo(output.file).absolutePath();
    for (MeshModel& mesh : document.meshIterator()) {
        const QFileInfo old(mesh.fullName());
        const bool has_file = !mesh.fullName().isEmpty() && old.exists();
        OutputMesh copy;
        copy.mask = ~0;
        copy.file = has_file ? old.absolutePath() + '/' + old.completeBaseName()
                             : folder + '/' + mesh.label().remove(' ');
        if (!output.overwrite_meshes) copy.file += "_out";
        copy.file += has_file ? '.' + old.suffix() : QString(".ply");
        write(copy, mesh, document.Log);
        mesh.setFileName(copy.file);
        mesh.setLabel(QFileInfo(copy.file).fileName());
    }
    checkWritable(output.file);
    meshlab::saveProject(output.file, document, false);
}

}  // namespace server
