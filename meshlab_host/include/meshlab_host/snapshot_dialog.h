// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <utility>

namespace meshlab_host {

/// Watches MeshLab's snapshot dialog: the next redraw is that of a snapshot, which a snapshot of
/// one tile does not show otherwise. GUI thread only.
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
