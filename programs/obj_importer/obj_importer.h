// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>  // before every header that might include gl.h

#include <common/interfaces.h>

/// MeshLab's own reader (VCGlib's headers) with one function mended: in MeshLab 2020.09 it takes a
/// file's first vertex for none, loses its faces and then trips an assertion, for nearly every
/// file. MeshLab 2022.02 and later do not need this.
class ObjImporter : public QObject, public MeshIOInterface {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESH_IO_INTERFACE_IID)
    Q_INTERFACES(MeshIOInterface)

public:
    QString pluginName() const override { return "LaplacianLinesObjImporter"; }
    QList<Format> importFormats() const override;
    QList<Format> exportFormats() const override { return {}; }
    void GetExportMaskCapability(QString&, int&, int&) const override {}

    /// On failure errorMessage has the reason. The working folder has to be the file's, for its
    /// materials.
    bool open(const QString& format, const QString& file_name, MeshModel& mesh, int& mask,
              const RichParameterList& parameters, vcg::CallBackPos* progress,
              QWidget* parent) override;
    bool save(const QString&, const QString&, MeshModel&, int, const RichParameterList&,
              vcg::CallBackPos*, QWidget*) override {
        return false;
    }
};
