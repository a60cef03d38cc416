// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/snapshot_dialog.h"

#include <QCoreApplication>
#include <QDialog>
#include <QEvent>

namespace meshlab_host {

SnapshotDialog::SnapshotDialog() {
    if (QCoreApplication* program = QCoreApplication::instance()) program->installEventFilter(this);
}

bool SnapshotDialog::eventFilter(QObject* receiver, QEvent* event) {
    if (event->type() == QEvent::Show && receiver->inherits("SaveSnapshotDialog"))
        connect(static_cast<QDialog*>(receiver), &QDialog::accepted, this,
                [this] { is_accepted_ = true; });
    return QObject::eventFilter(receiver, event);
}

}  // namespace meshlab_host
