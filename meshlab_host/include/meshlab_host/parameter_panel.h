// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <vector>

class QTreeWidget;

namespace meshlab_host {

struct PanelField {
    QString label;  ///< as MeshLab was told, which is how it is found
    QString help;   ///< tool tip, HTML
    bool is_shown = true;
    QString obstacle;  ///< why its value has no effect now, a sentence; empty if it has one
    QString fault;     ///< what is wrong with its value, likewise

    bool operator==(const PanelField& other) const;
};
using PanelLine = std::vector<PanelField>;  ///< fields side by side, one or two

/// A decoration's panel in MeshLab's layer dialog. MeshLab lists a line per parameter; this puts
/// short ones side by side, hides or disables what is not needed, marks errors, accepts decimal
/// commas, and keeps the dialog within its window. Leaves alone a panel that is not found or lacks
/// fields. GUI thread only.
class ParameterPanel : public QObject {
public:
    explicit ParameterPanel(QString decoration) : decoration_(std::move(decoration)) {}

    /// From now on, also when MeshLab remakes the panel; done from the event loop, since MeshLab
    /// may be working on it now. Free if nothing has changed.
    void arrange(std::vector<PanelLine> lines);

protected:
    bool eventFilter(QObject* receiver, QEvent* event) override;

private:
    void arrangeSoon();
    void arrangeAll();

    QString decoration_;
    std::vector<PanelLine> lines_;
    QPointer<QTreeWidget> tree_;
    bool is_due_ = false;
};

}  // namespace meshlab_host
