// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_parameters.h"

#include <algorithm>

#include "decoration_table.h"
#include "laplacian_lines/option_table.h"
#include "meshlab_host/parameters.h"

namespace {

const char* const prefix = "MeshLab::Decoration::LaplacianLines_";

/// Adds the parameters of one group; its heading stands above the first that can carry it.
class GroupLister {
public:
    GroupLister(const char* heading, RichParameterList& list) : heading_(heading), list_(list) {}

    template <class Options>
    void add(const laplacian_lines::OptionDescription<Options>& row) {
        meshlab_host::ParameterDescription description = meshlab_host::describe(row, prefix);
        if (row.kind != laplacian_lines::OptionKind::Boolean)
            description.label = withHeading(description.label);
        meshlab_host::addParameter(description, row.get(Options()), 0, list_);
    }

    void add(const ColorRow& row) {
        DecorationParameters defaults;
        list_.addParam(RichColor(prefix + QString(row.key), row.color(defaults),
                                 withHeading(row.label), row.help));
    }

private:
    QString withHeading(const QString& label) {
        if (!heading_) return label;
        const QString heading = heading_;
        heading_ = nullptr;
        return meshlab_host::underHeading(heading, label);
    }

    const char* heading_;
    RichParameterList& list_;
};

void putIntoEffect(DrawingStyle style, DecorationParameters& parameters) {
    if (style == DrawingStyle::AsSetBelow) return;
    for (line_renderer::LineLook& look : parameters.appearance.looks)
        look.color = Qt::black;
    parameters.surface.style = line_renderer::SurfaceAppearance::Paper;
    parameters.surface.paper = Qt::white;
    parameters.background = Background::Paper;
    parameters.light =
        style == DrawingStyle::Archaeology ? Light::FixedToTheCamera : Light::AtTheEye;
}

}  // namespace

void listDecorationParameters(RichParameterList& list) {
    for (const ParameterGroup& group : decorationTable()) {
        GroupLister lister(group.heading, list);
        for (const DecorationRow& row : group.rows)
            lister.add(row);
        for (const auto& row : laplacian_lines::line_style_table())
            if (group.style_rows == (row.for_experts ? StyleRows::ForExperts : StyleRows::Everyday))
                lister.add(row);
        for (const ColorRow& row : group.colors)
            lister.add(row);
    }
}

DecorationParameters readDecorationParameters(const RichParameterList& list) {
    DecorationParameters result;
    result.style = meshlab_host::readOptions(laplacian_lines::line_style_table(), prefix, list);
    for (const ParameterGroup& group : decorationTable()) {
        for (const DecorationRow& row : group.rows)
            row.set(result, meshlab_host::readParameter(meshlab_host::describe(row, prefix),
                                                        row.get(result), list));
        for (const ColorRow& row : group.colors) {
            QColor& color = row.color(result);
            color = meshlab_host::readColor(prefix + QString(row.key), color, list);
        }
    }
    // contours without width must not push other lines aside
    if (result.lines.outline_factor == 0)
        result.style.shows[laplacian_lines::LineKind::Contour] = false;
    result.appearance.looks = looksOf(result.lines);
    putIntoEffect(result.drawing_style, result);
    return result;
}

meshlab_host::DrawnStyle drawnStyleOf(const DecorationParameters& parameters) {
    meshlab_host::DrawnStyle drawn;
    drawn.style = parameters.style;
    if (parameters.light == Light::FixedToTheCamera) drawn.light = parameters.camera_light;
    drawn.shows_hidden = parameters.appearance.hidden != line_renderer::HiddenLines::LeftOut;
    std::transform(parameters.appearance.looks.begin(), parameters.appearance.looks.end(),
                   drawn.colors.begin(),
                   [](const line_renderer::LineLook& look) { return look.color.rgb(); });
    return drawn;
}
