// SPDX-License-Identifier: GPL-3.0-or-later
#include "part_file.h"

#include <QByteArray>
#include <QDataStream>
#include <QFile>
#include <QFileInfo>
#include <QStringList>
#include <stdexcept>

namespace benchmarks {
namespace {

class PartReader {
public:
    explicit PartReader(const QByteArray& bytes) : bytes_(bytes), stream_(bytes_) {
        stream_.setByteOrder(QDataStream::LittleEndian);
        stream_.setFloatingPointPrecision(QDataStream::DoublePrecision);
    }

    CadPart read() {
        if (raw(8) != "LLTRUTH1") throw std::runtime_error("it is no file of a part");
        CadPart part;
        part.meshes.resize(count(20));
        for (PartMesh& mesh : part.meshes)
            read(mesh);
        part.views.resize(count(80));
        for (ExactView& view : part.views)
            read(view);
        if (!stream_.atEnd()) throw std::runtime_error("it goes on behind its end");
        return part;
    }

private:
    template <class Number>
    Number number() {
        Number value{};
        stream_ >> value;
        if (stream_.status() != QDataStream::Ok) throw std::runtime_error("it ends too early");
        return value;
    }
    /// Refuses more things of at least `bytes` each than the file can hold.
    std::size_t count(int bytes) {
        const auto value = number<quint32>();
        if (qint64(value) * bytes > bytes_.size()) throw std::runtime_error("a count is too large");
        return value;
    }
    QByteArray raw(std::size_t size) {
        QByteArray result(int(size), 0);
        if (stream_.readRawData(result.data(), int(size)) != int(size))
            throw std::runtime_error("it ends too early");
        return result;
    }
    float single() {
        stream_.setFloatingPointPrecision(QDataStream::SinglePrecision);
        const auto value = number<float>();
        stream_.setFloatingPointPrecision(QDataStream::DoublePrecision);
        return value;
    }

    void read(PartMesh& mesh) {
        mesh.linear = number<double>();
        mesh.angular = number<double>();
        mesh.mesh.positions.resize(count(12));
        for (Eigen::Vector3d& p : mesh.mesh.positions)
            for (double& x : p)
                x = double(single());
        mesh.mesh.triangles.resize(count(12));
        for (laplacian_lines::Triangle& triangle : mesh.mesh.triangles)
            for (std::uint32_t& v : triangle) {
                v = number<quint32>();
                if (v >= mesh.mesh.positions.size())
                    throw std::runtime_error("a triangle has a vertex that is not there");
            }
    }
    void read(ExactView& view) {
        view.name = raw(count(1)).toStdString();
        const auto direction_class = number<quint32>();
        if (direction_class >= direction_class_names.size())
            throw std::runtime_error("a view has a class that is not there");
        view.direction_class = DirectionClass(direction_class);
        for (Eigen::Vector3d* axis : {&view.frame.right, &view.frame.up, &view.frame.viewer})
            for (double& x : *axis)
                x = number<double>();
        read(view.demanded);
        read(view.allowed);
    }
    void read(PlaneLines& lines) {
        lines.resize(count(4));
        for (PlaneLine& line : lines) {
            Eigen::Vector2i place(0, 0);
            line.resize(count(8));
            for (PlanePoint& p : line) {
                for (int& x : place)
                    x += number<qint32>();
                p = place.cast<double>() / 1000;
            }
        }
    }

    const QByteArray bytes_;
    QDataStream stream_;
};

}  // namespace

CadPart read_part(const QString& name) {
    try {
        QFile file(name);
        if (!file.open(QIODevice::ReadOnly)) throw std::runtime_error("it cannot be opened");
        CadPart part = PartReader(qUncompress(file.readAll())).read();
        part.name = QFileInfo(name).completeBaseName().toStdString();
        return part;
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(name.toStdString() + " cannot be read: " + error.what());
    }
}

LeftOut::LeftOut(const QString& name) {
    QFile file(name);
    if (!file.open(QIODevice::ReadOnly | QIODevice::Text))
        throw std::runtime_error(name.toStdString() + " cannot be opened");
    while (!file.atEnd()) {
        const QString line = QString::fromUtf8(file.readLine()).trimmed();
        if (line.isEmpty() || line.startsWith('#')) continue;
        const QStringList words = line.split('\t');
        if (words.size() != 3 || words[2].isEmpty())
            throw std::runtime_error(
                name.toStdString() +
                " needs part, direction and reason, not: " + line.toStdString());
        entries_.insert({words[0].toStdString(), words[1].toStdString()});
    }
}

}  // namespace benchmarks
