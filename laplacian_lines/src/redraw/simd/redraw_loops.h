// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>

#include "clusters/cluster_data.h"
#include "laplacian_lines/line_kind.h"
#include "rules/line_rules.h"

/// The inner loops of a redraw: what goes in and out of them, and what they work in. Plain data
/// only, see cluster_data.h.
namespace laplacian_lines {

/// Kinds of lines that are found anew at each redraw, as strips in the clusters: the zeros of a
/// function of the vertices. Arrays by kind are in this order. What the kinds are:
/// simd_kinds.h, simd_apparent.h.
constexpr LineKind kStripKinds[] = {LineKind::Laplacian,         LineKind::Contour,
                                    LineKind::SuggestiveContour, LineKind::SuggestiveHighlight,
                                    LineKind::PhoticExtremum,    LineKind::ApparentRidge};
constexpr unsigned kStripKindCount = sizeof(kStripKinds) / sizeof(kStripKinds[0]);

/// Kinds that are found together, in one pass over the clusters: successive ones of kStripKinds. A
/// pass of which no kind is wanted costs nothing.
struct StripPass {
    unsigned first, count;
};
constexpr StripPass kStripPasses[] = {{0, 2}, {2, 2}, {4, 1}, {5, 1}};
constexpr unsigned kStripPassCount = sizeof(kStripPasses) / sizeof(kStripPasses[0]);
constexpr unsigned kMostKindsOfPass = 2;

/// Where the eye and the light are in homogeneous local coordinates (x, y, z, w), scaled so that
/// n·(eye − w p), which is meant by n·eye below, is about in [−1, 1]; and which zeros become lines.
struct ExtractionTask {
    float eye[4], light[4];
    bool light_at_eye;
    struct Wanted {
        bool lines;                 ///< any of this kind
        float least_scaled_facing;  ///< vertices with n·eye below surely face away
        LineRules rules;
    } kinds[kStripKindCount];
};

/// A point of a strip: what a LinePoint is made of. Local position.
struct StripPoint {
    float position[3];
    float slope;     ///< of the segment that ends here; 0 at the first point
    float gradient;  ///< ‖∇I‖, of apparent ridges q1
    float opacity;   ///< less than 1 where the crossing alone asks for fading
};

/// A piece of a line within a cluster; the positive side of functions with signs is on its left.
struct Strip {
    static constexpr std::uint32_t kNoEdge = 0xffffffffu, kClosed = 0xfffffffeu,
                                   kContinued = 0xfffffffdu;
    std::uint32_t first_point, point_count;
    /// Edges where first and last point lie and other clusters' strips may go on, or kNoEdge.
    /// kContinued: the strip before, or the one after, goes on there. kClosed: at the beginning of
    /// a strip and at the end of it or of a later one, which are one point.
    std::uint32_t edges[2];
    float length, strength, slope;  ///< sums over segments; slope times length
    float concave;                  ///< of whole lines, see LinePiece
};

/// Where extract_strips() appends. There must be place for kStripsOfBatch and kPointsOfBatch more.
struct StripOutput {
    Strip* strips;
    StripPoint* points;
    std::uint32_t strip_count, point_count;
};

constexpr unsigned kBatch = 16;  ///< clusters that are worked on together
constexpr unsigned kBatchVertices = kBatch * kClusterVertices;
constexpr unsigned kBatchTriangles = kBatch * kClusterTriangles;
constexpr unsigned kStripsOfBatch = kBatchTriangles;
constexpr unsigned kPointsOfBatch = 2 * kStripsOfBatch;

/// A cluster that can hold a line, and what has to be known of it.
struct KeptCluster {
    std::uint32_t number;
    bool test_facing;                 ///< n·eye may be negative or below a kind's bound
    bool may_hold[kMostKindsOfPass];  ///< a line of the kind, by its place in the pass
};

constexpr unsigned kNumbersOfSlot = 256;  ///< of triangles and edges: more than kClusterNumbers

/// A triangle in which a function changes its sign, by places in the batch: its slot times
/// kClusterVertices or kNumbersOfSlot, and numbers of vertices, or of triangles and edges. The
/// crossing where the line leaves lies between vertices exit[0], where the function is negative,
/// and exit[1]; likewise where it enters. Apparent ridges have no signs: the ends are in any order.
struct alignas(16) ActiveTriangle {
    std::uint16_t exit[2], third;  ///< and the vertex not in exit
    std::uint16_t own;             ///< the triangle
    std::uint16_t entry[2];
    std::uint16_t successor, previous;  ///< across exit and entry, as ClusterTriangle::neighbours
};

// Arrays below with kPlaces are longer than what they can hold, so that whole vectors may be read
// and written, and those of one float a place by an odd number of cache units, so that their
// beginnings differ in cache sets: the arrays of one struct are read at the same place together.

/// The active triangles of one function in a batch, cluster by cluster.
struct ActiveTriangles {
    static constexpr unsigned kPlaces = kBatchTriangles + 48;
    unsigned count;
    alignas(64) ActiveTriangle triangles[kPlaces];
};

/// Clusters that are worked on together, each in a slot.
struct Batch {
    unsigned count;
    const Cluster* clusters[kBatch];
    const VertexRecord* records;               ///< the store's memory
    std::uint32_t record_offsets[kBatch];      ///< by slot, from places of vertices, modulo 2^32
    alignas(64) float facing[kBatchVertices];  ///< n·eye, slot by slot
    /// The functions whose zeros are wanted, likewise, by the kinds' places in the pass; not of
    /// kinds for which that is n·eye.
    alignas(64) float values[kMostKindsOfPass][kBatchVertices];
    ActiveTriangles active[kMostKindsOfPass];
};

/// The records of the cluster in a slot, by the places of its vertices in the batch.
struct RecordsOfSlot {
    const VertexRecord* records;
    std::uint32_t offset;
};
static inline const float* position_at(const RecordsOfSlot& of, unsigned place) {
    return of.records[std::uint32_t(place + of.offset)].position;
}
static inline RecordsOfSlot records_around(const Batch& batch, unsigned place) {
    return {batch.records, batch.record_offsets[place / kClusterVertices]};
}

/// Crossings of one function in a batch.
struct CrossingMemory {
    static constexpr unsigned kPlaces = 2 * kBatchTriangles + 48;
    std::uint16_t ends[kPlaces][2];                    ///< places of vertices, negative first
    alignas(64) float below[kPlaces], above[kPlaces];  ///< values at the ends
    alignas(64) float share[kPlaces];                  ///< of the second end, 0..1
    /// n·l with the kind's source() l; n·eye, only where l is a light elsewhere: else `lit` is
    /// that.
    alignas(64) float lit[kPlaces], facing[kPlaces];
    alignas(64) float position[3][kPlaces];
    alignas(64) float g[3][kPlaces];  ///< ∇I = S l; after a test() whose kSlope is not Scaled d,
                                      ///< see SegmentSlope
    alignas(64) float gradient[kPlaces], opacity[kPlaces];
    alignas(64) float concave[kPlaces];  ///< of whole lines: −l·Sl/‖t‖ of l's tangential part t
    std::uint64_t accepted[kPlaces / 64 + 1];  ///< a bit for each
    alignas(64) float points[kPlaces][4];      ///< position, and StripPoint::gradient
};

/// Segments of one function in a batch.
struct SegmentMemory {
    static constexpr unsigned kPlaces = kBatchTriangles + 80;
    static constexpr std::uint16_t kNone = 0xffff;
    std::uint16_t triangle[kPlaces];  ///< place in ActiveTriangles, and of the crossing at the end
    std::uint16_t begin[kPlaces];     ///< crossing
    alignas(64) float g[3][kPlaces];  ///< sum of those of both ends
    alignas(64) float u[3][kPlaces];  ///< first to second corner
    alignas(64) float v[3][kPlaces];  ///< first to third corner
    alignas(64) float fu[kPlaces], fv[kPlaces];  ///< differences of the function
    alignas(64) float slope[kPlaces];            ///< < 0: refused, or of whole lines a phantom
    alignas(64) float sums[kPlaces][4];          ///< as in Strip
    std::uint16_t next[kPlaces];   ///< segment, or kNone; the last place takes what has none before
    std::uint16_t first[kPlaces];  ///< segments that follow on none
    bool is_written[kPlaces];      ///< in a strip
    /// What ends at a crossing: a segment, or kNone.
    alignas(64) std::uint16_t ending[CrossingMemory::kPlaces];
    /// The place in ActiveTriangles by place in the batch, or kNone.
    alignas(64) std::uint16_t in_triangle[kBatch * kNumbersOfSlot];
};

/// What apparent ridges have at the vertices of a batch, slot by slot.
struct ApparentMemory {
    alignas(64) float q[kBatchVertices];           ///< q1, 0 at what faces away
    alignas(64) float vectors[kBatchVertices][4];  ///< r, and the derivative of q1 along it
    alignas(64) float crossing_q[CrossingMemory::kPlaces];
};

/// What extract_strips() works in; one for each thread.
struct SimdMemory {
    Batch batch;
    CrossingMemory crossings;
    SegmentMemory segments;
    ApparentMemory apparent;
};

/// How the kinds of one of kStripPasses are found.
struct StripFunctions {
    /// Writes to `kept` those of the clusters [begin, end) that can hold a line, and returns their
    /// number. `begin` and `end` are multiples of kFormGroup, or the end of all; `kept` needs a
    /// place for each cluster.
    std::size_t (*cull)(const ClusterStore&, const ExtractionTask&, std::size_t begin,
                        std::size_t end, KeptCluster* kept);
    /// Finds the strips of up to kBatch clusters; an output for each kind of the pass.
    void (*extract_strips)(const ClusterStore&, const ExtractionTask&, const KeptCluster* clusters,
                           std::size_t count, SimdMemory&, StripOutput* outputs);
};

/// See simd_sets.h.
struct RedrawLoops {
    StripFunctions passes[kStripPassCount];
};

}  // namespace laplacian_lines
