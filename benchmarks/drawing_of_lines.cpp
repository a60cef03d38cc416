// SPDX-License-Identifier: GPL-3.0-or-later
#include "drawing_of_lines.h"

#include <GL/glew.h>

#include <Eigen/Geometry>
#include <QImage>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <stdexcept>

#include "gl_context.h"
#include "known_functions.h"
#include "laplacian_lines/line_extractor.h"
#include "laplacian_lines/line_visibility.h"
#include "line_renderer/line_renderer.h"
#include "line_renderer/surface_depth.h"
#include "line_stream.h"
#include "orbit.h"
#include "stream_manner.h"
#include "turns.h"

bool findFunctions() {
    return glewInit() == GLEW_OK;
}

namespace benchmarks {
namespace {

using namespace laplacian_lines;
using line_renderer::LineAppearance;
using line_renderer::LinePlacement;

constexpr int width = 1000, height = 700, rounds = 7;
using Picture = std::vector<unsigned char>;

double best(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

/// A white picture of colors and depths that is drawn into as long as it lives.
class Paper {
public:
    Paper() {
        glGenFramebuffers(1, &framebuffer_);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
        for (const auto& [format, place] : {std::pair(GL_RGBA8, GL_COLOR_ATTACHMENT0),
                                            std::pair(GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT)}) {
            GLuint buffer = 0;
            glGenRenderbuffers(1, &buffer);
            glBindRenderbuffer(GL_RENDERBUFFER, buffer);
            glRenderbufferStorage(GL_RENDERBUFFER, GLenum(format), width, height);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, GLenum(place), GL_RENDERBUFFER, buffer);
        }
        glViewport(0, 0, width, height);
        glEnable(GL_DEPTH_TEST);
    }
    void clear(GLbitfield what) const {
        glClearColor(1, 1, 1, 1);
        glClear(what);
    }
    Picture content() const {
        Picture pixels(4 * width * height);
        glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
        return pixels;
    }

private:
    GLuint framebuffer_ = 0;
};

/// With the mesh in the middle, of which the diagonal is a little larger than the view.
LinePlacement placementOf(const View& view, const Eigen::Vector3d& centre, const Field& field,
                          double zoom) {
    const double far = 1e3, near = 1e-2, focal = zoom * 2.5;
    const Eigen::Vector3d back = (view.eye - centre).normalized();
    const Eigen::Vector3d right = Eigen::Vector3d::UnitY().cross(back).normalized();
    LinePlacement placement;
    placement.to_eye.setIdentity();
    placement.to_eye.topLeftCorner<3, 3>() << right.transpose(), back.cross(right).transpose(),
        back.transpose();
    placement.to_eye.topRightCorner<3, 1>() = -(placement.to_eye.topLeftCorner<3, 3>() * view.eye);
    const double unit = field.scale.diagonal;
    placement.projection << focal * height / width, 0, 0, 0, 0, focal, 0, 0, 0, 0,
        -(far + near) / (far - near), -2 * far * near / (far - near) * unit, 0, 0, -1, 0;
    placement.diagonal = unit;
    placement.sight_edge = sight_edge(field);
    return placement;
}

class Drawing {
public:
    Drawing(const TriangleMesh& mesh, const Field& field, const DrawingOptions& options)
        : field_(field),
          options_(options),
          surface_(line_renderer::makeSurface(mesh, field)),
          extractor_(mesh, field) {
        for (const Eigen::Vector3d& p : mesh.positions)
            if (p.allFinite()) box_.extend(p);
        for (auto& look : appearance_.looks)
            look.color = Qt::black;
        if (options.is_dashed) appearance_.hidden = line_renderer::HiddenLines::Dashed;
    }

    void compare(const View& view, DrawingComparison& result) {
        placement_ = placementOf(view, box_.center(), field_, options_.zoom);
        result.extraction += 1e3 * seconds([&] { extract(view); });
        result.length += lengthOnScreen();
        prepareDepths();
        const double tolerances[] = {0, options_.tolerance};
        DrawingFigures* const figures[] = {&result.all, &result.simplified};
        Picture pictures[2];
        std::vector<double> drawing[2], writing[2];
        for (int round = 0; round < rounds; ++round)
            for (int turn = 0; turn < 2; ++turn) {
                const int i = (round + turn) % 2;
                placement_.tolerance = tolerances[i];
                writing[i].push_back(1e3 * seconds([&] { writeInMemory(); }));
                drawing[i].push_back(drawOnce());
                if (round == 0) pictures[i] = paper_.content();
            }
        for (int i = 0; i < 2; ++i) {
            figures[i]->writing += best(writing[i]);
            figures[i]->drawing += best(drawing[i]);
            placement_.tolerance = tolerances[i];
            figures[i]->segments += double(writeInMemory());
        }
        compare(pictures[0], pictures[1], result);
        if (options_.pictures.empty() || is_saved_) return;
        save(pictures[0], options_.pictures + "/all_points.png");
        save(pictures[1], options_.pictures + "/simplified.png");
        is_saved_ = true;
    }

private:
    void extract(const View& view) {
        extractor_.extract(view, LineStyle(), scratch_, lines_);
        stream_.resize(line_renderer::streamLength(lines_));
    }

