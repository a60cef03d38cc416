// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <utility>

namespace meshlab_host {

/// Tells that MeshLab's next redraw is of a snapshot, which no redraw of one tile says itself. GUI
/// thread only.
class SnapshotDialog : public QObject {
public:
    SnapshotDialog();

    /// Whether it has closed since the last call.
    bool has_closed() { return std::exchange(has_closed_, false); }

protected:
    bool eventFilter(QObject* receiver, QEvent* event) override;

private:
    bool has_closed_ = false;
};

}  // namespace meshlab_host
