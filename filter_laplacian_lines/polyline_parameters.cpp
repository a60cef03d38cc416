// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyline_parameters.h"

#include <QColor>
#include <algorithm>

#include "laplacian_lines/error.h"
#include "laplacian_lines/line_kind.h"
#include "laplacian_lines/option_rows.h"
#include "line_drawing/sheet_choices.h"

namespace {

using Parameters = PolylineParameters;
using meshlab_host::PlaceDescription;
using meshlab_host::PlaceKind;
using Row = laplacian_lines::OptionDescription<Parameters>;
namespace rows = laplacian_lines::option_rows;

const QString key_prefix;             // scripts use the keys as they are
constexpr double largest_box = 1e15;  // as the core has it

struct PlaceRow {
    PlaceDescription description;
    Eigen::Vector3d Parameters::*value;
    const Row& (*choice)();  ///< of the parameter that says whether it counts,
    int counts_at;           ///< and its value for that
};

std::vector<const char*> viewNames() {
    std::vector<const char*> names = {"Current View of the Window",
                                      "Perspective, from the Viewpoint",
                                      "Orthographic, along the View Direction"};
    for (const char* side : line_drawing::sideNames())
        names.push_back(side);
    return names;
}

Row folded(Row row) {
    row.for_experts = true;
    return row;
}

const Row& viewRow() {
    static const Row row = rows::choice<&Parameters::view>(
        "view", "View", viewNames(),
        "From where the lines are seen: as in the window, which scripts do not have; from the "
        "viewpoint or the direction below; or from one side of the object, orthographic, as in "
        "MeshLab's menu: Front looks along -z with y upward.");
    return row;
}

const Row& settingsRow() {
    static const Row row = rows::choice<&Parameters::settings>(
        "settings", "Settings", line_drawing::settingsNames({"As Set Below", "As the Decoration"}),
        "As the Decoration: lines, hidden lines, light and colors as the decoration Laplacian "
        "Lines has drawn them last, whatever is set below. Needs a window in which it has drawn. "
        "The others: lines of these kinds, whichever are switched on below, with the outlines.");
    return row;
}

const Row& visibleRow() {
    static const Row row = folded(rows::boolean<&Parameters::visible_only>(
        "visible_only", "Visible Lines Only",
        "Leave out the parts of lines that this layer's own surface hides."));
    return row;
}

const Row& lightRow() {
    static const Row row = folded(rows::choice<&Parameters::light>(
        "light", "Light Position", {"At the Eye", "Along the Light Direction"},
        "Which shading the Laplacian lines draw: that of a light at the eye, or of a distant one. "
        "Contours always follow the eye."));
    return row;
}

const PlaceRow& viewpointRow() {
    static const PlaceRow row = {
        {"viewpoint", "Viewpoint",
         "Position of the eye, for perspective views. Get: View Pos. takes that of the window.",
         PlaceKind::Position},
        &Parameters::viewpoint,
        viewRow,
        int(ViewChoice::Perspective)};
    return row;
}

const PlaceRow& viewDirectionRow() {
    static const PlaceRow row = {
        {"view_direction", "View Direction",
         "From the object to the viewer, for orthographic views. Get: View Dir. takes that of the "
         "window.",
         PlaceKind::Direction},
        &Parameters::view_direction,
        viewRow,
        int(ViewChoice::Orthographic)};
    return row;
}

const PlaceRow& lightDirectionRow() {
    static const PlaceRow row = {
        {"light_direction", "Light Direction", "From the object to the light, if that is distant.",
         PlaceKind::Direction, true},
        &Parameters::light_direction,
        lightRow,
        int(LightChoice::FromADirection)};
    return row;
}

/// The others come by mixtures, or with their thresholds from the decoration: too many for a
/// dialog.
bool isSwitchOfUsualKind(const std::string& key) {
    return std::any_of(laplacian_lines::line_kinds.begin(), laplacian_lines::line_kinds.end(),
                       [&](const auto& kind) { return kind.shown && key == kind.key; });
}

/// In the order of the dialog.
template <class Visitor>
void visitRows(Visitor& visitor) {
    visitor.visit(viewRow());
    visitor.visit(viewpointRow());
    visitor.visit(viewDirectionRow());
    visitor.visit(settingsRow());
    visitor.visit(visibleRow());
    for (const auto& row : laplacian_lines::line_style_table())
        if (!row.for_experts || isSwitchOfUsualKind(row.key)) visitor.visit(row);
    visitor.visit(lightRow());
    visitor.visit(lightDirectionRow());
}

struct Lister {
    const Parameters& defaults;
    RichParameterList& list;

