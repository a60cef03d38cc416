// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "meshlab_host/meshlab_api.h"

namespace meshlab_host {

/// Takes the camera that a GL view sends. The signal's signature is the same in all versions.
class ShotReceiver : public QObject {
    Q_OBJECT

public:
    /// Asks a GL view; empty if it does not answer.
    static std::optional<Shotm> ask(QObject& view);

public slots:
    void receive(QString name, Shotm shot);

private:
    std::optional<Shotm> shot_;
};

}  // namespace meshlab_host
