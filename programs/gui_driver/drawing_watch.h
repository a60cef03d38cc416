// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QStringList>
#include <map>

#include "core_lines.h"

namespace driver {

/// Checks every drawing of the decoration by its signals: it must leave OpenGL's state and the mesh
/// alone, and draw the lines of CoreLines, or none where there can be none.
class DrawingWatch : public QObject {
    Q_OBJECT
public:
    /// @throws CommandError if there is no decoration with such signals
    DrawingWatch();

    /// Problems since the last call.
    QStringList takeProblems();
    /// Whether something was drawn since takeDrawn(), the last time without problems.
    bool endsWell() const { return !drawn_.empty() && latest_problems_.isEmpty(); }
    /// Meshes drawn since the last call, by id; with label and reason where there were no lines.
    std::map<int, QString> takeDrawn();
    /// Of the last drawing; empty if there was none.
    const std::vector<laplacian_lines::DrawnKernel>& kernels() const { return kernels_; }
    /// For people: how much was watched.
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
