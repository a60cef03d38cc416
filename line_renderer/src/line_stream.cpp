// SPDX-License-Identifier: GPL-3.0-or-later
// Lines as the vertex shader reads them: all points one behind the other, each line between two
// marked ones, to which no segment is drawn. Points are left out where the line between others
// differs by less than the tolerances (straight_piece.h). Outlines come last, to lie on top of the
// others; threads write parts of the stream.
#include "line_stream.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>

#include "laplacian_lines/line_visibility.h"
#include "laplacian_lines/threads.h"
#include "laplacian_lines/view.h"
#include "straight_piece.h"

namespace line_renderer {

using laplacian_lines::LineKind;
using laplacian_lines::LinePoint;
using laplacian_lines::LineSet;
using laplacian_lines::Polyline;

namespace {

/// Tolerance of a simplified line's depth, in its clearance.
constexpr double kDepthShare = 0.25;

constexpr float kLeastShare = 0.35f;  // of the radius, which is left at weight 0

LineTolerance tolerance_of(const LinePlacement& placement) {
    LineTolerance result;
    result.distance = float(placement.tolerance);
    const Eigen::Matrix4d& p = placement.projection;
    // Change of depth in -1..1 with the distance from the eye, times w².
    const double slope = std::abs(p(2, 2) * p(3, 3) - p(2, 3) * p(3, 2));
    for (std::size_t look = 0; look < result.depth.size(); ++look)
        result.depth[look] = float(kDepthShare * slope * line_clearance(look, placement));
    return result;
}

StreamPoint at(const LinePoint& point, float radius, LineKind kind, float along) {
    const Eigen::Vector3f& p = point.position;
    return {{p.x(), p.y(), p.z()}, radius, point.opacity, float(kind), along};
}

float tapered_radius(float full, float weight) {
    return full * (kLeastShare + (1 - kLeastShare) * std::clamp(weight, 0.0f, 1.0f));
}

/// The mark of a segment: 0, or one of the marks of mesh edges.
float mark_of(const Polyline& line, const LinePoint& from, const LinePoint& to) {
    if (line.kind == LineKind::Border) return kEdgeMark;
    if (line.kind == LineKind::Crease) return line.slope < 0 ? kAwayMark : kEdgeMark;
    if (!laplacian_lines::follows_edge(line.kind, from, to)) return 0;
    // −0 at both ends of a hollow edge, see LinePoint::gradient
    return std::signbit(from.gradient) && std::signbit(to.gradient) ? kAwayMark : kEdgeMark;
}

class LineOnScreen {
public:
    LineOnScreen(const StreamSettings& settings, LineKind kind)
        : settings_(settings),
          full_radius_(settings.radii.at(std::size_t(kind))),
          depth_tolerance_(settings.tolerance.depth.at(std::size_t(kind))) {}

    SeenPoint see(const LinePoint& point) const {
        const Eigen::Vector4f clip = settings_.to_clip * point.position.homogeneous();
        const LineTolerance& tolerance = settings_.tolerance;
        SeenPoint seen;
        seen.values = {0, tapered_radius(full_radius_, point.weight), point.opacity};
        seen.is_before_near_plane = clip.w() > 0 && clip.z() > -clip.w();
        if (!seen.is_before_near_plane) return seen;
        const float nearness = 1 / clip.w();
        seen.pixel = clip.head<2>().cwiseProduct(settings_.half_viewport) * nearness;
        seen.values[SeenDepth] = clip.z() * nearness;
        seen.tolerance = {depth_tolerance_ * nearness * nearness, tolerance.radius,
                          tolerance.opacity};
        return seen;
    }

private:
    const StreamSettings& settings_;
    const float full_radius_;
    const float depth_tolerance_;
};

float length_between(const SeenPoint& a, const SeenPoint& b) {
    return a.is_before_near_plane && b.is_before_near_plane ? (b.pixel - a.pixel).norm() : 0;
}

/// Writes the points that are needed.
class StreamWriter {
public:
    StreamWriter(const StreamSettings& settings, StreamPoint* stream)
        : settings_(settings), piece_(settings.tolerance.distance), begin_(stream), next_(stream) {}

    void write(const LinePoint* first, const LinePoint* last, const Polyline& line) {
        StreamPoint* const before = next_++;
        written_ = 0;
        write_points(first, last, line);
        StreamPoint* const after = next_++;
        // A closed line repeats its first point, so its neighbours are one further in.
        *before = before_last_;
        *after = second_;
        before->radius = after->radius = line.closed ? kNeighbourOnly : kNothingHere;
    }

    std::size_t length() const { return std::size_t(next_ - begin_); }

private:
    void put(const StreamPoint& point) {
        *next_++ = point;
        if (++written_ == 2) second_ = point;
        before_last_ = last_;
        last_ = point;
    }

    void put_start(StreamPoint candidate, float mark) {
        candidate.look += mark;
        put(candidate);
    }

