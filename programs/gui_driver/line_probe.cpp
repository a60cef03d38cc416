// SPDX-License-Identifier: GPL-3.0-or-later
#include <GL/glew.h>  // before any other GL header

#include "line_probe.h"

#include <laplacian_lines/line_extractor.h>
#include <laplacian_lines/line_visibility.h>
#include <laplacian_lines/precompute.h>
#include <meshlab_host/meshlab_api.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core_lines.h"

namespace driver {
namespace {

using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::TriangleMesh;
using laplacian_lines::View;

// In box diagonals: lines this far behind all around them must be hidden, those that nothing covers
// by more than a quarter of it must be seen; others may be either.
constexpr double depth_tolerance = 0.01;

// Fainter lines, or thinner in shares of full width, may leave no pixel that counts as ink.
constexpr float least_opacity = 0.9f, least_weight = 0.25f;

// Pixels along the view's edge without samples.
constexpr double edge = 3;

bool nearEdge(double x, double y, int width, int height, double distance) {
    return x < distance || y < distance || x > width - 1 - distance || y > height - 1 - distance;
}

/// Fills the depth buffer with faces, whatever MeshLab shows: they hide lines in any render mode.
void drawDepth(const CMeshO& mesh, const Eigen::Matrix4d& modelview) {
    glPushAttrib(GL_ALL_ATTRIB_BITS);
    glMatrixMode(GL_MODELVIEW);
    glPushMatrix();
    glLoadMatrixd(modelview.data());
    glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LESS);
    glDepthMask(GL_TRUE);
    glDisable(GL_CULL_FACE);
    glBegin(GL_TRIANGLES);
    for (const CFaceO& face : mesh.face)
        for (int corner = 0; corner < 3 && !face.IsD(); ++corner)
            glVertex3f(face.cP(corner)[0], face.cP(corner)[1], face.cP(corner)[2]);
    glEnd();
    glPopMatrix();
    glPopAttrib();
}

/// Camera and depths of the current redraw.
class Screen {
public:
    explicit Screen(const CMeshO& mesh) {
        glGetDoublev(GL_MODELVIEW_MATRIX, modelview_.data());
        glGetDoublev(GL_PROJECTION_MATRIX, projection_.data());
        glGetIntegerv(GL_VIEWPORT, viewport_);
        Eigen::Matrix4d layer;
        for (int r = 0; r < 4; ++r)
            for (int c = 0; c < 4; ++c)
                layer(r, c) = mesh.Tr.ElementAt(r, c);
        modelview_ = (modelview_ * layer).eval();
        diagonal_ =
            mesh.bbox.Diag() * std::cbrt(std::abs(modelview_.topLeftCorner<3, 3>().determinant()));
        drawDepth(mesh, modelview_);
        depths_.resize(std::size_t(width()) * height());
        glPixelStorei(GL_PACK_ALIGNMENT, 4);
        glReadPixels(viewport_[0], viewport_[1], width(), height(), GL_DEPTH_COMPONENT, GL_FLOAT,
                     depths_.data());
    }

    View view() const {
        // The eye is what M = projection·modelview maps to x = y = w = 0; a direction if
        // orthographic.
        const Eigen::Matrix4d m = projection_ * modelview_;
        Eigen::Matrix<double, 3, 4> rows;
        rows << m.row(0), m.row(1), m.row(3);
        const Eigen::Vector4d e = rows.fullPivLu().kernel().col(0);
        if (std::abs(e[3]) > 1e-9 * e.head<3>().norm())
            return View::perspective(e.head<3>() / e[3]);
        // Towards the viewer: eye-space z grows.
        const Eigen::Vector3d d = e.head<3>();
        return View::orthographic(modelview_.row(2).head<3>().dot(d) > 0 ? d : Eigen::Vector3d(-d));
    }

    // What the matrix maps to the direction in the picture.
    Eigen::Vector3d fromPicture(const Eigen::Vector3d& direction) const {
        return modelview_.topLeftCorner<3, 3>().fullPivLu().solve(direction);
    }

    /// `tolerance`: how far behind the surface a line may be and still show, in D.
    void add(const LinePoint& a, const LinePoint& b, double tolerance,
             ProjectedLines& lines) const {
        const Eigen::Vector4d eye_a = modelview_ * a.position.cast<double>().homogeneous(),
                              eye_b = modelview_ * b.position.cast<double>().homogeneous();
        const bool faint = std::min(a.opacity, b.opacity) < least_opacity ||
                           std::min(a.weight, b.weight) < least_weight;
        const double length = (pixel(eye_a) - pixel(eye_b)).norm();
        const int steps = 1 + int(std::min(length, 4096.) * 2);
        for (int i = 0; i <= steps; ++i) {
            const Eigen::Vector4d p = eye_a + (eye_b - eye_a) * (double(i) / steps);
            const Eigen::Vector2d at = pixel(p);
            if (nearEdge(at.x(), at.y(), width(), height(), edge)) continue;
            const Sight seen = sight(p, at, tolerance);
            lines.samples.push_back({at, faint && seen == Sight::Visible ? Sight::Unsure : seen});
        }
    }

private:
    int width() const { return viewport_[2]; }
    int height() const { return viewport_[3]; }

