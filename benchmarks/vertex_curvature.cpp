// SPDX-License-Identifier: GPL-3.0-or-later
// S. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004.
#include "vertex_curvature.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <cmath>

namespace benchmarks {
namespace {

using Eigen::Matrix2f;
using Eigen::Vector2f;
using Eigen::Vector3f;
using laplacian_lines::Triangle;
using Cubic = Eigen::Vector4f;  ///< as VertexCurvature::derivative

/// A tangent plane with a basis; u × v = n.
struct Frame {
    Vector3f u, v, n;

    Vector2f project(const Vector3f& x) const { return {u.dot(x), v.dot(x)}; }
};

Frame frame_of_normal(const Vector3f& n) {
    const Vector3f u = n.unitOrthogonal();
    return {u, n.cross(u), n};
}

/// Columns: the basis of `to` in that of `from`, after the smallest rotation that makes their
/// planes one.
Matrix2f change_of_basis(const Frame& from, const Frame& to) {
    const auto turn = Eigen::Quaternionf::FromTwoVectors(to.n, from.n);
    Matrix2f basis;
    basis << from.project(turn * to.u), from.project(turn * to.v);
    return basis;
}

float apply(const Cubic& c, const Vector2f& x, const Vector2f& y, const Vector2f& z) {
    return c[0] * x[0] * y[0] * z[0] +
           c[1] * (x[0] * y[0] * z[1] + x[0] * y[1] * z[0] + x[1] * y[0] * z[0]) +
           c[2] * (x[0] * y[1] * z[1] + x[1] * y[0] * z[1] + x[1] * y[1] * z[0]) +
           c[3] * x[1] * y[1] * z[1];
}

/// One triangle; edge k is opposite to corner k.
struct Face {
    std::array<Vector3f, 3> edges;
    Frame frame;
    std::array<float, 3> weights;  ///< the corners' shares of the area
    bool usable;

    Face(const PlainMesh& mesh, const Triangle& t) {
        for (int k = 0; k < 3; ++k)
            edges[k] = mesh.positions[t[(k + 2) % 3]] - mesh.positions[t[(k + 1) % 3]];
        const Vector3f cross = edges[0].cross(edges[1]);
        const float doubled_area = cross.norm();
        usable = doubled_area > 0 && std::isfinite(doubled_area);
        if (!usable) return;
        frame.n = cross / doubled_area;
        frame.u = edges[0].normalized();
        frame.v = frame.n.cross(frame.u);
        set_weights(doubled_area / 2);
    }

private:
    /// Voronoi areas; of a triangle with an obtuse corner half for that and a quarter each for the
    /// others, as M. Meyer et al., "Discrete Differential-Geometry Operators", 2003.
    void set_weights(float area) {
        std::array<float, 3> part;  // of edge k at each of its ends: |e|² cot(opposite) / 8
        for (int k = 0; k < 3; ++k) {
            const float dot = -edges[(k + 1) % 3].dot(edges[(k + 2) % 3]);
            if (dot < 0) {
                weights.fill(area / 4);
                weights[k] = area / 2;
                return;
            }
            part[k] = edges[k].squaredNorm() * dot / (16 * area);
        }
        for (int k = 0; k < 3; ++k)
            weights[k] = part[(k + 1) % 3] + part[(k + 2) % 3];
    }
};

/// S of a triangle from the differences of the normals along its edges: S e = Δn.
Matrix2f fitted_tensor(const Face& face, const Triangle& t, const std::vector<Vector3f>& normals) {
    Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
    Vector3f right = Vector3f::Zero();
    for (int k = 0; k < 3; ++k) {
        const Vector2f e = face.frame.project(face.edges[k]);
        const Vector2f dn = face.frame.project(normals[t[(k + 2) % 3]] - normals[t[(k + 1) % 3]]);
        Eigen::Matrix<float, 2, 3> rows;
        rows << e[0], e[1], 0, 0, e[0], e[1];
        squares += rows.transpose() * rows;
        right += rows.transpose() * dn;
    }
    const Vector3f s = squares.ldlt().solve(right);
    Matrix2f tensor;
    tensor << s[0], s[1], s[1], s[2];
    return tensor;
}

/// C of a triangle from the differences of S along its edges: C(e, ·, ·) = ΔS.
Cubic fitted_derivative(const Face& face, const std::array<Matrix2f, 3>& corners) {
    Eigen::Matrix4f squares = Eigen::Matrix4f::Zero();
    Cubic right = Cubic::Zero();
    for (int k = 0; k < 3; ++k) {
        const Vector2f e = face.frame.project(face.edges[k]);
        const Matrix2f ds = corners[(k + 2) % 3] - corners[(k + 1) % 3];
        Eigen::Matrix<float, 3, 4> rows;
        rows << e[0], e[1], 0, 0, 0, e[0], e[1], 0, 0, 0, e[0], e[1];
        squares += rows.transpose() * rows;
        right += rows.transpose() * Vector3f(ds(0, 0), ds(0, 1), ds(1, 1));
    }
    return squares.ldlt().solve(right);
}

/// The mean over a vertex's triangles, in its frame.
template <class Value>
struct Mean {
    Value sum = Value::Zero();
    float weight = 0;

