// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>
#include <QString>
#include <vector>

class QTreeWidget;

namespace meshlab_host {

/// What the panel shows of a parameter.
struct PanelField {
    QString label;  ///< as MeshLab was told, which is how it is found
    QString help;   ///< tool tip, HTML
    bool is_shown = true;
    QString obstacle;  ///< why its value has no effect now, a sentence; empty if it has one
    QString fault;     ///< what is wrong with its value, likewise

    bool operator==(const PanelField& other) const;
};
using PanelLine = std::vector<PanelField>;  ///< fields side by side, one or two

/// The panel of a decoration's parameters in MeshLab's layer dialog. MeshLab makes it a list with a
/// line for each parameter; this puts short ones side by side, hides or switches off what is not
/// needed now, marks what is wrong, lets numbers have a decimal comma, and keeps the dialog from
/// getting higher than its window. A panel that is not found or has not all of the fields is left
/// as it is. GUI thread only.
class ParameterPanel : public QObject {
public:
    explicit ParameterPanel(QString decoration) : decoration_(std::move(decoration)) {}

    /// From now on, also when MeshLab makes the panel anew; done when control is back in the event
    /// loop, because MeshLab may be working on it now. Costs nothing if nothing has changed.
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