    Eigen::Vector3d window(const Eigen::Vector4d& eye_space) const {
        const Eigen::Vector4d clip = projection_ * eye_space;
        return clip.head<3>() / clip[3] * 0.5 + Eigen::Vector3d::Constant(0.5);
    }
    Eigen::Vector2d pixel(const Eigen::Vector4d& eye_space) const {
        const Eigen::Vector3d w = window(eye_space);
        return {w.x() * width(), (1 - w.y()) * height()};
    }
    double depthMoved(Eigen::Vector4d eye_space, double towards_eye) const {
        eye_space.z() += towards_eye;
        return window(eye_space).z();
    }

    Sight sight(const Eigen::Vector4d& p, const Eigen::Vector2d& at, double tolerance) const {
        const double near = depthMoved(p, tolerance * diagonal_);
        bool behind_all = true;
        for (int dy = -2; dy <= 2; ++dy)
            for (int dx = -2; dx <= 2; ++dx)
                behind_all = behind_all && depth(at, dx, dy) < near;
        if (behind_all) return Sight::Hidden;
        const bool seen = depth(at, 0, 0) > depthMoved(p, depth_tolerance / 4 * diagonal_);
        return seen ? Sight::Visible : Sight::Unsure;
    }

    double depth(const Eigen::Vector2d& at, int dx, int dy) const {
        const int x = int(at.x()) + dx, y = height() - 1 - (int(at.y()) + dy);
        return depths_[std::size_t(y) * width() + x];
    }

    Eigen::Matrix4d modelview_, projection_;
    GLint viewport_[4];
    double diagonal_ = 0;  // of the layer, in eye coordinates
    std::vector<float> depths_;
};

}  // namespace

ProjectedLines probeLayer(const MeshModel& mesh, const ProbeOptions& options) {
    const TriangleMesh triangles = liveTriangles(mesh.cm);
    laplacian_lines::PrecomputeOptions field_options = options.field;
    field_options.curvature_derivatives |= options.style.shows.needs_derivatives();
    const laplacian_lines::Field field = laplacian_lines::precompute(triangles, field_options);
    const laplacian_lines::LineExtractor extractor(triangles, field);
    const Screen screen(mesh.cm);
    laplacian_lines::ExtractionScratch scratch;
    LineSet lines;
    View view = screen.view();
    if (!options.light.isZero()) view.light = screen.fromPicture(options.light);
    extractor.extract(view, options.style, scratch, lines);
    ProjectedLines projected;
    projected.lines = int(lines.lines.size());
    for (const laplacian_lines::Polyline& line : lines.lines) {
        const double clearance = laplacian_lines::sight_clearance(
            line.kind, 1, laplacian_lines::sight_edge(field) / field.scale.diagonal);
        for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
            screen.add(lines.points[i - 1], lines.points[i],
                       std::max(depth_tolerance, 1.1 * clearance), projected);
    }
    return projected;
}

namespace {

/// Pixels within `reach` of a marked one.
class PixelMask {
public:
    PixelMask(int width, int height) : width_(width), height_(height), set_(width * height, 0) {}

    void mark(const Eigen::Vector2d& at, double reach) {
        const int r = int(std::ceil(reach));
        for (int y = int(at.y()) - r; y <= int(at.y()) + r; ++y)
            for (int x = int(at.x()) - r; x <= int(at.x()) + r; ++x)
                if (x >= 0 && y >= 0 && x < width_ && y < height_ &&
                    std::hypot(x + 0.5 - at.x(), y + 0.5 - at.y()) <= reach)
                    set_[y * width_ + x] = 1;
    }
    bool operator()(int x, int y) const { return set_[y * width_ + x]; }

private:
    int width_, height_;
    std::vector<char> set_;
};

/// Near the ink's colour, so that blends with paper or surface count.
bool hasInk(QRgb pixel, const QColor& ink) {
    const int off =
        std::max({std::abs(qRed(pixel) - ink.red()), std::abs(qGreen(pixel) - ink.green()),
                  std::abs(qBlue(pixel) - ink.blue())});
    return off < 110;
}

}  // namespace

ProbeResult compareWithPicture(const std::vector<ProjectedLines>& layers, const QImage& picture,
                               const QColor& ink, double reach) {
    const int width = picture.width(), height = picture.height();
    PixelMask near_ink(width, height), near_line(width, height);
    ProbeResult result;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (hasInk(picture.pixel(x, y), ink)) near_ink.mark({x + 0.5, y + 0.5}, reach);
    for (const ProjectedLines& layer : layers)
        for (const ProjectedSample& sample : layer.samples) {
            if (sample.sight == Sight::Hidden) continue;
            near_line.mark(sample.pixel, reach + 1);
            if (sample.sight != Sight::Visible) continue;
            ++result.expected;
            result.found += near_ink(int(sample.pixel.x()), int(sample.pixel.y()));
        }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            if (!hasInk(picture.pixel(x, y), ink)) continue;
            ++result.inked;
            // ink near the edge may belong to a line beyond it
            if (!nearEdge(x, y, width, height, edge + reach + 1))
                result.unexplained += !near_line(x, y);
        }
    return result;
}

}  // namespace driver
