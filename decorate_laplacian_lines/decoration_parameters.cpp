// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_parameters.h"

#include <algorithm>

#include "laplacian_lines/error.h"
#include "meshlab_host/parameters.h"

namespace {

void add(const DecorationRow& row, RichParameterList& list) {
    meshlab_host::addParameter(meshlab_host::describe(row, decoration_prefix),
                               row.get(DecorationParameters()), 0, list);
}

void add(const ColorRow& row, RichParameterList& list) {
    list.addParam(RichColor(decoration_prefix + row.key, DecorationParameters().*row.color,
                            row.label, meshlab_host::toolTip(row.help)));
}

struct Reader {
    ValidParameters& result;
    const RichParameterList& list;
    const DecorationParameters& last_time;

    void operator()(const DecorationRow& row) const {
        DecorationParameters& read = result.as_set;
        const auto parameter = meshlab_host::describe(row, decoration_prefix);
        try {
            row.set(read, meshlab_host::readParameter(parameter, row.get(read), list));
        } catch (const laplacian_lines::Error& error) {
            const double value = row.get(last_time);
            row.set(read, value);
            result.refused +=
                QString("%1 Until then it stays %2.").arg(error.what(), textOf(value, parameter));
        }
    }
    void operator()(const ColorRow& row) const {
        QColor& color = result.as_set.*row.color;
        color = meshlab_host::readColor(decoration_prefix + row.key, color, list);
    }
};

/// Null if the ticks count.
const laplacian_lines::LineMixture* mixtureOf(const DecorationParameters& parameters) {
    if (parameters.mixture == as_ticked) return nullptr;
    return &laplacian_lines::line_mixtures.at(std::size_t(parameters.mixture - 1));
}

/// Kinds that a mixture tells apart by their colors have them in any drawing style if it is the
/// one that colors all.
laplacian_lines::LineKindSet coloredKinds(const DecorationParameters& parameters) {
    const laplacian_lines::LineMixture* mixture = mixtureOf(parameters);
    if (!mixture) return {};
    const bool is_in_black = parameters.drawing_style != DrawingStyle::Custom;
    const bool colors_all = mixture->colored == laplacian_lines::kinds_with_key_color();
    return is_in_black && !colors_all ? laplacian_lines::LineKindSet() : mixture->colored;
}

line_renderer::LineLooks looksOf(const DecorationParameters& parameters) {
    const laplacian_lines::LineKindSet colored = coloredKinds(parameters);
    line_renderer::LineLooks looks;
    std::transform(
        laplacian_lines::line_kinds.begin(), laplacian_lines::line_kinds.end(), looks.begin(),
        [&](const laplacian_lines::LineKindDescription& kind) {
            return line_renderer::LineLook{
                colored[kind.kind] ? QColor(kind.key_color) : parameters.line_color,
                parameters.line_width * (kind.is_outline ? parameters.outline_width : 1)};
        });
    return looks;
}

DecorationParameters inEffect(DecorationParameters parameters) {
    if (const auto* mixture = mixtureOf(parameters)) parameters.style.shows = mixture->kinds;
    if (parameters.drawing_style != DrawingStyle::Custom) {
        parameters.line_color = Qt::black;
        parameters.surface = SurfaceLook::Paper;
    }
    if (parameters.drawing_style == DrawingStyle::Publication) parameters.light = at_the_eye;
    if (parameters.drawing_style == DrawingStyle::Archaeology)
        parameters.light = std::max(parameters.light, from_the_upper_left);
    parameters.appearance.looks = looksOf(parameters);
    return parameters;
}

}  // namespace

void listDecorationParameters(RichParameterList& list) {
    for (const auto& any : decorationTable())
        std::visit([&](const auto& row) { add(row, list); }, any);
}

std::optional<double> lightAzimuth(const DecorationParameters& parameters) {
    if (parameters.light == at_the_eye) return std::nullopt;
    return 315 + 45 * (parameters.light - from_the_upper_left);
}

ValidParameters readValidParameters(const RichParameterList& list,
                                    const DecorationParameters& last_time) {
    ValidParameters result;
    for (const auto& row : decorationTable())
        std::visit(Reader{result, list, last_time}, row);
    result.chosen = inEffect(result.as_set);
    return result;
}

meshlab_host::DrawnStyle drawnStyleOf(const DecorationParameters& parameters) {
    meshlab_host::DrawnStyle drawn;
    drawn.style = parameters.style;
    drawn.light_azimuth = lightAzimuth(parameters);
    drawn.shows_hidden = parameters.appearance.hidden != line_renderer::HiddenLines::LeftOut;
    std::transform(parameters.appearance.looks.begin(), parameters.appearance.looks.end(),
                   drawn.colors.begin(),
                   [](const line_renderer::LineLook& look) { return look.color.rgb(); });
    return drawn;
}
