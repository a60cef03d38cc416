// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyline_parameters.h"

#include <QColor>
#include <variant>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/option_rows.h"
#include "line_drawing/sheet_choices.h"
#include "meshlab_host/parameters.h"

namespace {

using Parameters = PolylineParameters;
using meshlab_host::PlaceDescription;
using meshlab_host::PlaceKind;
using Row = laplacian_lines::OptionDescription<Parameters>;
namespace rows = laplacian_lines::option_rows;

constexpr double largest_box = 1e15;  // as the core has it

struct PlaceRow {
    PlaceDescription description;
    Eigen::Vector3d Parameters::*value;
};

std::vector<const char*> viewNames() {
    std::vector<const char*> names = {"Current View of the Window",
                                      "Perspective, from the Viewpoint",
                                      "Orthographic, along the View Direction"};
    for (const char* side : line_drawing::sideNames())
        names.push_back(side);
    return names;
}

/// In the order of the dialog.
const std::vector<std::variant<Row, PlaceRow>>& table() {
    static const std::vector<std::variant<Row, PlaceRow>> table = {
        rows::choice<&Parameters::view>(
            "view", "View", viewNames(),
            "From where the lines are seen: as in the window, which scripts do not have; from the "
            "viewpoint or the direction below; or from one side of the object, orthographic, as in "
            "MeshLab's menu: Front looks along -z with y upward."),
        PlaceRow{{"viewpoint", "Viewpoint",
                  "Position of the eye, for perspective views. Get: View Pos. takes that of the "
                  "window.",
                  PlaceKind::Position},
                 &Parameters::viewpoint},
        PlaceRow{{"view_direction", "View Direction",
                  "From the object to the viewer, for orthographic views. Get: View Dir. takes "
                  "that of the window.",
                  PlaceKind::Direction},
                 &Parameters::view_direction},
        rows::choice<&Parameters::settings>(
            "settings", "Settings", line_drawing::settingsNames({"Defaults", "As the Decoration"}),
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

using meshlab_host::addParameter;
using meshlab_host::readParameter;

void addParameter(const PlaceRow& row, const Parameters& defaults, RichParameterList& list) {
    meshlab_host::addPlace(row.description, defaults.*row.value, list);
}

void readParameter(const PlaceRow& row, Parameters& parameters, const RichParameterList& list) {
    Eigen::Vector3d& target = parameters.*row.value;
    target = meshlab_host::readPlace(row.description, target, list);
}

void takeFromMixture(const laplacian_lines::LineMixture& mixture, Parameters& parameters) {
    parameters.style.shows = mixture.kinds;
    for (const auto& kind : laplacian_lines::line_kinds)
        parameters.colors[std::size_t(kind.kind)] =
            QColor(mixture.colored[kind.kind] ? kind.key_color : 0).rgb();
}

void takeFromDecoration(Parameters& parameters) {
    const meshlab_host::DrawnStyle drawn = meshlab_host::demandDrawnStyle();
    parameters.style = drawn.style;
    parameters.visible_only = !drawn.shows_hidden;
    parameters.light_azimuth = drawn.light_azimuth;
    parameters.colors = drawn.colors;
}

/// MeshLab's box includes vertices that lines ignore: not finite, or far beyond the rest.
vcg::Box3d usableBox(const MeshModel& mesh) {
    vcg::Box3d box = vcg::Box3d::Construct(mesh.cm.bbox);
    if (box.IsNull() || box.Diag() < largest_box) return box;
    box.SetNull();
    for (const CVertexO& vertex : mesh.cm.vert) {
        const auto p = vcg::Point3d::Construct(vertex.cP());
        if (!vertex.IsD() && p.Norm() < largest_box) box.Add(p);
    }
    return box;
}

}  // namespace

line_drawing::ViewFrame sideView(ViewChoice choice) {
    return frameOfSide(line_drawing::Side(int(choice) - int(ViewChoice::Front)),
                       line_drawing::UpAxis::Y);
}

PolylineParameters polylineDefaults(const MeshModel* mesh,
                                    const std::optional<meshlab_host::CurrentView>& window) {
    Parameters result;
    if (window) {
        result.view = ViewChoice::CurrentView;
        result.viewpoint = window->eye;
        result.view_direction = window->towards_viewer;
    } else if (mesh) {
        const vcg::Box3d box = usableBox(*mesh);
        if (!box.IsNull()) {
            const auto middle = box.Center();
            const auto centre =
                mesh->cm.Tr * Point3m(Scalarm(middle[0]), Scalarm(middle[1]), Scalarm(middle[2]));
            result.viewpoint = Eigen::Vector3d(double(centre[0]), double(centre[1]),
                                               double(centre[2]) + 1.5 * box.Diag());
        }
    }
    return result;
}

void listPolylineParameters(const PolylineParameters& defaults, RichParameterList& list) {
    for (const auto& any : table())
        std::visit([&](const auto& row) { addParameter(row, defaults, list); }, any);
}

PolylineParameters readPolylineParameters(const RichParameterList& list) {
    Parameters result;
    for (const auto& any : table())
        std::visit([&](const auto& row) { readParameter(row, result, list); }, any);
    if (result.settings == line_drawing::settings_of_decoration) takeFromDecoration(result);
    if (const auto* mixture = line_drawing::mixtureAt(result.settings))
        takeFromMixture(*mixture, result);
    return result;
}
