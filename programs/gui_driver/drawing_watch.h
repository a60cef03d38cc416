// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <map>

#include "core_lines.h"

namespace driver {

/// Looks at every drawing of the decoration Laplacian Lines: it must leave OpenGL's state and the
/// mesh as they were, and draw the lines that CoreLines says, or none where there can be none. The
/// driver is a plugin beside the decoration, so its signals reach it.
class DrawingWatch : public QObject {
    Q_OBJECT
public:
    /// @throws CommandError if the decoration is not there or has no such signals
    DrawingWatch();

    /// What was wrong since the last call.
    QStringList takeProblems();
    /// Whether there was a drawing since takeDrawn(), and nothing wrong in the latest one.
    bool endsWell() const { return !drawn_.empty() && latest_problems_.isEmpty(); }
    /// Meshes drawn since the last call, by id; with label and reason if drawn without lines.
    std::map<int, QString> takeDrawn();
    /// The kernels of the latest drawing; empty if there was none.
    const std::vector<laplacian_lines::DrawnKernel>& kernels() const { return kernels_; }
    /// For people: how much has been watched since the start.
    QString summary() const;
    int comparisons() const { return comparisons_; }

private slots:
    void drawingBegins(const MeshModel& mesh);
    void drawingEnds(const MeshModel& mesh, const DecorationParameters& drawn,
                     const std::vector<laplacian_lines::DrawnKernel>& kernels,
                     const laplacian_lines::LineSet* lines, const QString& refusal);

private:
    void complain(const MeshModel& mesh, const QString& what);
    void compare(const MeshModel& mesh, const DecorationParameters& drawn,
                 const std::vector<laplacian_lines::DrawnKernel>& kernels,
                 const laplacian_lines::LineSet& lines);
    void justify(const MeshModel& mesh, const DecorationParameters& drawn, const QString& refusal);

    CoreLines core_;
    QString gl_state_, mesh_state_;  ///< when the drawing began
    QStringList problems_, latest_problems_;
    std::map<int, QString> drawn_;
    std::vector<laplacian_lines::DrawnKernel> kernels_;
    int comparisons_ = 0, refusals_ = 0;
    long lines_ = 0;
};

}  // namespace driver
