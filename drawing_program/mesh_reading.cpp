// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_reading.h"

#include <vcg/complex/complex.h>
#include <wrap/io_trimesh/import.h>

#include <QFileInfo>

#include "laplacian_lines/error.h"

namespace {

class Vertex;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3d, vcg::vertex::Normal3d,
                                  vcg::vertex::BitFlags> {};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::BitFlags> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};

using Importer = vcg::tri::io::Importer<Mesh>;

[[noreturn]] void refuse(const QString& file, const QString& why) {
    throw laplacian_lines::Error(laplacian_lines::ErrorCode::InvalidMesh,
                                 QString("%1: %2").arg(file, why).toStdString());
}

bool isKnown(const QString& file) {
    return QStringList{"ply", "obj", "stl", "off"}.contains(QFileInfo(file).suffix().toLower());
}

}  // namespace

laplacian_lines::TriangleMesh readMesh(const QString& file) {
    if (!QFileInfo(file).isReadable()) refuse(file, "there is no such file, or it cannot be read.");
    if (!isKnown(file)) refuse(file, "meshes are read from PLY, OBJ, STL and OFF files.");
    Mesh mesh;
    int mask = 0;
    const int code = Importer::Open(mesh, file.toLocal8Bit().constData(), mask);
    if (code != 0 && Importer::ErrorCritical(code))
        refuse(file, QString("the mesh cannot be read: %1.").arg(Importer::ErrorMsg(code)));
    if (mesh.fn == 0) refuse(file, "the mesh has no faces; lines are drawn on surfaces.");
    laplacian_lines::TriangleMesh result;
    result.positions.reserve(mesh.vert.size());
    for (const Vertex& v : mesh.vert)
        result.positions.emplace_back(v.cP()[0], v.cP()[1], v.cP()[2]);
    for (const Face& f : mesh.face) {
        laplacian_lines::Triangle& triangle = result.triangles.emplace_back();
        for (int k = 0; k < 3; ++k)
            triangle[std::size_t(k)] = std::uint32_t(vcg::tri::Index(mesh, f.cV(k)));
    }
    return result;
}
