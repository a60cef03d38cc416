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

/// Of the names of all parameters, which are then unique among MeshLab's plugins.
inline const QString decoration_prefix = "MeshLab::Decoration::LaplacianLines_";

/// A choice of looks by one parameter, which then counts more than the others it stands for.
enum class DrawingStyle { Custom, Publication, Archaeology };

/// The kinds of lines are those that are switched on; otherwise a mixture says which.
constexpr int as_switched = 0;

/// What is seen where no surface is.
enum class Background { AsMeshLabDrawsIt, Paper };

/// Which parameters the layer dialog shows.
enum class ShownParameters { Basic, All };

/// At which size lines show the form: that of the field as it was computed, or one that follows
/// the size of the surface in the view.
enum class Scale { AsComputed, WithTheView };

enum class Light { AtTheEye, FixedToTheCamera };

/// What the user chose in MeshLab's decoration parameters, which are the same for all views.
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

/// Adds all parameters with their defaults, in the order in which MeshLab shows them: what
/// everybody uses first.
void listDecorationParameters(RichParameterList& list);

/// How a parameter appears in that list.
struct DecorationField {
    const char* key;
    QString label;  ///< with the heading of the group that it opens
    QString help;   ///< tool tip
    bool for_experts;
};
std::vector<DecorationField> decorationFields();

/// Null if the kinds are as switched.
const laplacian_lines::LineMixture* mixtureOf(const DecorationParameters& parameters);

/// Drawing style and mixture are already put into effect in what they stand for.
/// Parameters that are out of range have the values of the last time.
struct ValidParameters {
    DecorationParameters chosen;
    DecorationParameters as_set;             ///< without drawing style and mixture put into effect
    std::map<std::string, QString> refused;  ///< what is wrong, by key of those out of range
};
ValidParameters readValidParameters(const RichParameterList& list,
                                    const DecorationParameters& last_time = {});

/// What of it filters can do as well.
meshlab_host::DrawnStyle drawnStyleOf(const DecorationParameters& parameters);