    const laplacian_lines::LineStyle& options(const laplacian_lines::LineStyle*) const {
        return defaults.style;
    }
    const Parameters& options(const Parameters*) const { return defaults; }

    template <class Options>
    void visit(const laplacian_lines::OptionDescription<Options>& row) {
        meshlab_host::addParameter(meshlab_host::describe(row, key_prefix),
                                   row.get(options(static_cast<const Options*>(nullptr))), 0, list);
    }
    void visit(const PlaceRow& row) {
        meshlab_host::addPlace(row.description, defaults.*row.value, list);
    }
};

struct ParameterReader {
    Parameters& result;
    const RichParameterList& list;

    laplacian_lines::LineStyle& options(const laplacian_lines::LineStyle*) { return result.style; }
    Parameters& options(const Parameters*) { return result; }

    template <class Options>
    void visit(const laplacian_lines::OptionDescription<Options>& row) {
        Options& target = options(static_cast<const Options*>(nullptr));
        row.set(target, meshlab_host::readParameter(meshlab_host::describe(row, key_prefix),
                                                    row.get(target), list));
    }
    void visit(const PlaceRow& row) {
        Eigen::Vector3d& target = result.*row.value;
        target = meshlab_host::readPlace(row.description, target, list);
    }
};

struct Describer {
    std::vector<meshlab_host::ParameterDescription> parameters;
    std::vector<PlaceUse> places;

    template <class Options>
    void visit(const laplacian_lines::OptionDescription<Options>& row) {
        parameters.push_back(meshlab_host::describe(row, key_prefix));
    }
    void visit(const PlaceRow& row) {
        places.push_back({row.description.name, row.choice().key, row.counts_at});
    }
};

void takeFromMixture(const laplacian_lines::LineMixture& mixture, Parameters& parameters) {
    parameters.style.shows = mixture.kinds;
    for (const auto& kind : laplacian_lines::line_kinds)
        parameters.colors[std::size_t(kind.kind)] =
            QColor(mixture.colored[kind.kind] ? kind.key_color : 0).rgb();
}

void takeFromDecoration(Parameters& parameters) {
    const std::optional<meshlab_host::DrawnStyle> drawn = meshlab_host::drawnStyle();
    if (!drawn)
        laplacian_lines::refuse(
            "The decoration Laplacian Lines has drawn nothing here. Switch it on in MeshLab's "
            "window first, or set \"Settings\" to 0 (As Set Below).");
    parameters.style = drawn->style;
    parameters.visible_only = !drawn->shows_hidden;
    parameters.light = LightChoice::AtTheEye;
    parameters.camera_light = drawn->light;
    parameters.colors = drawn->colors;
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
        result.view_direction = result.light_direction = window->towards_viewer;
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
    Lister lister{defaults, list};
    visitRows(lister);
}

std::vector<meshlab_host::ParameterDescription> describePolylineParameters() {
    Describer describer;
    visitRows(describer);
    return describer.parameters;
}

std::vector<PlaceUse> polylinePlaces() {
    Describer describer;
    visitRows(describer);
    return describer.places;
}

PolylineParameters readPolylineParameters(const RichParameterList& list) {
    Parameters result;
    ParameterReader reader{result, list};
    visitRows(reader);
    if (result.settings == SettingsChoice::AsTheDecoration) takeFromDecoration(result);
    if (const auto* mixture = line_drawing::mixtureAt(int(result.settings)))
        takeFromMixture(*mixture, result);
    return result;
}
