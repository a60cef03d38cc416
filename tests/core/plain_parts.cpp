// SPDX-License-Identifier: GPL-3.0-or-later
#include "plain_extraction.h"

#include <algorithm>

#include "redraw/hairpins.h"
#include "rules/line_acceptance.h"

namespace reference {

using namespace laplacian_lines;

namespace {

constexpr std::size_t kLongestPiece = 4;

bool goes_on(const PlainChain::Segment& a, const PlainChain::Segment& b) {
    return a.cluster == b.cluster && a.forward == b.forward;
}

/// A closed chain, starting where a cluster does.
PlainChain from_a_border(const PlainChain& chain) {
    const std::size_t count = chain.segments.size();
    for (std::size_t i = 0; chain.closed && i < count; ++i) {
        if (goes_on(chain.segments[(i + count - 1) % count], chain.segments[i])) continue;
        PlainChain turned = chain;
        const auto by = std::ptrdiff_t(i);
        turned.points.pop_back();
        std::rotate(turned.points.begin(), turned.points.begin() + by, turned.points.end());
        turned.points.push_back(turned.points.front());
        std::rotate(turned.segments.begin(), turned.segments.begin() + by, turned.segments.end());
        return turned;
    }
    return chain;
}

/// Of segments, piece after piece.
std::vector<std::size_t> pieces_of(const PlainChain& chain) {
    std::vector<std::size_t> pieces;
    const std::size_t count = chain.segments.size();
    for (std::size_t begin = 0, end; begin < count; begin = end) {
        end = begin + 1;
        while (end < count && goes_on(chain.segments[begin], chain.segments[end]))
            ++end;
        std::vector<std::size_t> run;
        for (std::size_t left = end - begin; left > 0; left -= run.back())
            run.push_back(std::min(left, kLongestPiece));
        if (!chain.segments[begin].forward) std::reverse(run.begin(), run.end());
        pieces.insert(pieces.end(), run.begin(), run.end());
    }
    return pieces;
}

class PartWriter {
public:
    PartWriter(const LineRules& rules, const PlainChain& chain, const Eigen::Vector3d& centre,
               double diagonal, std::vector<PlainLine>& lines)
        : rules_(rules),
          chain_(from_a_border(chain)),
          centre_(centre),
          diagonal_(diagonal),
          lines_(lines) {}

    void write_all() {
        std::vector<LinePiece> sums;
        for (const std::size_t segments : pieces_of(chain_)) {
            first_.push_back(first_.empty() ? 0 : first_.back() + segments_.back());
            segments_.push_back(segments);
            LinePiece sum{0, 0, 0, 0};
            for (std::size_t i = first_.back(); i < first_.back() + segments; ++i)
                add(chain_.segments[i].sums, sum);
            sums.push_back(sum);
        }
        finder_.find(rules_, sums, chain_.closed);
        for (const LinePart& part : finder_.parts())
            write(part);
    }

private:
    static void add(const LinePiece& piece, LinePiece& sum) {
        sum.length += piece.length;
        sum.slope += piece.slope;
        sum.gradient += piece.gradient;
        sum.concave += piece.concave;
    }

    /// With mean slopes as weights.
    PlainLine points_of(const LinePart& part) {
        PlainLine line{{}, {}, false};
        starts_.clear();
        const auto add_point = [&](std::size_t place, std::size_t piece, float t) {
            const auto between = [&](float a, float b) { return a + t * (b - a); };
            LinePoint point = chain_.points[place];
            point.weight = between(finder_.slope(piece), finder_.slope(piece + 1));
            point.opacity *= between(finder_.opacity(piece), finder_.opacity(piece + 1));
            line.points.push_back(point);
            starts_.push_back(between(finder_.opacity(piece), finder_.opacity(piece + 1)));
        };
        for (std::size_t i = 0; i < part.count; ++i) {
            const std::size_t piece = (part.begin + i) % segments_.size();
            if (i == 0) add_point(first_[piece], piece, 0);
            for (std::size_t k = 1; k <= segments_[piece]; ++k)
                add_point(first_[piece] + k, piece, float(k) / float(segments_[piece]));
        }
        return line;
    }

    void measure(std::size_t first_segment, std::uint32_t begin, std::uint32_t end, Polyline& p) {
        LinePiece sum{0, 0, 0, 0};
        for (std::size_t i = begin; i + 1 < end; ++i)
            add(chain_.segments[(first_segment + i) % chain_.segments.size()].sums, sum);
        p.kind = rules_.kind;
        p.first = begin;
        p.count = end - begin;
        p.length = sum.length;
        p.strength = sum.gradient;
        p.slope = sum.length > 0 ? sum.slope / sum.length : 0;
    }

    void write(const LinePart& part) {
        PlainLine line = points_of(part);
        const auto count = std::uint32_t(line.points.size());
        const std::size_t first_segment = first_[part.begin % segments_.size()];
        measure(first_segment, 0, count, line.polyline);
        line.polyline.closed = part.closed;
        if (!accepts(rules_, line.polyline)) return;
        std::vector<Polyline> cut = {line.polyline};
        if (fade_at_hairpins(line)) {
            cut.clear();
            for (const Hairpins::Range& range : hairpins_.ranges()) {
                Polyline p = line.polyline;
                if (range.end - range.begin < count) {
                    measure(first_segment, range.begin, range.end, p);
                    p.slope = line.polyline.slope;
                    p.closed = false;
                }
                if (accepts(rules_, p)) cut.push_back(p);
            }
        }
        finish_plainly(rules_, line.polyline, centre_, diagonal_, line.points.data());
        for (const Polyline& p : cut) {
            PlainLine of_range = line;
            of_range.polyline = p;
            of_range.points.assign(line.points.begin() + p.first,
                                   line.points.begin() + p.first + p.count);
            lines_.push_back(of_range);
        }
    }

    bool fade_at_hairpins(PlainLine& line) {
        std::vector<float> x, y, z, opacity;
        for (const LinePoint& p : line.points) {
            x.push_back(p.position.x());
            y.push_back(p.position.y());
            z.push_back(p.position.z());
            opacity.push_back(p.opacity);
        }
        LineColumns columns{};
        columns.x = x.data();
        columns.y = y.data();
        columns.z = z.data();
        if (rules_.cut_by_convex()) return false;
        if (!hairpins_.find(columns, line.polyline.count, rules_.kernel_size)) return false;
        hairpins_.fade(starts_.data(), opacity.data());
        for (std::size_t i = 0; i < opacity.size(); ++i)
            line.points[i].opacity = opacity[i];
        return true;
    }

    const LineRules& rules_;
    const PlainChain chain_;
    const Eigen::Vector3d& centre_;
    const double diagonal_;
    std::vector<PlainLine>& lines_;
    std::vector<std::size_t> first_, segments_;  // of pieces
    LinePartFinder finder_;
    Hairpins hairpins_;
    std::vector<float> starts_;
};

}  // namespace

void add_parts(const LineRules& rules, const PlainChain& chain, const Eigen::Vector3d& centre,
               double diagonal, std::vector<PlainLine>& lines) {
    PartWriter(rules, chain, centre, diagonal, lines).write_all();
}

}  // namespace reference
