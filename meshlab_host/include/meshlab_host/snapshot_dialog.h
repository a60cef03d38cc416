// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <utility>

namespace meshlab_host {

/// Watches MeshLab's snapshot dialog: the redraw after it was accepted is that of a snapshot, which
/// one of one tile does not show otherwise. GUI thread only.
class SnapshotDialog : public QObject {
public:
    SnapshotDialog();

    /// Whether it was accepted since the last call.
    bool take_accepted() { return std::exchange(is_accepted_, false); }

protected:
    bool eventFilter(QObject* receiver, QEvent* event) override;

private:
    bool is_accepted_ = false;
};

}  // namespace meshlab_host
