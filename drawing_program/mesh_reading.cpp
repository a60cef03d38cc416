// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_reading.h"

#include <vcg/complex/complex.h>
#include <wrap/io_trimesh/import_off.h>
#include <wrap/io_trimesh/import_ply.h>
#include <wrap/io_trimesh/import_stl.h>

#include <QDir>
#include <QFileInfo>
#include <functional>
#include <map>

#include "laplacian_lines/error.h"
#include "obj_reading.h"

namespace {

using laplacian_lines::TriangleMesh;

class Vertex;
class Face;
struct Types : vcg::UsedTypes<vcg::Use<Vertex>::AsVertexType, vcg::Use<Face>::AsFaceType> {};
class Vertex : public vcg::Vertex<Types, vcg::vertex::Coord3d, vcg::vertex::Normal3d,
                                  vcg::vertex::BitFlags> {};
class Face : public vcg::Face<Types, vcg::face::VertexRef, vcg::face::BitFlags> {};
class Mesh : public vcg::tri::TriMesh<std::vector<Vertex>, std::vector<Face>> {};

[[noreturn]] void refuse(const QString& file, const QString& why) {
    throw laplacian_lines::Error(laplacian_lines::ErrorCode::InvalidMesh,
                                 QString("%1: %2").arg(file, why).toStdString());
}

TriangleMesh copy(const Mesh& mesh) {
    TriangleMesh result;
    result.positions.reserve(mesh.vert.size());
    for (const Vertex& v : mesh.vert)
        result.positions.emplace_back(v.cP()[0], v.cP()[1], v.cP()[2]);
    result.triangles.reserve(mesh.face.size());
    for (const Face& f : mesh.face) {
        laplacian_lines::Triangle& triangle = result.triangles.emplace_back();
        for (int k = 0; k < 3; ++k)
            triangle[std::size_t(k)] = std::uint32_t(vcg::tri::Index(mesh, f.cV(k)));
    }
    return result;
}

/// By a reader of vcglib's.
template <class Importer>
TriangleMesh readBy(const QString& file) {
    Mesh mesh;
    int mask = 0;
    const int code = Importer::Open(mesh, file.toLocal8Bit().constData(), mask);
    if (code != 0 && mesh.fn == 0)
        refuse(file, QString("the mesh cannot be read: %1").arg(Importer::ErrorMsg(code)));
    return copy(mesh);
}

TriangleMesh readObjFile(const QString& file) {
    try {
        return readObj(file.toLocal8Bit().toStdString());
    } catch (const std::runtime_error& error) {
        refuse(file, QString("the mesh cannot be read: %1").arg(error.what()));
    }
}

/// By the ending of the file's name.
const std::map<QString, TriangleMesh (*)(const QString&)> readers = {
    {"ply", readBy<vcg::tri::io::ImporterPLY<Mesh>>},
    {"stl", readBy<vcg::tri::io::ImporterSTL<Mesh>>},
    {"off", readBy<vcg::tri::io::ImporterOFF<Mesh>>},
    {"obj", readObjFile}};

}  // namespace

QStringList meshesOf(const QStringList& named) {
    QStringList filters, meshes;
    for (const auto& reader : readers)
        filters << "*." + reader.first;
    for (const QString& name : named) {
        if (!QFileInfo(name).isDir()) {
            meshes << name;
            continue;
        }
        const QDir folder(name);
        const QStringList files = folder.entryList(filters, QDir::Files, QDir::Name);
        for (const QString& file : files)
            meshes << folder.filePath(file);
        if (files.isEmpty())
            throw laplacian_lines::Error(
                laplacian_lines::ErrorCode::InvalidOption,
                QString("there is no mesh in the folder \"%1\".").arg(name).toStdString());
    }
    meshes.removeDuplicates();
    return meshes;
}

TriangleMesh readMesh(const QString& file) {
    if (!QFileInfo(file).isReadable()) refuse(file, "there is no such file, or it cannot be read.");
    const auto reader = readers.find(QFileInfo(file).suffix().toLower());
    if (reader == readers.end()) refuse(file, "meshes are read from PLY, OBJ, STL and OFF files.");
    TriangleMesh mesh = reader->second(file);
    if (mesh.triangles.empty()) refuse(file, "the mesh has no faces; lines are drawn on surfaces.");
    return mesh;
}