    void add(float w, const Value& value) {
        sum += w * value;
        weight += w;
    }
    Value value() const { return weight > 0 ? Value(sum / weight) : Value(Value::Zero()); }
};

std::vector<Matrix2f> vertex_tensors(const PlainMesh& mesh, const std::vector<Vector3f>& normals,
                                     const std::vector<Frame>& frames) {
    std::vector<Mean<Matrix2f>> means(normals.size());
    for (const Triangle& t : mesh.triangles) {
        const Face face(mesh, t);
        if (!face.usable) continue;
        const Matrix2f tensor = fitted_tensor(face, t, normals);
        for (int k = 0; k < 3; ++k) {
            const Matrix2f r = change_of_basis(face.frame, frames[t[k]]);
            means[t[k]].add(face.weights[k], r.transpose() * tensor * r);
        }
    }
    std::vector<Matrix2f> tensors;
    for (const auto& mean : means)
        tensors.push_back(mean.value());
    return tensors;
}

/// Turns the frame into the tensor's principal directions and returns the curvatures along them.
std::array<float, 2> diagonalize(const Matrix2f& s, Frame& frame) {
    const float angle = std::atan2(2 * s(0, 1), s(0, 0) - s(1, 1)) / 2;
    const Vector2f d(std::cos(angle), std::sin(angle)), across(-d[1], d[0]);
    const Vector3f u = d[0] * frame.u + d[1] * frame.v;
    frame = {u, frame.n.cross(u), frame.n};
    return {d.dot(s * d), across.dot(s * across)};
}

std::vector<Mean<Cubic>> derivatives(const PlainMesh& mesh, const std::vector<Frame>& frames,
                                     const std::vector<VertexCurvature>& vertices) {
    std::vector<Mean<Cubic>> means(vertices.size());
    for (const Triangle& t : mesh.triangles) {
        const Face face(mesh, t);
        if (!face.usable) continue;
        std::array<Matrix2f, 3> corners;
        for (int k = 0; k < 3; ++k) {
            const auto& [k1, k2] = vertices[t[k]].curvatures;
            const Matrix2f r = change_of_basis(frames[t[k]], face.frame);
            corners[k] = r.transpose() * Vector2f(k1, k2).asDiagonal() * r;
        }
        const Cubic c = fitted_derivative(face, corners);
        for (int k = 0; k < 3; ++k) {
            const Matrix2f r = change_of_basis(face.frame, frames[t[k]]);
            const Vector2f x = r.col(0), y = r.col(1);
            means[t[k]].add(face.weights[k], Cubic(apply(c, x, x, x), apply(c, x, x, y),
                                                   apply(c, x, y, y), apply(c, y, y, y)));
        }
    }
    return means;
}

}  // namespace

std::vector<VertexCurvature> vertex_curvatures(const PlainMesh& mesh,
                                               const std::vector<Vector3f>& normals) {
    std::vector<Frame> frames;
    for (const Vector3f& n : normals)
        frames.push_back(frame_of_normal(n));
    const std::vector<Matrix2f> tensors = vertex_tensors(mesh, normals, frames);
    std::vector<VertexCurvature> vertices(normals.size());
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        vertices[v].curvatures = diagonalize(tensors[v], frames[v]);
        vertices[v].directions = {frames[v].u, frames[v].v};
    }
    const auto means = derivatives(mesh, frames, vertices);
    for (std::size_t v = 0; v < vertices.size(); ++v)
        Cubic::Map(vertices[v].derivative.data()) = means[v].value();
    return vertices;
}

}  // namespace benchmarks
