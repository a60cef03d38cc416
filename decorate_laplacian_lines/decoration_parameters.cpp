// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_parameters.h"

#include <algorithm>

#include "decoration_table.h"
#include "laplacian_lines/error.h"
#include "laplacian_lines/option_table.h"
#include "meshlab_host/parameters.h"

namespace {

/// Calls the visitor with each row and its label, below the heading of its group.
template <class Visitor>
void visitRows(const Visitor& visitor) {
    for (const ParameterGroup& group : decorationTable())
        for (const ParameterRow& any : group.rows)
            std::visit(
                [&](const auto& row) {
                    const bool opens_group = group.heading && &any == &group.rows.front();
                    visitor.visit(row, opens_group
                                           ? meshlab_host::underHeading(group.heading, row.label)
                                           : QString(row.label));
                },
                any);
}

struct Lister {
    RichParameterList& list;

    template <class Options>
    void visit(const laplacian_lines::OptionDescription<Options>& row, const QString& label) const {
        meshlab_host::ParameterDescription description =
            meshlab_host::describe(row, decoration_prefix);
        description.label = label;
        description.for_experts = false;  // the panel hides it, in all versions alike
        meshlab_host::addParameter(description, row.get(Options()), 0, list);
    }
    void visit(const ColorRow& row, const QString& label) const {
        DecorationParameters defaults;
        list.addParam(RichColor(decoration_prefix + QString(row.key), row.color(defaults), label,
                                meshlab_host::toolTip(row.help)));
    }
};

struct Describer {
    std::vector<DecorationField>& fields;

    template <class Row>
    void visit(const Row& row, const QString& label) const {
        fields.push_back({row.key, label, meshlab_host::toolTip(row.help), row.for_experts});
    }
};

struct Reader {
    ValidParameters& result;
    const RichParameterList& list;
    const DecorationParameters& last_time;

    template <class Parameters>
    static auto& options(const DecorationRow&, Parameters& of) {
        return of;
    }
    template <class Parameters>
    static auto& options(const StyleRow&, Parameters& of) {
        return of.style;
    }

    template <class Options>
    void visit(const laplacian_lines::OptionDescription<Options>& row, const QString&) const {
        Options& read = options(row, result.as_set);
        const meshlab_host::ParameterDescription parameter =
            meshlab_host::describe(row, decoration_prefix);
        try {
            row.set(read, meshlab_host::readParameter(parameter, row.get(read), list));
        } catch (const laplacian_lines::Error& error) {
            const double value = row.get(options(row, last_time));
            row.set(read, value);
            result.refused[row.key] =
                QString("%1 Until then it stays %2.").arg(error.what(), textOf(value, parameter));
        }
    }
    void visit(const ColorRow& row, const QString&) const {
        QColor& color = row.color(result.as_set);
        color = meshlab_host::readColor(decoration_prefix + QString(row.key), color, list);
    }
};

/// White on paper of another color.
QColor shadeOf(const QColor& paper) {
    const QColor of_white = line_renderer::SurfaceAppearance().shade;
    const auto share = [](int channel, int of_paper) { return channel * of_paper / 255; };
    return {share(of_white.red(), paper.red()), share(of_white.green(), paper.green()),
            share(of_white.blue(), paper.blue())};
}

void putMixtureIntoEffect(DecorationParameters& parameters) {
    const laplacian_lines::LineMixture* mixture = mixtureOf(parameters);
    if (!mixture) return;
    parameters.style.shows = mixture->kinds;
    parameters.lines.colored = mixture->colored;
}

void putIntoEffect(DrawingStyle style, DecorationParameters& parameters) {
    if (style == DrawingStyle::Custom) return;
    for (const auto& kind : laplacian_lines::line_kinds)
        if (!keepsColor(kind.kind, parameters))
            parameters.appearance.looks[std::size_t(kind.kind)].color = Qt::black;
    parameters.surface.style = line_renderer::SurfaceAppearance::Paper;
    parameters.surface.paper = Qt::white;
    parameters.background = Background::Paper;
    parameters.light =
        style == DrawingStyle::Archaeology ? Light::FixedToTheCamera : Light::AtTheEye;
}

DecorationParameters inEffect(DecorationParameters parameters) {
    putMixtureIntoEffect(parameters);
    parameters.surface.shade = shadeOf(parameters.surface.paper);
    // Invisible contours must not push other lines aside.
    if (parameters.lines.outline_factor == 0)
        parameters.style.shows[laplacian_lines::LineKind::Contour] = false;
    parameters.appearance.looks = looksOf(parameters.lines);
    putIntoEffect(parameters.drawing_style, parameters);
    return parameters;
}

}  // namespace

void listDecorationParameters(RichParameterList& list) {
    visitRows(Lister{list});
}

std::vector<DecorationField> decorationFields() {
    std::vector<DecorationField> fields;
    visitRows(Describer{fields});
    return fields;
}

const laplacian_lines::LineMixture* mixtureOf(const DecorationParameters& parameters) {
    if (parameters.mixture == as_switched) return nullptr;
    return &laplacian_lines::line_mixtures.at(std::size_t(parameters.mixture - 1));
}

bool keepsColor(laplacian_lines::LineKind kind, const DecorationParameters& parameters) {
    const laplacian_lines::LineMixture* mixture = mixtureOf(parameters);
    const auto in_colors = laplacian_lines::kinds_with_key_color();
    return mixture && mixture->colored == in_colors && in_colors[kind];
}

ValidParameters readValidParameters(const RichParameterList& list,
                                    const DecorationParameters& last_time) {
    ValidParameters result;
    visitRows(Reader{result, list, last_time});
    result.chosen = inEffect(result.as_set);
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
