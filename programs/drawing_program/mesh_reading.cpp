// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_reading.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <utility>

#include "file_names.h"
#include "mesh_files/mesh_file.h"

namespace {

[[noreturn]] void refuse(const QString& file, const QString& why) {
    laplacian_lines::refuse(QString("%1: %2").arg(file, why).toStdString(),
                            laplacian_lines::ErrorCode::InvalidMesh);
}

std::optional<mesh_files::Format> formatOf(const QString& file) {
    return mesh_files::format_of(QFileInfo(file).suffix().toLower().toStdString());
}

}  // namespace

QStringList meshesOf(const QStringList& named) {
    QStringList meshes;
    for (const QString& name : named) {
        if (!QFileInfo(name).isDir()) {
            meshes << name;
            continue;
        }
        const QDir folder(name);
        const int before = meshes.size();
        for (const QString& file : folder.entryList(QDir::Files, QDir::Name))
            if (formatOf(file)) meshes << folder.filePath(file);
        if (meshes.size() == before)
            refuse(QString("there is no mesh in the folder \"%1\".").arg(name));
    }
    meshes.removeDuplicates();
    return meshes;
}

double expectedTriangles(const QString& name) {
    QFile file(name);
    const auto format = formatOf(name);
    if (!format || !file.open(QIODevice::ReadOnly)) return 0;
    const QByteArray begin = file.read(4096);  // more than most headers
    return mesh_files::expected_triangles(*format, {begin.constData(), std::size_t(begin.size())},
                                          double(file.size()));
}

ReadMesh readMesh(const QString& name, bool draws_damaged) {
    const auto format = formatOf(name);
    QFile file(name);
    if (!QFileInfo(name).isFile() || !file.open(QIODevice::ReadOnly))
        refuse(name, "there is no such file, or it cannot be read.");
    if (!format) refuse(name, "meshes are read from PLY, OBJ, STL and OFF files.");
    const QByteArray bytes = file.readAll();
    if (bytes.size() != file.size()) refuse(name, "it cannot be read to its end.");
    auto hash = std::async(std::launch::async, [own = bytes]() mutable {
        const QByteArray all = std::exchange(own, {});  // let go of at the end
        return QCryptographicHash::hash(all, QCryptographicHash::Sha256).toHex().toStdString();
    });
    mesh_files::MeshInFile read =
        mesh_files::read_mesh(*format, {bytes.constData(), std::size_t(bytes.size())});
    const std::size_t triangles = read.mesh.triangles.size();
    const QString defect = QString::fromStdString(read.defect),
                  remark = QString::fromStdString(read.remark);
    if (triangles == 0 && !defect.isEmpty())
        refuse(name, QString("the mesh cannot be read: %1.").arg(defect));
    if (triangles == 0)
        refuse(name, "the mesh has no faces; lines are drawn on surfaces." +
                         (remark.isEmpty() ? "" : " Of the file, " + remark + '.'));
    if (!defect.isEmpty() && !draws_damaged)
        refuse(name,
               QString("the file is damaged: %1. With --damaged draw, the %2 triangles before "
                       "that are drawn.")
                   .arg(defect)
                   .arg(triangles));
    return {std::move(read.mesh), defect, remark, hash.share()};
}
