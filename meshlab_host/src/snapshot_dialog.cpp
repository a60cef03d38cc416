// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshlab_host/snapshot_dialog.h"

#include <QCoreApplication>
#include <QEvent>

namespace meshlab_host {

SnapshotDialog::SnapshotDialog() {
    if (QCoreApplication* program = QCoreApplication::instance()) program->installEventFilter(this);
}

bool SnapshotDialog::eventFilter(QObject* receiver, QEvent* event) {
    has_closed_ |= event->type() == QEvent::Hide && receiver->inherits("SaveSnapshotDialog");
    return QObject::eventFilter(receiver, event);
}

}  // namespace meshlab_host
