// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "geometry_check.h"
#include "prepared_lines.h"

/// Who uses which prepared lines. Lines are found by content, so that two views, or two layers with
/// the same geometry, share them, as long as someone uses or keeps them (KeptLines). MeshLab ends
/// and starts a decoration at every occasion: what is released stays findable until control is back
/// in the event loop. GUI thread only.
class LineCache {
public:
    using View = const void*;  ///< a name, never followed

    /// Lines with this key, or null.
    PreparedLinesPointer find(const meshlab_host::FieldKey& key) const;

    /// The lines that `mesh` uses in `view`, or null.
    PreparedLinesPointer at(View view, int mesh) const;
    void assign(View view, int mesh, PreparedLinesPointer lines);

    /// Whether the geometry of a mesh with lines has to be compared with theirs in this redraw, of
    /// `widget`, with this modelview matrix.
    bool isCheckDue(View view, int mesh, const Eigen::Matrix4d& modelview, QWidget* widget);

    void release(View view, int mesh);
    void releaseView(View view);
    /// Releases all meshes of the view that are not in `alive` (ascending ids).
    void releaseAllBut(View view, const std::vector<int>& alive);
    /// A mesh of the view is gone, nobody knows which one: releases those that are not assigned
    /// again before control returns to the event loop. For MeshLab's refresh, which starts all
    /// decorated meshes of a view anew.
    void releaseUnlessAssigned(View view);

private:
    using User = std::pair<View, int>;
    struct Use {
        PreparedLinesPointer lines;
        unsigned turn;  ///< of the event loop, when they were assigned
        GeometryCheck check;
    };
    using Uses = std::map<User, Use>;

    Uses::iterator retire(Uses::iterator use);
    template <class Condition>
    void retireIf(View view, Condition condition);
    void endTurnSoon();
    void endTurn();

    Uses uses_;
    std::map<meshlab_host::FieldKey, std::weak_ptr<PreparedLines>> known_;
    std::vector<PreparedLinesPointer> retired_;
    std::set<View> unsure_views_;
    PressCount presses_;
    unsigned turn_ = 0;
    bool turn_end_is_due_ = false;
    QObject receiver_;  ///< of the end of the turn; destroyed first
};
