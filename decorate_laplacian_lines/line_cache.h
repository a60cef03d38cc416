// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstddef>
#include <list>
#include <map>
#include <memory>
#include <set>
#include <vector>

#include "geometry_check.h"
#include "prepared_lines.h"

/// The prepared lines of each layer in each view. They are found by content: views, and layers of
/// the same geometry, share them while they are in use or cached (KeptLines). MeshLab restarts
/// decorations all the time, so released lines can be found until control returns to the event
/// loop. GUI thread only.
class LineCache {
public:
    using View = const void*;  ///< a key, never dereferenced

    /// Both return null if there are none.
    PreparedLinesPointer find(const meshlab_host::FieldKey& key) const;
    PreparedLinesPointer at(View view, int mesh) const;
    void assign(View view, int mesh, PreparedLinesPointer lines);

    /// Whether to compare the mesh's geometry with its lines' in this redraw of `widget`.
    bool is_check_due(View view, int mesh, const Eigen::Matrix4d& modelview, QWidget* widget);

    void release(View view, int mesh);
    void release_view(View view);
    /// `alive` are ascending ids.
    void release_all_but(View view, const std::vector<int>& alive);
    /// An unknown mesh of the view is gone: releases those not assigned again before control
    /// returns to the event loop. MeshLab's refresh restarts all decorated meshes of a view.
    void release_unless_assigned(View view);

private:
    struct Use {
        PreparedLinesPointer lines;
        unsigned turn;  ///< of the event loop, when they were assigned
        GeometryCheck check;
    };
    using Uses = std::map<std::pair<View, int>, Use>;  ///< by view and mesh

    Uses::iterator retire(Uses::iterator use);
    template <class Condition>
    void retire_if(View view, Condition condition);
    void end_turn_soon();
    void end_turn();

    Uses uses_;
    std::map<meshlab_host::FieldKey, std::weak_ptr<PreparedLines>> known_;
    std::vector<PreparedLinesPointer> retired_;
    std::set<View> unsure_views_;
    PressCount presses_;
    unsigned turn_ = 0;
    bool turn_end_is_due_ = false;
    QObject receiver_;  ///< of the end of the turn; destroyed first
};

/// Each mesh's last lines, so that switching them off and on computes nothing; the least recently
/// used go, over all documents, beyond `most_bytes`. GUI thread only.
class KeptLines {
public:
    using Document = const void*;  ///< a key, never dereferenced

    explicit KeptLines(std::size_t most_bytes = usual_bytes()) : most_bytes_(most_bytes) {}
    /// A quarter of this machine's memory.
    static std::size_t usual_bytes();

    /// The mesh uses these lines alone. Lines that lacked memory are not kept.
    void keep(Document document, int mesh, PreparedLinesPointer lines);
    /// `alive` are ascending ids.
    void forget_all_but(Document document, const std::vector<int>& alive);
    /// Frees all, for those who lack memory. False if there was nothing.
    bool drop();

    /// Lines that are shared count once.
    std::size_t bytes() const;

private:
    struct Entry {
        Document document;
        int mesh;
        PreparedLinesPointer lines;
    };

    const std::size_t most_bytes_;
    std::list<Entry> entries_;  ///< the one used last comes first
};