    void prepareDepths() {
        glMatrixMode(GL_PROJECTION);
        glLoadMatrixd(placement_.projection.data());
        glMatrixMode(GL_MODELVIEW);
        glLoadMatrixd(placement_.to_eye.data());
        line_renderer::SurfaceLayer layer;
        layer.surface = surface_;
        layer.diagonal = placement_.diagonal;
        paper_.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        buffers_.draw(layer);
        glBindBuffer(GL_ARRAY_BUFFER, 0);
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, 0);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        depth_.forgetDepthBuffer();
        placement_.depths = depth_.copy();
        glFinish();
    }

    std::size_t writeInMemory() {
        return line_renderer::writeStream(
                   lines_,
                   line_renderer::streamManner(appearance_, placement_,
                                               {width / 2.0f, height / 2.0f}),
                   stream_.data()) -
               3 * lines_.lines.size();
    }

    /// Milliseconds without writing.
    double drawOnce() {
        paper_.clear(GL_COLOR_BUFFER_BIT);
        renderer_.upload(lines_, appearance_, placement_);
        glFinish();
        return 1e3 * seconds([&] {
                   line_renderer::RedrawClock clock;
                   renderer_.draw(appearance_, placement_, clock);
                   glFinish();
               });
    }

    double lengthOnScreen() const {
        const Eigen::Matrix4d to_clip = placement_.projection * placement_.to_eye;
        const auto place = [&](const LinePoint& point) -> Eigen::Vector2d {
            const Eigen::Vector4d clip = to_clip * point.position.cast<double>().homogeneous();
            return clip.head<2>().cwiseProduct(Eigen::Vector2d(width / 2.0, height / 2.0)) /
                   clip.w();
        };
        double length = 0;
        for (const Polyline& line : lines_.lines)
            for (std::uint32_t i = line.first + 1; i < line.first + line.count; ++i)
                length += (place(lines_.points[i]) - place(lines_.points[i - 1])).norm();
        return length;
    }

    static void save(const Picture& picture, const std::string& file) {
        const QImage image(picture.data(), width, height, QImage::Format_RGBX8888);
        if (!image.mirrored().save(QString::fromStdString(file)))
            throw std::runtime_error("cannot write " + file);
    }

    static void compare(const Picture& a, const Picture& b, DrawingComparison& result) {
        double sum = 0, differing = 0, above[3] = {};
        for (std::size_t i = 0; i < a.size(); i += 4) {
            const int difference = std::abs(int(a[i]) - int(b[i]));
            result.greatest_difference = std::max(result.greatest_difference, difference);
            sum += difference;
            differing += difference > 0;
            for (int k = 0; k < 3; ++k)
                above[k] += difference > (32 << k);
        }
        result.mean_difference += differing > 0 ? sum / differing : 0;
        for (int k = 0; k < 3; ++k)
            result.above[std::size_t(k)] += above[k] / (width * height);
    }

    const Field& field_;
    const DrawingOptions options_;
    GlContext context_;
    Paper paper_;
    Eigen::AlignedBox3d box_;
    line_renderer::SurfacePointer surface_;
    LineExtractor extractor_;
    ExtractionScratch scratch_;
    LineSet lines_;
    LineAppearance appearance_;
    LinePlacement placement_;
    line_renderer::SurfaceBuffers buffers_;
    line_renderer::SurfaceDepth depth_;
    line_renderer::LineRenderer renderer_;
    std::vector<line_renderer::StreamPoint> stream_;
    bool is_saved_ = false;
};

}  // namespace

DrawingComparison compareDrawings(const TriangleMesh& mesh, const Field& field,
                                  const DrawingOptions& options) {
    Drawing drawing(mesh, field, options);
    const std::vector<View> views = orbit(mesh);
    const int eyes = std::clamp(options.eyes, 1, int(views.size()));
    DrawingComparison result;
    for (int i = 0; i < eyes; ++i)
        drawing.compare(views[std::size_t(i) * views.size() / std::size_t(eyes)], result);
    for (double* sum :
         {&result.all.segments, &result.all.writing, &result.all.drawing,
          &result.simplified.segments, &result.simplified.writing, &result.simplified.drawing,
          &result.length, &result.extraction, &result.mean_difference, &result.above[0],
          &result.above[1], &result.above[2]})
        *sum /= eyes;
    return result;
}

}  // namespace benchmarks
