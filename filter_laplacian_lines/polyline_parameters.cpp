// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyline_parameters.h"

#include <QColor>
#include <vector>

#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/option_rows.h"
#include "line_drawing/sheet_choices.h"
#include "meshlab_host/parameters.h"

namespace {

using Parameters = PolylineParameters;
using laplacian_lines::OptionKind;
namespace rows = laplacian_lines::option_rows;

constexpr double kLargestBox = 1e15;  // the largest D of the core, see ErrorCode::InvalidMesh

std::vector<const char*> view_names() {
    std::vector<const char*> names = {"Current View of the Window",
                                      "Perspective, from the Viewpoint",
                                      "Orthographic, along the View Direction"};
    for (const char* side : line_drawing::kSideNames)
        names.push_back(side);
    return names;
}

/// In the order of the dialog.
const std::vector<laplacian_lines::OptionRow<Parameters>>& table() {
    static const std::vector<laplacian_lines::OptionRow<Parameters>> table = {
        rows::choice<&Parameters::view>(
            "view", "View", view_names(),
            "From where the lines are seen: as in the window, which scripts do not have; from the "
            "viewpoint or the direction below; or from one side of the object, orthographic, as in "
            "MeshLab's menu: Front looks along -z with y upward."),
        rows::vector(&Parameters::viewpoint, "viewpoint", "Viewpoint", OptionKind::Position,
                     "Position of the eye, for perspective views. Get: View Pos. takes that of the "
                     "window."),
        rows::vector(&Parameters::view_direction, "view_direction", "View Direction",
                     OptionKind::Direction,
                     "From the object to the viewer, for orthographic views. Get: View Dir. takes "
                     "that of the window."),
        rows::choice<&Parameters::settings>(
            "settings", "Settings", line_drawing::settings_names({"Defaults", "As the Decoration"}),
            "As the Decoration: lines, hidden lines, light and colors as the decoration Laplacian "
            "Lines has drawn them last in a window, Detail included. The others: lines of these "
            "kinds, with the outlines."),
        rows::boolean<&Parameters::visible_only>(
            "visible_only", "Visible Lines Only",
            "The strokes of a drawing. Off: all lines as they are found, also those that this "
            "layer's own surface hides."),
        rows::real<&Parameters::style, &laplacian_lines::LineStyle::detail>(
            "detail", "Detail", 0, 100,
            "0 to 100: more or fewer lines of all kinds, of finer or coarser forms; 50 is the "
            "usual."),
    };
    return table;
}

void take_from_mixture(const laplacian_lines::LineMixture& mixture, Parameters& parameters) {
    parameters.style.shows = mixture.kinds;
    for (const auto& kind : laplacian_lines::kLineKinds)
        parameters.colors[std::size_t(kind.kind)] =
            QColor(mixture.colored[kind.kind] ? kind.key_color : 0).rgb();
}

void take_from_decoration(Parameters& parameters) {
    const meshlab_host::DrawnStyle drawn = meshlab_host::require_drawn_style();
    parameters.style = drawn.style;
    parameters.visible_only = !drawn.shows_hidden;
    parameters.light_azimuth = drawn.light_azimuth;
    parameters.colors = drawn.colors;
}

/// MeshLab's box, without vertices that are not finite or farther from zero than kLargestBox.
vcg::Box3d usable_box(const MeshModel& mesh) {
    vcg::Box3d box = vcg::Box3d::Construct(mesh.cm.bbox);
    if (box.IsNull() || box.Diag() < kLargestBox) return box;
    box.SetNull();
    for (const CVertexO& vertex : mesh.cm.vert) {
        const auto p = vcg::Point3d::Construct(vertex.cP());
        if (!vertex.IsD() && p.Norm() < kLargestBox) box.Add(p);
    }
    return box;
}

}  // namespace

PolylineParameters polyline_defaults(const MeshModel* mesh,
                                     const std::optional<meshlab_host::CurrentView>& window) {
    Parameters result;
    if (window) {
        result.view = ViewChoice::CurrentView;
        result.viewpoint = window->eye;
        result.view_direction = window->towards_viewer;
    } else if (mesh) {
        vcg::Box3d box;  // in world coordinates
        box.Add(vcg::Matrix44d::Construct(mesh->cm.Tr), usable_box(*mesh));
        if (!box.IsNull()) {
            const auto centre = Point3m::Construct(box.Center());
            result.viewpoint = Eigen::Vector3d(double(centre[0]), double(centre[1]),
                                               double(centre[2]) + 1.5 * box.Diag());
        }
    }
    return result;
}

void list_polyline_parameters(const PolylineParameters& defaults, RichParameterList& list) {
    for (const auto& row : table())
        meshlab_host::add_parameter(row, row.value(defaults), list);
}

PolylineParameters read_polyline_parameters(const RichParameterList& list) {
    Parameters result;
    for (const auto& row : table())
        meshlab_host::read_parameter(row, result, list);
    if (result.settings == line_drawing::kSettingsOfDecoration) take_from_decoration(result);
    if (const auto* mixture = line_drawing::mixture_at(result.settings))
        take_from_mixture(*mixture, result);
    return result;
}
