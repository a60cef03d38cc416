// SPDX-License-Identifier: GPL-3.0-or-later
// Compares measured drawings of meshes of every kind, 100 mm large, with what the meshes cover at
// 20 pixels per mm: how much of the border has no line within .15 mm, how much one within .8 mm,
// and how many jumps of depth lack one. Meshes are those of the tests, and files, each also beside
// its mirror image.
#include <cstdio>
#include <stdexcept>

#include "cube_directions.h"
#include "item_buffer.h"
#include "plane_canvas.h"
#include "program.h"
#include "silhouette_meshes.h"

namespace {

using namespace benchmarks;

constexpr double drawn_size = 100;     // mm, of the diagonal of the bounding box
constexpr double whole_share = 0.995;  // of a border that counts as drawn

struct Arguments {
    std::string only, pictures;
    std::vector<NamedFrame> directions;
    double most_bare = 100;
};

std::vector<Option> options_of(Arguments& a) {
    return {text("--only TEXT", "only meshes with this in their names", a.only),
            {"--from NAME", "a direction, as --+ or 23,31; repeated for more. Without it, a dozen",
             [&a](const std::string& name) { a.directions.push_back(direction_named(name)); }},
            text("--pictures FOLDER",
                 "each drawing with bare border, red in it, or bare jumps of depth, orange",
                 a.pictures),
            number("--most-bare PERCENT", "fails where more of all borders is bare", a.most_bare)};
}

DrawingSetup setup_of(const laplacian_lines::TriangleMesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const laplacian_lines::Triangle& triangle : mesh.triangles)
        for (const std::uint32_t v : triangle)
            if (mesh.positions[v].allFinite()) box.extend(mesh.positions[v]);
    if (!(box.diagonal().norm() > 0)) throw std::runtime_error("the mesh has no size");
    return {drawn_size / box.diagonal().norm(), box.center()};
}

struct Row {
    std::string name, worst_view;
    std::size_t views = 0, whole_views = 0;
    double least_share = 1;
    SilhouetteScores sum;
};

void print(const Row& row) {
    std::printf("| %s | %zu | %zu | %zu | %zu | %.4f | %s | %zu | %zu |\n", row.name.c_str(),
                row.views, row.sum.border, row.sum.bare_border, row.whole_views, row.least_share,
                row.worst_view.c_str(), row.sum.jumps, row.sum.bare_jumps);
    std::fflush(stdout);
}

class Measuring {
public:
    explicit Measuring(const Arguments& arguments) : arguments_(arguments) {}

    void add(const SilhouetteMesh& entry) {
        if (entry.name.find(arguments_.only) == std::string::npos) return;
        std::fprintf(stderr, "drawing %s\n", entry.name.c_str());
        try {
            rows.push_back(row_of(entry));
            print(rows.back());
        } catch (const std::exception& error) {
            std::fprintf(stderr, "drawing_silhouettes: %s: %s\n", entry.name.c_str(), error.what());
            failed = true;
        }
    }

    std::vector<Row> rows;
    bool failed = false;

private:
    Row row_of(const SilhouetteMesh& entry) const {
        const std::vector<NamedFrame>& directions = arguments_.directions;
        const laplacian_lines::TriangleMesh mesh = entry.make();
        const DrawingSetup setup = setup_of(mesh);
        std::vector<PlaneFrame> frames;
        for (const NamedFrame& direction : directions)
            frames.push_back(direction.frame);
        const std::vector<DrawnPaths> drawn = drawings_of(mesh, frames, setup);
        Row row;
        row.name = entry.name;
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            const ItemBuffer items(mesh, frames[i], setup);
            BarePlaces bare;
            const SilhouetteScores scores = score_silhouette(items, drawn[i], &bare);
            ++row.views;
            row.whole_views += scores.share() >= whole_share;
            if (scores.share() <= row.least_share) row.worst_view = directions[i].name;
            row.least_share = std::min(row.least_share, scores.share());
            row.sum.add(scores);
            if (!arguments_.pictures.empty() && !(bare.border.empty() && bare.jumps.empty()))
                write_picture(entry.name + " " + directions[i].name, items, drawn[i], bare);
        }
        return row;
    }
    void write_picture(const std::string& name, const ItemBuffer& items, const DrawnPaths& drawing,
                       const BarePlaces& bare) const {
        PlaneCanvas canvas({items.place(0, 0), items.place(items.width(), items.height())});
        for (const PlanePoint& p : items.border())
            canvas.dot(p, QColor(190, 220, 190));
        canvas.draw(lines_of(drawing), Qt::black, 1);
        for (const PlanePoint& p : bare.jumps)
            canvas.dot(p, QColor(255, 140, 0));
        for (const PlanePoint& p : bare.border)
            canvas.dot(p, Qt::red);
        canvas.save(
            QString::fromStdString(arguments_.pictures + "/" + name + ".png").replace(' ', '_'));
    }

    const Arguments& arguments_;
};

Row sum_of(const std::vector<Row>& rows) {
    Row all;
    all.name = "all";
    for (const Row& row : rows) {
        all.views += row.views;
        all.whole_views += row.whole_views;
        if (row.least_share < all.least_share) all.worst_view = row.name;
        all.least_share = std::min(all.least_share, row.least_share);
        all.sum.add(row.sum);
    }
    return all;
}

bool run(Arguments& arguments, const std::vector<std::string>& files) {
    std::printf(
        "| mesh | views | border | without a line within .15 mm | views with .995 of it within .8 "
        "mm | least share | from | jumps of depth | without a line |\n"
        "|---|--:|--:|--:|--:|--:|---|--:|--:|\n");
    if (arguments.directions.empty()) arguments.directions = few_directions();
    Measuring measuring(arguments);
    std::vector<SilhouetteMesh> meshes = silhouette_meshes();
    for (const std::string& file : files)
        for (const SilhouetteMesh& mesh : scans_of(file))
            meshes.push_back(mesh);
    for (const SilhouetteMesh& mesh : meshes)
        measuring.add(mesh);
    if (measuring.rows.empty()) throw std::invalid_argument("no mesh is named " + arguments.only);
    const Row all = sum_of(measuring.rows);
    print(all);
    const double bare =
        all.sum.border ? 100. * double(all.sum.bare_border) / double(all.sum.border) : 0;
    const bool keeps = bare <= arguments.most_bare;
    if (!keeps) std::fprintf(stderr, "drawing_silhouettes: %.3f %% of borders are bare\n", bare);
    return keeps && !measuring.failed;
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    return run_program(argc, argv, "[MESH...]", options_of(arguments),
                       [&](const auto& files) { return run(arguments, files); });
}