    void write_points(const LinePoint* first, const LinePoint* last, const Polyline& line) {
        const LineOnScreen screen(settings_, line.kind);
        const bool keeps_all = settings_.tolerance.distance <= 0;
        SeenPoint seen = screen.see(*first);
        StreamPoint candidate = at(*first, seen.values[SeenRadius], line.kind, 0);
        float length = 0;
        float last_mark = mark_of(line, *first, first[1]);
        put_start(candidate, last_mark);
        piece_.begin(seen);
        for (const LinePoint* point = first + 1; point <= last; ++point) {
            const SeenPoint next = screen.see(*point);
            const float mark = mark_of(line, point[-1], *point);
            if (keeps_all ? point > first + 1 : mark != last_mark || !piece_.try_extend(next)) {
                put_start(candidate, mark);
                piece_.begin(seen);
                piece_.try_extend(next);
            }
            last_mark = mark;
            if (settings_.is_measured) length += length_between(seen, next);
            candidate = at(*point, next.values[SeenRadius], line.kind, length);
            seen = next;
        }
        put(candidate);
    }

    const StreamSettings& settings_;
    StraightPiece piece_;
    StreamPoint* const begin_;
    StreamPoint* next_;
    int written_ = 0;  ///< of the line
    StreamPoint second_{}, before_last_{}, last_{};
};

constexpr std::size_t kMostRuns = 4;        // of a set's lines, for threads
constexpr std::size_t kPointsOfRun = 4096;  // at least

bool is_drawn(const Polyline& line) {
    return line.count >= 2;
}

std::size_t most_points_of(const Polyline& line) {
    return is_drawn(line) ? line.count + 2 : 0;
}

/// Successive lines whose outlines, or others, are a part of a stream.
struct Run {
    std::size_t first_line = 0, last_line = 0;
    std::size_t lengths[2] = {};  ///< most points of others and of outlines
};
using Runs = std::array<Run, kMostRuns>;

/// Cuts lines in runs of about the same number of points; the last are empty if there are few.
Runs cut_in_runs(const LineSet& lines) {
    const std::size_t size = std::max(kPointsOfRun, stream_length(lines) / kMostRuns + 1);
    Runs runs;
    Run* run = runs.data();
    std::size_t length = 0;
    for (const Polyline& line : lines.lines) {
        if (length >= size && run != &runs.back()) {
            length = 0;
            const std::size_t begin = run->last_line;
            *++run = {begin, begin};
        }
        run->lengths[describe(line.kind).bounds_form] += most_points_of(line);
        length += most_points_of(line);
        ++run->last_line;
    }
    return runs;
}

std::size_t write_run(const LineSet& lines, const Run& run, bool outlines,
                      const StreamSettings& settings, StreamPoint* stream) {
    StreamWriter writer(settings, stream);
    for (std::size_t i = run.first_line; i < run.last_line; ++i) {
        const Polyline& line = lines.lines[i];
        if (!is_drawn(line) || describe(line.kind).bounds_form != outlines) continue;
        const LinePoint* first = lines.points.data() + line.first;
        writer.write(first, first + line.count - 1, line);
    }
    return writer.length();
}

}  // namespace

std::size_t stream_length(const LineSet& lines) {
    std::size_t length = 0;
    for (const Polyline& line : lines.lines)
        length += most_points_of(line);
    return length;
}

void write_stream(const LineSet& lines, const StreamSettings& settings, StreamPoint* stream,
                  std::vector<StreamPart>& parts) {
    const Runs runs = cut_in_runs(lines);
    parts.clear();
    std::size_t next = 0;
    for (const bool outlines : {false, true})  // on top of lines of other colors
        for (const Run& run : runs) {
            parts.push_back({next, 0});
            next += run.lengths[outlines];
        }
    const auto write_part = [&](std::size_t i) {
        parts[i].length = write_run(lines, runs[i % kMostRuns], i >= kMostRuns, settings,
                                    stream + parts[i].first);
    };
    laplacian_lines::in_parallel(parts.size(), std::ref(write_part));  // copies are allocated
}

LineRadii line_radii(const LineAppearance& appearance, double pixel_scale) {
    LineRadii result;
    for (std::size_t look = 0; look < result.size(); ++look)
        result[look] = float(appearance.looks[look].width * pixel_scale / 2);
    return result;
}

double line_clearance(std::size_t look, const LinePlacement& placement) {
    return laplacian_lines::mean_scale(placement.to_eye) *
           laplacian_lines::depth_bias(laplacian_lines::kLineKinds[look].kind, placement.diagonal,
                                       placement.depth_bias_edge);
}

StreamSettings stream_settings(const LineAppearance& appearance, const LinePlacement& placement,
                               const Eigen::Vector2f& half_viewport) {
    const Eigen::Matrix4d to_clip =
        placement.picture_to_clip.value_or(placement.projection * placement.to_eye);
    StreamSettings settings;
    settings.radii = line_radii(appearance, placement.pixel_scale);
    settings.to_clip = to_clip.cast<float>();
    settings.half_viewport = half_viewport;
    settings.tolerance = tolerance_of(placement);
    settings.is_measured = appearance.hidden == HiddenLines::Dashed;
    return settings;
}

}  // namespace line_renderer
