// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before every header that might include gl.h

#include <QFile>
#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include <common/interfaces.h>
#include <wrap/io_trimesh/import_obj.h>

namespace vcg {
namespace tri {
namespace io {

/// Whether a zero-based index is one of `count` elements; negative ones in the file count from the
/// end. As in the reader of later versions, which for other indices makes faces vanish or reads
/// beyond the vertices. Files without texture coordinates may have faces with indices of some.
template <>
inline bool ImporterOBJ<CMeshO>::GoodObjIndex(int& index, const int count) {
    if (index < -1) index += count + 1;
    if (index >= 0 && index < count) return true;
    if (count > 0)
        throw std::runtime_error(
            "A face refers to a vertex, a normal or a texture coordinate that the file does not "
            "have.");
    index = 0;
    return false;
}

}  // namespace io
}  // namespace tri
}  // namespace vcg

namespace {

using Reader = vcg::tri::io::ImporterOBJ<CMeshO>;

/// The reader trusts the file.
void check_edges(CMeshO& mesh) {
    const auto is_vertex = [&](const CVertexO* vertex) {
        return vertex >= mesh.vert.data() && vertex < mesh.vert.data() + mesh.vert.size();
    };
    for (CEdgeO& edge : mesh.edge)
        if (!is_vertex(edge.V(0)) || !is_vertex(edge.V(1)))
            throw std::runtime_error("A line refers to a vertex that the file does not have.");
}

/// Returns what is wrong with a mesh that could be read, if anything.
QString read(const QString& file_name, MeshModel& mesh, int& mask, vcg::CallBackPos* progress) {
    const QByteArray name = QFile::encodeName(file_name);
    Reader::Info info;
    info.cb = progress;
    if (!Reader::LoadMask(name, info)) throw std::runtime_error("The file is empty or unreadable.");
    mesh.Enable(info.mask);
    const int result = Reader::Open(mesh.cm, name, info);
    if (Reader::ErrorCritical(result)) throw std::runtime_error(Reader::ErrorMsg(result));
    check_edges(mesh.cm);
    mesh.Enable(info.mask);  // the reader may have found polygons
    mask = info.mask;
    for (std::string& texture : mesh.cm.textures)
        std::replace(texture.begin(), texture.end(), '\\', '/');
    return result == Reader::E_NOERROR ? QString() : QString(Reader::ErrorMsg(result));
}

}  // namespace

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

QList<MeshIOInterface::Format> ObjImporter::importFormats() const {
    return {{"Alias Wavefront Object", "OBJ"}, {"Quad Object", "QOBJ"}};
}

bool ObjImporter::open(const QString&, const QString& file_name, MeshModel& mesh, int& mask,
                       const RichParameterList&, vcg::CallBackPos* progress, QWidget*) {
    mask = 0;
    try {
        errorMessage = read(file_name, mesh, mask, progress);
        return true;
    } catch (const std::exception& error) {
        errorMessage = error.what();  // which meshlabserver does not show
        std::fprintf(stderr, "%s: %s\n", qUtf8Printable(file_name), error.what());
        return false;
    }
}

MESHLAB_PLUGIN_NAME_EXPORTER(ObjImporter)

#include "obj_importer.moc"
