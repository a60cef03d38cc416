// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "laplacian_lines/line_mixture.h"
#include "laplacian_lines/line_style.h"
#include "line_choice.h"
#include "line_renderer/line_appearance.h"
#include "line_renderer/surface_renderer.h"
#include "meshlab_host/camera.h"
#include "meshlab_host/drawn_style.h"
#include "meshlab_host/meshlab_api.h"
#include "meshlab_host/parameter_panel.h"

/// Makes names unique among MeshLab's plugins.
inline const QString decoration_prefix = "MeshLab::Decoration::LaplacianLines_";

/// Looks chosen by one parameter, which overrides those it stands for.
enum class DrawingStyle { Custom, Publication, Archaeology };

/// The switches of kinds count; otherwise a mixture does.
constexpr int as_switched = 0;

enum class Background { AsMeshLabDrawsIt, Paper };

enum class ShownParameters { Basic, All };

/// The kernel of the field as computed, or one that suits the size of the surface in the view.
enum class Scale { AsComputed, WithTheView };

enum class Light { AtTheEye, FixedToTheCamera };

/// MeshLab's decoration parameters, which all views share.
struct DecorationParameters {
    DrawingStyle drawing_style = DrawingStyle::Custom;
    int mixture = as_switched;  ///< of laplacian_lines::line_mixtures, counted from 1
    laplacian_lines::LineStyle style;
    LineChoice lines;
    line_renderer::LineAppearance appearance;  ///< its looks are those of `lines` and the style
    line_renderer::SurfaceAppearance surface;
    Background background = Background::AsMeshLabDrawsIt;
    Scale scale = Scale::AsComputed;
    Light light = Light::AtTheEye;
    meshlab_host::CameraLight camera_light;
    ShownParameters shown = ShownParameters::Basic;
    bool show_statistics = false;
};

/// In MeshLab's order: what everybody uses first.
void listDecorationParameters(RichParameterList& list);

struct DecorationField {
    const char* key;
    QString label;  ///< with the heading of the group that it opens
    QString help;   ///< tool tip
    bool for_experts;
};
std::vector<DecorationField> decorationFields();

/// Null if the switches count.
const laplacian_lines::LineMixture* mixtureOf(const DecorationParameters& parameters);

/// In any drawing style: the mixture tells its kinds apart by their colors.
bool keepsColor(laplacian_lines::LineKind kind, const DecorationParameters& parameters);

/// With drawing style and mixture applied. Values out of range are those of the last time.
struct ValidParameters {
    DecorationParameters chosen;
    DecorationParameters as_set;             ///< without drawing style and mixture put into effect
    std::map<std::string, QString> refused;  ///< what is wrong, by key of those out of range
};
ValidParameters readValidParameters(const RichParameterList& list,
                                    const DecorationParameters& last_time = {});

/// The part that filters can follow.
meshlab_host::DrawnStyle drawnStyleOf(const DecorationParameters& parameters);

/// The layer dialog's panel: parameters of the first hour on the first screen, others on request,
/// and disabled what has no effect, above all what a drawing style overrides. Errors can always be
/// mended.
std::vector<meshlab_host::PanelLine> panelLines(const ValidParameters& parameters);
