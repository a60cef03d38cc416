// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <GL/glew.h>  // before every header that might include gl.h

#include <common/interfaces.h>

/// Reads OBJ files by the reader in MeshLab's own headers (VCGlib), with one function mended. The
/// reader that MeshLab 2020.09 was compiled with takes the first vertex of a file for none at all:
/// faces there get lost, and an assertion then ends the program, for practically every file.
/// MeshLab 2022.02 and later have no need of this.
class ObjImporter : public QObject, public MeshIOInterface {
    Q_OBJECT
    MESHLAB_PLUGIN_IID_EXPORTER(MESH_IO_INTERFACE_IID)
    Q_INTERFACES(MeshIOInterface)

public:
    QString pluginName() const override { return "LaplacianLinesObjImporter"; }
    QList<Format> importFormats() const override;
    QList<Format> exportFormats() const override { return {}; }
    void GetExportMaskCapability(QString&, int&, int&) const override {}

    /// False, with the reason in errorMessage, if the file cannot be read. The working folder has
    /// to be the file's, where its materials are looked for.
    bool open(const QString& format, const QString& file_name, MeshModel& mesh, int& mask,
              const RichParameterList& parameters, vcg::CallBackPos* progress,
              QWidget* parent) override;
    bool save(const QString&, const QString&, MeshModel&, int, const RichParameterList&,
              vcg::CallBackPos*, QWidget*) override {
        return false;
    }
};
