// SPDX-License-Identifier: GPL-3.0-or-later
#include "decoration_parameters.h"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "decoration_table.h"
#include "laplacian_lines/line_mixture.h"

using laplacian_lines::LineKind;
using laplacian_lines::LineKindSet;
using laplacian_lines::only_kinds;
using line_renderer::SurfaceAppearance;
using meshlab_host::PanelField;
using meshlab_host::PanelLine;

namespace {

using Keys = std::vector<std::string>;

/// What comes first, side by side; the others follow, one a line.
const std::vector<Keys> first_lines = {
    {"drawing_style"},
    {"detail", "line_width"},
    {"line_color", "contour_color"},
    {"hidden_lines", "scale"},
    {"lines"},
    {"parameters"},
    {"contours", "laplacian_lines"},
    {"single_strokes", "ridges"},
    {"creases", "borders"},
    {"ridge_angle", "crease_angle"},
};

constexpr LineKindSet shaded = only_kinds({LineKind::Laplacian, LineKind::PhoticExtremum});
constexpr LineKindSet zeros =
    shaded | only_kinds({LineKind::SuggestiveContour, LineKind::SuggestiveHighlight,
                         LineKind::ApparentRidge});

/// Parameters of some kinds of lines only.
const std::map<std::string, LineKindSet> kinds_of_parameters = {
    {"scale", only_kinds({LineKind::Laplacian})},
    {"full_slope", only_kinds({LineKind::Laplacian})},
    {"single_strokes", shaded},
    {"gradient_threshold", shaded},
    {"strength_threshold", shaded},
    {"light", shaded},
    {"light_azimuth", shaded},
    {"light_elevation", shaded},
    {"whole_lines", zeros},
    {"ridge_angle", only_kinds({LineKind::Ridge, LineKind::Valley})},
    {"crease_angle", only_kinds({LineKind::Crease})},
    {"contour_color", only_kinds({LineKind::Contour, LineKind::Border})},
    {"highlight_color", only_kinds({LineKind::SuggestiveHighlight})}};

bool isOfNoneShown(const std::string& key, const DecorationParameters& chosen) {
    const auto found = kinds_of_parameters.find(key);
    return found != kinds_of_parameters.end() &&
           std::none_of(laplacian_lines::line_kinds.begin(), laplacian_lines::line_kinds.end(),
                        [&](const laplacian_lines::LineKindDescription& row) {
                            return found->second[row.kind] && chosen.style.shows[row.kind];
                        });
}

QString obstacleOf(const std::string& key, const DecorationParameters& chosen) {
    if (isOverridden(key, chosen)) return overrideOf(key)->sentence;
    if (isOfNoneShown(key, chosen)) return "None of the lines that are shown depend on it.";
    if (chosen.surface.style != SurfaceAppearance::Toon && key == "tones")
        return "Only for the surface Toon.";
    if (chosen.light != Light::FixedToTheCamera &&
        (key == "light_azimuth" || key == "light_elevation"))
        return "Only for the light that is fixed to the camera.";
    return {};
}

PanelField panelField(const DecorationField& field, const ValidParameters& parameters) {
    const auto refused = parameters.refused.find(field.key);
    if (refused != parameters.refused.end())
        return {field.label, field.help, true, {}, refused->second};
    const DecorationParameters& chosen = parameters.chosen;
    const bool is_shown = !field.for_experts || chosen.shown == ShownParameters::All;
    return {field.label, field.help, is_shown, obstacleOf(field.key, chosen), {}};
}

/// Removes the field from the list.
DecorationField take(const std::string& key, std::vector<DecorationField>& fields) {
    for (auto field = fields.begin(); field != fields.end(); ++field)
        if (field->key == key) {
            const DecorationField taken = *field;
            fields.erase(field);
            return taken;
        }
    throw std::logic_error("the decoration has no parameter " + key);
}

}  // namespace

std::vector<PanelLine> panelLines(const ValidParameters& parameters) {
    std::vector<DecorationField> fields = decorationFields();
    std::vector<PanelLine> lines;
    for (const Keys& keys : first_lines) {
        lines.emplace_back();
        for (const std::string& key : keys)
            lines.back().push_back(panelField(take(key, fields), parameters));
    }
    for (const DecorationField& field : fields)
        lines.push_back({panelField(field, parameters)});
    return lines;
}
